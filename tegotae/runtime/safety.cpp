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

// What keeps the wrench from the hand, at this call.
struct Alarms {
  bool stop;    // at once, for the interface is lost or the program ends
  bool fault;   // at once, for there is no pose to render
  bool hold;    // fade, and go on from there: physics late, or too many ticks missed
  bool let_go;  // fade, and then begin again: pose too old, clutch, dead-man button

  bool any() const noexcept { return stop || fault || hold || let_go; }
};

bool missed_too_many(const SafetyLimits& limits, SafetyState& state, double elapsed, SafetyOutput& output) noexcept {
  constexpr double kJitter = 0.5;  // periods
  const double missed = elapsed / limits.period - 1.0;
  if (missed > static_cast<double>(limits.max_missed_ticks) + kJitter) state.overrun = true;
  if (missed > kJitter || state.overrun) note(output, SafetyEvent::kTickLate);
  return state.overrun;
}

}  // namespace

bool is_gap(const SafetyLimits& limits, double elapsed) noexcept {
  const double allowed = limits.period * (static_cast<double>(limits.max_missed_ticks) + 1.5);
  return elapsed > std::max(limits.max_gap, allowed);
}

namespace {

Alarms alarms_of(const SafetyLimits& limits, SafetyState& state, const SafetyInput& input,
                 SafetyOutput& output) noexcept {
  const auto noted = [&output](bool is_so, SafetyEvent event) {
    if (is_so) note(output, event);
    return is_so;
  };
  Alarms alarms{};
  alarms.stop = noted(input.interface_lost || input.ending, SafetyEvent::kStopped);
  const bool pose_late = !(input.pose_age <= limits.max_pose_age);
  alarms.fault = input.pose_fault;
  noted(input.pose_fault || pose_late, SafetyEvent::kPoseFault);
  alarms.hold = noted(!(input.model_age <= limits.max_model_age), SafetyEvent::kPhysicsLate);
  alarms.hold |= missed_too_many(limits, state, input.elapsed, output);
  alarms.let_go = pose_late || is_gap(limits, input.elapsed);
  alarms.let_go |= noted(input.clutched, SafetyEvent::kClutched);
  alarms.let_go |= noted(!input.enabled, SafetyEvent::kDeadMan);
  return alarms;
}

void restart_ramp(SafetyState& state) noexcept {
  state.ramp = 0.0;
  state.waiting = true;
  state.pushing_out = state.let_go = state.overrun = false;
  state.fading_for = 0.0;
}

// Whether the ramp may begin: the target is small and the tool outside of things, or it has just come out.
bool ramp_begins(const SafetyLimits& limits, SafetyState& state, const SafetyInput& input,
                 const Wrench& target) noexcept {
  const bool came_out = state.pushing_out && !input.pushing_out;
  state.pushing_out = input.pushing_out;
  if (std::isinf(limits.ramp_below_force)) return true;
  if (input.pushing_out) return false;
  return came_out ||
         (target.force.norm() <= limits.ramp_below_force && target.torque.norm() <= limits.ramp_below_torque);
}

Wrench ramped(const SafetyLimits& limits, SafetyState& state, const SafetyInput& input, const Alarms& alarms, double dt,
              SafetyOutput& output, const Wrench& target) noexcept {
  // A state that was overwritten begins again.
  if (!(state.ramp >= 0.0 && state.ramp <= 1.0)) restart_ramp(state);
  if (state.waiting && (alarms.any() || !ramp_begins(limits, state, input, target))) {
    note(output, SafetyEvent::kWaiting);
    return {};
  }
  state.waiting = false;
  const double step = limits.ramp_time > 0.0 ? dt / limits.ramp_time : 1.0;
  state.ramp = std::min(state.ramp + step, 1.0);
  if (state.ramp == 1.0) return target;
  note(output, SafetyEvent::kRamping);
  return target * state.ramp;
}

Wrench energy_bounded(const SafetyLimits& limits, SafetyState& state, const SafetyInput& input, double dt,
                      const Wrench& target, SafetyOutput& output) noexcept {
  EnergyBoundInput energy;
  energy.moved = input.moved;
  energy.stretched = input.stretched;
  energy.target = target;
  energy.stretch = input.stretch;
  energy.turn = input.turn;
  energy.part = state.waiting ? 0.0 : state.ramp;
  energy.max_force = limits.max_force;
  energy.max_torque = limits.max_torque;
  energy.dt = dt;
  Wrench result = state.energy.apply(limits.energy_bound, energy, state.displayed);
  if (state.energy.damping() > 0.0) note(output, SafetyEvent::kEnergyBounded);
  return result;
}

Wrench rate_limited(const SafetyLimits& limits, SafetyState& state, double dt, const Wrench& target,
                    SafetyOutput& output) noexcept {
  double force_rate = limits.force_rate, torque_rate = limits.torque_rate;
  if (state.calm_for > 0.0 && limits.calm_time > 0.0) {
    force_rate = std::min(force_rate, limits.max_force / limits.calm_time);
    torque_rate = std::min(torque_rate, limits.max_torque / limits.calm_time);
    state.calm_for -= dt;
  }
  Wrench result{growth_limited(target.force, state.displayed.force, force_rate * dt),
                growth_limited(target.torque, state.displayed.torque, torque_rate * dt)};
  if (result.force != target.force || result.torque != target.torque) note(output, SafetyEvent::kRateLimited);
  return result;
}

Wrench saturated_to(const SafetyLimits& limits, const Wrench& target, SafetyOutput& output) noexcept {
  Wrench result{saturated(target.force, limits.max_force), saturated(target.torque, limits.max_torque)};
  if (result.force != target.force) note(output, SafetyEvent::kForceSaturated);
  if (result.torque != target.torque) note(output, SafetyEvent::kTorqueSaturated);
  return result;
}

Wrench stopped(SafetyState& state) noexcept {
  restart_ramp(state);
  state.energy.reset();
  return {};
}

Wrench faded(const SafetyLimits& limits, SafetyState& state, double elapsed, const Wrench& target) noexcept {
  const double last_force = state.displayed.force.norm(), last_torque = state.displayed.torque.norm();
  const bool begins = state.fading_for == 0.0;
  if (begins) {
    state.fading_from_force = last_force;
    state.fading_from_torque = last_torque;
  }
  // At least a period a call, so that the fade ends even if the clock stands still (or tells NaN); no more than that in
  // the first, so that what was held over missed ticks is not dropped.
  state.fading_for += elapsed > limits.period && !begins ? elapsed : limits.period;
  const double left = 1.0 - state.fading_for / limits.fade_time;
  const double fraction = left > kFadeRounding ? left : 0.0;
  state.ramp = std::min(state.ramp, fraction);
  if (fraction == 0.0) {
    state.overrun = false;
    return {};
  }
  return {saturated(target.force, std::min(fraction * state.fading_from_force, last_force)),
          saturated(target.torque, std::min(fraction * state.fading_from_torque, last_torque))};
}

Wrench watched(const SafetyLimits& limits, SafetyState& state, const SafetyInput& input, const Alarms& alarms,
               const Wrench& target) noexcept {
  if (alarms.stop || alarms.fault) return stopped(state);
  if (alarms.hold || alarms.let_go) {
    state.let_go = state.let_go || alarms.let_go;
    return faded(limits, state, input.elapsed, target);
  }
  state.fading_for = 0.0;
  return state.let_go ? stopped(state) : target;
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
    case SafetyEvent::kWaiting:
      return "waiting";
    case SafetyEvent::kEnergyBounded:
      return "energy_bounded";
    case SafetyEvent::kTickLate:
      return "tick_late";
    case SafetyEvent::kPoseFault:
      return "pose_fault";
    case SafetyEvent::kClutched:
      return "clutched";
    case SafetyEvent::kDeadMan:
      return "dead_man";
  }
  return "unknown";
}

SafetyOutput apply_safety(const SafetyLimits& limits, SafetyState& state, const SafetyInput& input) noexcept {
  SafetyOutput output;
  const double dt = counted_time(limits, input.elapsed);
  const Alarms alarms = alarms_of(limits, state, input, output);
  Wrench wrench = finite_checked(input.target, output);
  wrench = ramped(limits, state, input, alarms, dt, output, wrench);
  wrench = energy_bounded(limits, state, input, dt, wrench, output);
  wrench = rate_limited(limits, state, dt, wrench, output);
  wrench = saturated_to(limits, wrench, output);
  wrench = watched(limits, state, input, alarms, wrench);
  // Holds even if limits or state were overwritten: no NaN leaves.
  if (!is_wrench(wrench)) {
    note(output, SafetyEvent::kNotFinite);
    wrench = stopped(state);
  }

  output.displayed = wrench;
  output.ratio = displayed_ratio(input.target, wrench, limits.metric_length);
  state.displayed = wrench;
  for (std::size_t i = 0; i < kSafetyEvents; ++i) state.counts[i] += (output.events >> i) & 1U;
  return output;
}

}  // namespace tegotae
