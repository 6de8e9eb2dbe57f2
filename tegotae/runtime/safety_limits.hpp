// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/runtime/energy_bound.hpp>
#include <tegotae/runtime/haptic_interface.hpp>

#include <limits>

namespace tegotae {

/// Settings of the safety stage (safety.hpp), in the interface's own units. Each default has its reason beside it; the
/// defaults are those for a hand that holds the interface.
struct SafetyLimits {
  /// s, the haptic period. A tick that comes late may not grow the wrench by more than one period's growth.
  double period = 1e-3;

  /// s, from zero to the full wrench after start, clutch, dead-man button, lost interface or late physics. The field's
  /// habit: long enough to let go. Where nobody can be hurt (`with_short_ramp`) a tenth of it.
  double ramp_time = 2.0;

  /// N and N m, below which force and torque must both be for the ramp to begin: five times the smallest that is felt,
  /// and a torque of the same force at 5 cm, half a grip. Infinite: it begins at once.
  double ramp_below_force = 0.2;
  double ramp_below_torque = 0.01;

  /// Passivity observer and controller; `energy_bound.on` turns it off.
  EnergyBoundSettings energy_bound;

  /// N/s and N m/s, growth of the displayed force and torque. As `safety_limits` computes them for 1 m/s and 10 rad/s
  /// at 9000 N/m, metric length 0.1 m, grip at the centre of mass.
  double force_rate = 18e3;
  double torque_rate = 2.7e3;

  /// s after a change of settings (HapticTick::adopt) in which the wrench may grow no faster than from zero to its
  /// limit in that time: a stiffness that was raised tenfold under a press swells. 0: no such bound.
  double calm_time = 0.5;

  /// N and N m. Programs for the strongest common interfaces clamp to these.
  double max_force = 15.0;
  double max_torque = 1.0;

  /// s, age of the physics model that is still trusted: 3 periods of 50 ms (a model is 1 to 2 periods old in normal
  /// running, as it becomes visible one period late) and 10 ms for a busy scheduler.
  double max_model_age = 0.16;

  /// Ticks in a row that may be missed, the interface holding the last wrench, before what was held is taken back. Ten
  /// are 10 ms at 1 kHz: longer than a loaded machine's hiccup, shorter than what a hand feels as a delay.
  int max_missed_ticks = 10;

  /// s that the haptic thread may stand before the hand may be anywhere: after more (a program that was stopped, a call
  /// that hung) it is as after a lost interface, the ramp waits. A hand at 1 m/s is 50 mm farther by then.
  double max_gap = 0.05;

  /// s, age of the pose that is still trusted, where the interface says how old it is.
  double max_pose_age = 0.02;

  /// m/s and rad/s that a hand can do: a pose that went faster is a fault. A fast reach has 4 m/s, a flick of the wrist
  /// 30 rad/s. Infinite: any pose is taken.
  double max_speed = 5.0;
  double max_turning_speed = 50.0;

  /// Button (its number, from 0) that must be held down for anything to be displayed; negative: none.
  int dead_man_button = -1;

  /// s, from the displayed wrench to zero once physics or a tick is later than that, the tool is clutched or the
  /// dead-man button is let go. Under the shortest reaction of a hand, and no step that would be felt as a blow.
  double fade_time = 0.02;

  /// m, arm at which force and torque are compared in `SafetyOutput::ratio`: the metric length of the method.
  double metric_length = 0.1;
};

/// The same limits with a ramp of 0.2 s that begins at once: for an experiment, whose hand is simulated or only played.
/// There is nobody to spare, two seconds would hide what is measured, and a start in contact should still swell.
SafetyLimits with_short_ramp(SafetyLimits limits) noexcept;

/// The same limits for a motion that is played whatever is displayed, nobody holding anything: the ramp is short; the
/// energy bound is off; changed settings are shown at once, as a played motion takes any energy and gives any; what the
/// file says is the pose, however far it leaps; and no hand was left with a wrench while ticks were missed.
SafetyLimits without_hand(SafetyLimits limits) noexcept;

/// How the hand and the tool may move, for the growth that a wrench needs.
struct StrikeAllowance {
  double speed = 1.0;           ///< m/s, of a deliberate strike
  double turning_speed = 10.0;  ///< rad/s, of a fast turn of the wrist
  double grip_arm = 0.0;        ///< m, from the tool frame's origin (the grip) to the tool's centre of mass
  double margin = 2.0;          ///< over the elastic growth alone: damping, and noise of the measured velocity
};

/// Limits for a method of `stiffness` (N/m) and `metric_length` (m), as felt at the interface, physics published each
/// `physics_period` (s). `without_hand` where the capability says that none holds it.
///
/// The elastic force of a strike at speed v grows by at most k v. A contact point at lever arm x is felt as
/// k/(1 + x²/ℓ²), so its torque about the centre of mass grows by at most k v max_x x/(1 + x²/ℓ²) = k v ℓ/2; a turn at
/// ω of a tool held on all sides adds k ℓ² ω; and the torque is displayed about the grip, which adds k v |arm|. Each
/// times the margin. Limits that the interface does not state stay at the defaults above. Throws std::invalid_argument
/// where an argument is not positive and finite (grip_arm: not negative).
SafetyLimits safety_limits(const InterfaceCapability& capability, double stiffness, double metric_length,
                           double physics_period, const StrikeAllowance& strike = {});

}  // namespace tegotae
