// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/friction_rule.hpp>

#include <algorithm>

namespace tegotae {

SceneFriction scene_friction(const Shape& a, const Shape& b) noexcept {
  if (a.priority != b.priority) {
    const Shape& deciding = a.priority > b.priority ? a : b;
    return {deciding.friction, deciding.frictionless};
  }
  return {std::max(a.friction, b.friction), a.frictionless && b.frictionless};
}

FrictionLaw friction_law(const SceneFriction& scene, const FrictionSettings& settings) noexcept {
  FrictionLaw law;
  law.compliance = settings.compliance;
  if (scene.frictionless) return law;
  law.static_coefficient = settings.coefficient.value_or(settings.scale * scene.coefficient);
  law.kinetic_coefficient = settings.kinetic * law.static_coefficient;
  law.viscous = settings.viscous;
  return law;
}

}  // namespace tegotae
