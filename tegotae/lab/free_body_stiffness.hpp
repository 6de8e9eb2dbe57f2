// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/session_settings.hpp>

namespace tegotae {

/// The coupling that free bodies bear. A body's answer to a push comes about three periods of the physics late: pushes
/// are gathered over one, act over the next, and the pose that comes of them is interpolated over a third. A spring or
/// damper that acts late gives work to a mass, the more the greater k T^2 / m or d T / m is, with m the mass and T the
/// period. Up to these parts nothing was seen to go wrong on scenes/table.xml (docs/free-bodies.md).
inline constexpr double kStiffnessOfMass = 0.1;
inline constexpr double kDampingOfMass = 0.25;

struct CouplingLimits {
  double stiffness = 0.0;  ///< N/m
  double damping = 0.0;    ///< N s/m
};

/// By the lightest body that moves. Infinite where nothing moves or no mass is known.
CouplingLimits coupling_limits_for_bodies(const SceneGeometry& geometry, double physics_rate) noexcept;

/// The settings with no more stiffness and damping than the moving bodies bear at the physics rate.
SessionSettings held_to_bodies(SessionSettings settings, const SceneGeometry& geometry) noexcept;

/// Throws InputError where `value` (N/m or N s/m) of the setting `name` is more than the moving bodies bear at
/// `physics_rate` (Hz); other settings pass.
void check_bodies_bear(std::string_view name, double value, const SceneGeometry& geometry, double physics_rate);

}  // namespace tegotae
