// SPDX-License-Identifier: Apache-2.0
#include <tegotae/runtime/safety.hpp>
#include <tegotae/runtime/vector_limits.hpp>

#include <algorithm>
#include <cmath>

namespace tegotae {
namespace {

// A fraction of the fade: what is left below it is rounding of a sum of periods, and counts as done.
constexpr double kFadeRounding = 1e-9;

void note(SafetyOutput& output, SafetyEvent event) noexcept { output.events |= 1U << static_cast<unsigned>(event); }

bool is_wrench(const Wrench& wrench) noexcept {
  // Written so that NaN fails.
  return (wrench.force.array().abs() <= kLargestWrench).all() && (wrench.torque.array().abs() <= kLargestWrench).all();
}

Wrench finite_checked(const Wrench& target, SafetyOutput& output) noexcept {
  if (is_wrench(target)) return target;
  note(output, SafetyEvent::kNotFinite);
  return {};
}

// Seconds that ramp and rate limit may count for this call: never more than a period, zero if the clock failed.
double counted_time(const SafetyLimits& limits, double elapsed) noexcept {
  return elapsed > 0.0 ? std::min(elapsed, limits.period) : 0.0;
}

Wrench ramped(const SafetyLimits& limits, SafetyState& state, double dt, const Wrench& target,
              SafetyOutput& output) noexcept {
  const double step = limits.ramp_time > 0.0 ? dt / limits.ramp_time : 1.0;
  state.ramp = std::min(state.ramp + step, 1.0);
  if (state.ramp == 1.0) return target;
  note(output, SafetyEvent::kRamping);
  return target * state.ramp;
}

Wrench rate_limited(const SafetyLimits& limits, const SafetyState& state, double dt, const Wrench& target,
                    SafetyOutput& output) noexcept {
  Wrench result{growth_limited(target.force, state.displayed.force, limits.force_rate * dt),
                growth_limited(target.torque, state.displayed.torque, limits.torque_rate * dt)};
  if (result.force != target.force || result.torque != target.torque) note(output, SafetyEvent::kRateLimited);
  return result;
}

Wrench saturated_to(const SafetyLimits& limits, const Wrench& target, SafetyOutput& output) noexcept {
  Wrench result{saturated(target.force, limits.max_force), saturated(target.torque, limits.max_torque)};
  if (result.force != target.force) note(output, SafetyEvent::kForceSaturated);
  if (result.torque != target.torque) note(output, SafetyEvent::kTorqueSaturated);
  return result;
}

Wrench stopped(SafetyState& state, SafetyOutput& output) noexcept {
  note(output, SafetyEvent::kStopped);
  state.ramp = 0.0;
  state.late_for = 0.0;
  return {};
}

Wrench faded(const SafetyLimits& limits, SafetyState& state, double elapsed, const Wrench& target,
             SafetyOutput& output) noexcept {
  note(output, SafetyEvent::kPhysicsLate);
  const double last_force = state.displayed.force.norm(), last_torque = state.displayed.torque.norm();
  if (state.late_for == 0.0) {
    state.fading_from_force = last_force;
    state.fading_from_torque = last_torque;
  }
  // At least a period a call, so that the fade ends even if the clock stands still (or tells NaN).
  state.late_for += elapsed > limits.period ? elapsed : limits.period;
  const double left = 1.0 - state.late_for / limits.fade_time;
  const double fraction = left > kFadeRounding ? left : 0.0;
  state.ramp = std::min(state.ramp, fraction);
  if (fraction == 0.0) return {};
  return {saturated(target.force, std::min(fraction * state.fading_from_force, last_force)),
          saturated(target.torque, std::min(fraction * state.fading_from_torque, last_torque))};
}

Wrench watched(const SafetyLimits& limits, SafetyState& state, const SafetyInput& input, const Wrench& target,
               SafetyOutput& output) noexcept {
  if (input.interface_lost || input.ending) return stopped(state, output);
  if (!(input.model_age <= limits.max_model_age)) return faded(limits, state, input.elapsed, target, output);
  state.late_for = 0.0;
  return target;
}

double displayed_ratio(const Wrench& target, const Wrench& displayed, double metric_length) noexcept {
  if (displayed.force == target.force && displayed.torque == target.torque) return 1.0;
  if (!is_wrench(target)) return 0.0;
  const double weight = 1.0 / (metric_length * metric_length);
  const double product = displayed.force.dot(target.force) + weight * displayed.torque.dot(target.torque);
  const double square = target.force.squaredNorm() + weight * target.torque.squaredNorm();
  const double ratio = product / square;
  return ratio >= 0.0 ? std::min(ratio, 1.0) : 0.0;
}

}  // namespace

const char* name_of(SafetyEvent event) noexcept {
  switch (event) {
    case SafetyEvent::kNotFinite:
      return "not_finite";
    case SafetyEvent::kRamping:
      return "ramping";
    case SafetyEvent::kRateLimited:
      return "rate_limited";
    case SafetyEvent::kForceSaturated:
      return "force_saturated";
    case SafetyEvent::kTorqueSaturated:
      return "torque_saturated";
    case SafetyEvent::kPhysicsLate:
      return "physics_late";
    case SafetyEvent::kStopped:
      return "stopped";
  }
  return "unknown";
}

SafetyOutput apply_safety(const SafetyLimits& limits, SafetyState& state, const SafetyInput& input) noexcept {
  SafetyOutput output;
  const double dt = counted_time(limits, input.elapsed);
  Wrench wrench = finite_checked(input.target, output);
  wrench = ramped(limits, state, dt, wrench, output);
  wrench = rate_limited(limits, state, dt, wrench, output);
  wrench = saturated_to(limits, wrench, output);
  wrench = watched(limits, state, input, wrench, output);
  // Holds even if limits or state were overwritten: no NaN leaves.
  if (!is_wrench(wrench)) wrench = stopped(state, output);

  output.displayed = wrench;
  output.ratio = displayed_ratio(input.target, wrench, limits.metric_length);
  state.displayed = wrench;
  for (std::size_t i = 0; i < kSafetyEvents; ++i) state.counts[i] += (output.events >> i) & 1U;
  return output;
}

}  // namespace tegotae
