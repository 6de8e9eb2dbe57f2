// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/render/bristle.hpp>
#include <tegotae/shape/shape.hpp>

#include <optional>

namespace tegotae {

/// How the friction of pairs is found.
struct FrictionSettings {
  std::optional<double> coefficient;  ///< of all pairs, in place of the scene's
  double scale = 1.0;                 ///< of the scene's coefficients
  double kinetic = 1.0;               ///< while slipping, as a part of the coefficient
  double viscous = 0.0;               ///< N s/m
  double compliance = 1e-9;           ///< m/N, of the bristles
};

/// Sliding friction that the scene gives a pair of surfaces.
struct SceneFriction {
  double coefficient = 0.0;
  bool frictionless = false;  ///< condim 1
};

/// MuJoCo's combination rule for two geoms: of unequal priority the one of higher priority says both; of equal priority
/// the greater coefficient, and frictionless only where both ask for it (the greater condim).
SceneFriction scene_friction(const Shape& a, const Shape& b) noexcept;

/// The law of a pair by the scene's friction and the settings. A pair that the scene makes frictionless stays so.
FrictionLaw friction_law(const SceneFriction& scene, const FrictionSettings& settings) noexcept;

}  // namespace tegotae
