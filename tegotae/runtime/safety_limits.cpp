// SPDX-License-Identifier: Apache-2.0
#include <tegotae/runtime/safety_limits.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>

namespace tegotae {
namespace {

constexpr double kModelPeriods = 3.0;          // physics periods that a model may be old
constexpr double kSchedulingAllowance = 0.01;  // s, that a busy machine may delay physics beyond them

[[noreturn]] void refuse(const char* needed, const char* name, double value) {
  throw std::invalid_argument(std::string("The safety limits need a ") + needed + " " + name + ", not " +
                              std::to_string(value) + ".");
}

void require_positive(const char* name, double value) {
  if (!(value > 0.0 && std::isfinite(value))) refuse("positive, finite", name, value);
}

// The interface's own limit, or `unknown` where it states none. Zero: it cannot display this at all.
double stated_limit(const char* name, double stated, double unknown) {
  if (!(stated >= 0.0)) refuse("not negative", name, stated);
  return std::isfinite(stated) ? stated : unknown;
}

// Damping that a rating of `stiffness` at `rate` (Hz) vouches for: K T/2; none where nothing is rated.
double vouched_damping(const char* name, double stiffness, double rate) {
  if (!(stiffness >= 0.0)) refuse("not negative", name, stiffness);
  return std::isfinite(stiffness) ? 0.5 * stiffness / rate : 0.0;
}

EnergyBoundSettings energy_bound_of(const InterfaceCapability& capability, double stiffness, double metric_length) {
  EnergyBoundSettings settings;
  settings.stiffness = stiffness;
  settings.metric_length = metric_length;
  if (!(capability.delay >= 0.0 && std::isfinite(capability.delay))) refuse("finite", "delay (s)", capability.delay);
  settings.delay = capability.delay;
  settings.encoder_step = std::max(capability.encoder_step, 0.0);
  settings.own_damping = vouched_damping("rated stiffness (N/m)", capability.max_stiffness, capability.rate);
  settings.own_rotational_damping =
      vouched_damping("rated rotational stiffness (N m/rad)", capability.max_rotational_stiffness, capability.rate);
  return settings;
}

}  // namespace

SafetyLimits with_short_ramp(SafetyLimits limits) noexcept {
  limits.ramp_time = 0.2;
  limits.ramp_below_force = limits.ramp_below_torque = std::numeric_limits<double>::infinity();
  return limits;
}

SafetyLimits without_hand(SafetyLimits limits) noexcept {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  limits = with_short_ramp(limits);
  limits.energy_bound.on = false;
  limits.calm_time = 0.0;
  limits.max_speed = limits.max_turning_speed = kInfinite;
  limits.max_missed_ticks = std::numeric_limits<int>::max();
  limits.max_gap = kInfinite;
  return limits;
}

SafetyLimits safety_limits(const InterfaceCapability& capability, double stiffness, double metric_length,
                           double physics_period, const StrikeAllowance& strike) {
  require_positive("stiffness (N/m)", stiffness);
  require_positive("metric length (m)", metric_length);
  require_positive("physics period (s)", physics_period);
  require_positive("rate of the interface (Hz)", capability.rate);
  require_positive("strike speed (m/s)", strike.speed);
  require_positive("turning speed (rad/s)", strike.turning_speed);
  require_positive("margin", strike.margin);
  if (strike.grip_arm != 0.0) require_positive("grip arm (m)", strike.grip_arm);

  SafetyLimits limits;
  limits.period = 1.0 / capability.rate;
  limits.force_rate = strike.margin * stiffness * strike.speed;
  limits.torque_rate =
      strike.margin * stiffness *
      (strike.speed * (0.5 * metric_length + strike.grip_arm) + strike.turning_speed * metric_length * metric_length);
  limits.max_force = stated_limit("maximum force (N)", capability.max_force, limits.max_force);
  limits.max_torque = stated_limit("maximum torque (N m)", capability.max_torque, limits.max_torque);
  limits.max_model_age = kModelPeriods * physics_period + kSchedulingAllowance;
  limits.metric_length = metric_length;
  limits.energy_bound = energy_bound_of(capability, stiffness, metric_length);
  return capability.in_hand ? limits : without_hand(limits);
}

}  // namespace tegotae
