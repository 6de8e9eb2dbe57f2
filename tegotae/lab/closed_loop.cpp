// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/closed_loop.hpp>

#include <tegotae/lab/static_world.hpp>

#include <memory>
#include <utility>

namespace tegotae {

SafetyLimits no_safety_limits(const SessionSettings& settings) {
  constexpr double kNever = 1e12;  // N/s, N m/s
  SafetyLimits limits = without_hand({});
  limits.period = 1.0 / settings.haptic_rate;
  limits.ramp_time = 0.0;
  limits.force_rate = limits.torque_rate = kNever;
  limits.max_force = limits.max_torque = kLargestWrench;
  limits.max_model_age = 4.0 / settings.physics_rate;
  limits.metric_length = settings.metric_length;
  return limits;
}

void run_closed_loop(const SceneGeometry& scene, const SessionSettings& settings, SimulatedHandInterface& interface,
                     double duration, const TickObserver& observer) {
  run_closed_loop(scene, settings, no_safety_limits(settings), interface, duration, observer);
}

void run_closed_loop(const SceneGeometry& scene, const SessionSettings& settings, const SafetyLimits& limits,
                     SimulatedHandInterface& interface, double duration, const TickObserver& observer) {
  StaticWorld world(scene);
  const Tool& tool = world.geometry().tool;
  const double period = 1.0 / settings.haptic_rate;
  RenderingMethod method = settings.make_method(world.geometry());
  PhysicsLoop physics(world, {1.0 / settings.physics_rate, settings.margin}, needs_of(method));
  const auto haptics = std::make_unique<HapticTick>(std::move(method), tool, limits, period, settings.workspace);
  run_simulated(physics, *haptics, interface, period, duration, observer);
}

}  // namespace tegotae
