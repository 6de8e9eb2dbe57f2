// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/free_body_stiffness.hpp>

#include <tegotae/lab/input_error.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <limits>

namespace tegotae {

CouplingLimits coupling_limits_for_bodies(const SceneGeometry& geometry, double physics_rate) noexcept {
  double lightest = std::numeric_limits<double>::infinity();
  for (const Body& body : geometry.bodies) {
    if (body.moving_index >= 0 && body.mass > 0.0) lightest = std::min(lightest, body.mass);
  }
  return {kStiffnessOfMass * lightest * physics_rate * physics_rate, kDampingOfMass * lightest * physics_rate};
}

SessionSettings held_to_bodies(SessionSettings settings, const SceneGeometry& geometry) noexcept {
  const CouplingLimits limits = coupling_limits_for_bodies(geometry, settings.physics_rate);
  settings.stiffness = std::min(settings.stiffness, limits.stiffness);
  settings.damping = std::min(settings.damping, limits.damping);
  if (settings.rotational_damping) {
    const double most = limits.damping * settings.metric_length * settings.metric_length;
    settings.rotational_damping = std::min(*settings.rotational_damping, most);
  }
  return settings;
}

void check_bodies_bear(std::string_view name, double value, const SceneGeometry& geometry, double physics_rate) {
  const CouplingLimits limits = coupling_limits_for_bodies(geometry, physics_rate);
  const auto refuse = [&](double most, const char* unit) {
    throw InputError(
        fmt::format("the free bodies of this scene bear a {} of at most {:g} {} with physics at {:g} Hz; "
                    "raise the physics rate first.",
                    name, most, unit, physics_rate));
  };
  if (name == "stiffness" && value > limits.stiffness) refuse(limits.stiffness, "N/m");
  if (name == "damping" && value > limits.damping) refuse(limits.damping, "N s/m");
}

}  // namespace tegotae
