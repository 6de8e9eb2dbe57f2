// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/wrench.hpp>
#include <tegotae/runtime/safety_limits.hpp>

#include <array>
#include <cstddef>
#include <cstdint>

namespace tegotae {

/// What the safety stage did to a wrench. Also the places in `SafetyState::counts` and the bits of
/// `SafetyOutput::events`.
enum class SafetyEvent : std::uint8_t {
  kNotFinite,        ///< the target was no wrench (NaN, infinite, above kLargestWrench): taken as zero
  kRamping,          ///< the ramp scaled the target
  kRateLimited,      ///< force or torque would have grown too fast
  kForceSaturated,   ///< force beyond the limit
  kTorqueSaturated,  ///< torque beyond the limit
  kPhysicsLate,      ///< fading, or faded, as the model is too old
  kStopped,          ///< zero, as the interface is lost or the program is ending
};
inline constexpr std::size_t kSafetyEvents = 7;

/// "not_finite", "ramping", ...
const char* name_of(SafetyEvent event) noexcept;

/// N and N m. A target above it is a fault of computation, not a wrench (at 9000 N/m it is 100 m of penetration).
inline constexpr double kLargestWrench = 1e6;

/// What the stage remembers from call to call. Starts at zero wrench before the ramp.
struct SafetyState {
  Wrench displayed;                ///< of the last call
  double ramp = 0.0;               ///< fraction of the ramp that is done
  double late_for = 0.0;           ///< s since physics was found late, 0: not late
  double fading_from_force = 0.0;  ///< N, displayed when physics was found late
  double fading_from_torque = 0.0;
  std::array<std::uint64_t, kSafetyEvents> counts{};  ///< calls in which each event happened

  std::uint64_t count(SafetyEvent event) const noexcept { return counts[static_cast<std::size_t>(event)]; }
};

struct SafetyInput {
  Wrench target;           ///< on the hand, torque about the grip, world axes
  double elapsed = 0.0;    ///< s since the last call
  double model_age = 0.0;  ///< s since the world state of the model that the target was made from; infinite: none yet
  bool interface_lost = false;
  bool ending = false;  ///< the program is ending
};

struct SafetyOutput {
  Wrench displayed;          ///< may go to the interface
  std::uint32_t events = 0;  ///< bit i: SafetyEvent i happened
  /// The part of the target that is displayed, in [0, 1]: the factor s that brings s * target nearest to `displayed`,
  /// torques compared with forces at the metric length. 1 where the stage did nothing.
  double ratio = 1.0;

  bool has(SafetyEvent event) const noexcept { return ((events >> static_cast<unsigned>(event)) & 1U) != 0; }
};

/// The last stage before the interface: no wrench reaches a hand but through here. A pure function of its arguments;
/// does not allocate. In this order:
///   1. finite check: a target that is no wrench counts as zero;
///   2. ramp-in: the target times the fraction of `ramp_time` since start, stop or fade;
///      (an energy bound belongs here, before the limits that must hold whatever it does);
///   3. rate limit: force and torque each by `growth_limited` from the wrench displayed last; a late tick has no more
///      than one period's growth;
///   4. saturation: force and torque each to their limit, direction kept;
///   5. watchdog: interface lost or program ending: zero at once. Physics later than `max_model_age`: until then the
///      target, made from the model that is known, is displayed; after that the magnitudes of force and torque may
///      not rise and stay under a line that falls to zero within `fade_time`. Either way the ramp starts again.
/// The displayed wrench is finite and within the limits for any bits in `input`.
SafetyOutput apply_safety(const SafetyLimits& limits, SafetyState& state, const SafetyInput& input) noexcept;

}  // namespace tegotae
