// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/runtime/haptic_interface.hpp>

namespace tegotae {

/// Settings of the safety stage (safety.hpp). Each default has its reason beside it.
struct SafetyLimits {
  /// s, the haptic period. A tick that comes late may not grow the wrench by more than one period's growth.
  double period = 1e-3;

  /// s, from zero to the full wrench after start, lost interface or late physics. Long enough that a start in contact
  /// is felt as a swell (a hand answers a push within about 0.15 s), short enough not to hide the first touch.
  double ramp_time = 0.2;

  /// N/s and N m/s, growth of the displayed force and torque. As `safety_limits` computes them for 1 m/s and 10 rad/s
  /// at 9000 N/m, metric length 0.1 m, grip at the centre of mass.
  double force_rate = 18e3;
  double torque_rate = 2.7e3;

  /// N and N m. Programs for the strongest common interfaces clamp to these.
  double max_force = 15.0;
  double max_torque = 1.0;

  /// s, age of the physics model that is still trusted: 3 periods of 50 ms (a model is 1 to 2 periods old in normal
  /// running, as it becomes visible one period late) and 10 ms for a busy scheduler.
  double max_model_age = 0.16;

  /// s, from the displayed wrench to zero once physics is later than that. Under the shortest reaction of a hand, and
  /// no step that would be felt as a blow.
  double fade_time = 0.02;

  /// m, arm at which force and torque are compared in `SafetyOutput::ratio`: the metric length of the method.
  double metric_length = 0.1;
};

/// How the hand and the tool may move, for the growth that a wrench needs.
struct StrikeAllowance {
  double speed = 1.0;           ///< m/s, of a deliberate strike
  double turning_speed = 10.0;  ///< rad/s, of a fast turn of the wrist
  double grip_arm = 0.0;        ///< m, from the tool frame's origin (the grip) to the tool's centre of mass
  double margin = 2.0;          ///< over the elastic growth alone: damping, and noise of the measured velocity
};

/// Limits for a method of `stiffness` (N/m) and `metric_length` (m) on an interface, physics published each
/// `physics_period` (s).
///
/// The elastic force of a strike at speed v grows by at most k v. A contact point at lever arm x is felt as
/// k/(1 + x²/ℓ²), so its torque about the centre of mass grows by at most k v max_x x/(1 + x²/ℓ²) = k v ℓ/2; a turn at
/// ω of a tool held on all sides adds k ℓ² ω; and the torque is displayed about the grip, which adds k v |arm|. Each
/// times the margin. Limits that the interface does not state stay at the defaults above. Throws std::invalid_argument
/// where an argument is not positive and finite (grip_arm: not negative).
SafetyLimits safety_limits(const InterfaceCapability& capability, double stiffness, double metric_length,
                           double physics_period, const StrikeAllowance& strike = {});

}  // namespace tegotae
