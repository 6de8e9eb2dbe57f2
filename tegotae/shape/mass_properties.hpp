// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/shape/shape.hpp>

#include <span>

namespace tegotae {

/// Mass, centre of mass and inertia of a rigid body.
struct MassProperties {
  double mass = 0.0;                         ///< kg
  Vector3 centre_of_mass = Vector3::Zero();  ///< in the body's frame, m
  Matrix3 inertia = Matrix3::Zero();         ///< about the centre of mass, in the axes of the body's frame, kg m^2

  /// The length that makes translation and rotation commensurable: sqrt(tr I / (3 m)), m. For a cube of edge s it is
  /// s / sqrt(6).
  double gyration_length() const noexcept;
};

/// Mass properties of a bounded shape of uniform `density` (kg/m^3), in its body's frame. Closed forms, exact. A plane
/// throws std::invalid_argument.
MassProperties mass_properties(const Shape& shape, double density);

/// Of bodies rigidly joined, all given in one frame.
MassProperties combined(std::span<const MassProperties> parts);

}  // namespace tegotae
