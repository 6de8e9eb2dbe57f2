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
  kWaiting,          ///< zero, as the ramp has not begun: the target is not yet small, or the tool still pushed out
  kEnergyBounded,    ///< the damper of the energy bound acted
  kTickLate,         ///< ticks were missed, or the wrench fades as too many were
  kPoseFault,        ///< zero, as the pose was none or leapt; or fading, as it is too old
  kClutched,         ///< fading, or faded, as the tool is clutched
  kDeadMan,          ///< fading, or faded, as the dead-man button is not held down
};
inline constexpr std::size_t kSafetyEvents = 13;

/// "not_finite", "ramping", ...
const char* name_of(SafetyEvent event) noexcept;

/// N and N m. A target above it is a fault of computation, not a wrench (at 9000 N/m it is 100 m of penetration).
inline constexpr double kLargestWrench = 1e6;

/// What the stage remembers from call to call. Starts at zero wrench before the ramp.
struct SafetyState {
  Wrench displayed;                ///< of the last call
  bool waiting = true;             ///< the ramp has not begun
  bool pushing_out = false;        ///< in the last call in which the ramp waited
  double ramp = 0.0;               ///< fraction of the ramp that is done
  double fading_for = 0.0;         ///< s since a fade began, 0: none
  double fading_from_force = 0.0;  ///< N, displayed when it began
  double fading_from_torque = 0.0;
  double calm_for = 0.0;  ///< s of `calm_time` that are left; set where settings change
  bool overrun = false;   ///< a fade for missed ticks is not done
  bool let_go = false;    ///< the fade is one after which the ramp waits and begins again
  EnergyBound energy;
  std::array<std::uint64_t, kSafetyEvents> counts{};  ///< calls in which each event happened

  std::uint64_t count(SafetyEvent event) const noexcept { return counts[static_cast<std::size_t>(event)]; }
};

struct SafetyInput {
  Wrench target;             ///< on the hand, torque about the grip, world axes
  double elapsed = 0.0;      ///< s since the last call
  double model_age = 0.0;    ///< s since the world state of the model that the target was made from; infinite: none yet
  double pose_age = 0.0;     ///< s since the pose was measured, as far as the interface says
  bool pushing_out = false;  ///< the target grows as the tool is brought out of something (RenderOutput::pushing_out)
  bool pose_fault = false;   ///< the pose was none, leapt, or the world is not known yet where it leapt to
  bool clutched = false;
  bool enabled = true;  ///< the dead-man button is held down, or there is none
  bool interface_lost = false;
  bool ending = false;  ///< the program is ending

  // For the energy bound.
  Vector6 moved = Vector6::Zero();      ///< of the grip since the last call: displacement (m), rotation vector (rad)
  Vector6 stretched = Vector6::Zero();  ///< of that, what changed the stretch between tool and hand
  double stretch = 0.0;                 ///< m, between tool and hand, as felt at the interface
  double turn = 0.0;                    ///< rad
};

struct SafetyOutput {
  Wrench displayed;          ///< may go to the interface
  std::uint32_t events = 0;  ///< bit i: SafetyEvent i happened
  /// The part of the target that is displayed, in [0, 1]: the factor s that brings s * target nearest to `displayed`,
  /// torques compared with forces at the metric length. 1 where the stage did nothing.
  double ratio = 1.0;

  bool has(SafetyEvent event) const noexcept { return ((events >> static_cast<unsigned>(event)) & 1U) != 0; }
};

/// Whether the haptic thread stood so long, `elapsed` s, that the hand may be anywhere since.
bool is_gap(const SafetyLimits& limits, double elapsed) noexcept;

/// The last stage before the interface: no wrench reaches a hand but through here. In the interface's own units. A pure
/// function of its arguments; does not allocate. In this order:
///   1. finite check: a target that is no wrench counts as zero;
///   2. ramp-in: nothing, until force and torque of the target are below `ramp_below_force` and `ramp_below_torque`
///      with the tool outside of things, or the push-out of a tool that was inside has ended; then the target times the
///      fraction of `ramp_time` since. It waits and begins again after start, lost interface, pose fault, clutch and
///      dead-man button; after late physics or missed ticks it goes on from where the fade stood, without waiting;
///   3. energy bound (energy_bound.hpp);
///   4. rate limit: force and torque each by `growth_limited` from the wrench displayed last; a late tick has no more
///      than one period's growth; for `calm_time` after a change of settings slower;
///   5. saturation: force and torque each to their limit, direction kept;
///   6. watchdog. Interface lost, program ending, pose fault: zero at once. Physics later than `max_model_age`: until
///      then the target, made from the model that is known, is displayed, and then it fades: the magnitudes of force
///      and torque may not rise and stay under a line that falls to zero within `fade_time`. So it does where the pose
///      is older than `max_pose_age` or the tool is clutched, and once, down to zero, where more than
///      `max_missed_ticks` were missed in a row;
///   7. dead-man button not held down: it fades likewise.
/// The displayed wrench is finite and within the limits for any bits in `input`.
SafetyOutput apply_safety(const SafetyLimits& limits, SafetyState& state, const SafetyInput& input) noexcept;

}  // namespace tegotae
