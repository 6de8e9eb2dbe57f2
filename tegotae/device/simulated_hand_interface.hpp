// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/intended_motion.hpp>
#include <tegotae/device/pose_history.hpp>
#include <tegotae/device/simulated_grip.hpp>
#include <tegotae/runtime/haptic_interface.hpp>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <vector>

namespace tegotae {

/// An interface as its maker and its measurement describe it.
struct SimulatedDevice {
  InterfaceCapability capability;  ///< limits clip the motors; encoder_step (m, 0: none) quantises the position
  GripMechanics mechanics;
  double encoder_angle = 0.0;     ///< rad, step of each component of the rotation vector; 0: none
  double delay = 0.0;             ///< s, from writing a command to its being displayed, at most 0.1
  double velocity_window = 0.01;  ///< s over which the reported velocity is a finite difference, at least one reading
};

/// Hand and interface in closed loop, simulated: the hand means to follow a motion, the interface resists and is
/// driven by what is displayed. A command is held until the next one is displayed (zero-order hold), `delay` later than
/// it was written, clipped to the capability.
///
/// What `read` reports is what a device would: the pose at `time`, position and rotation vector (from the pose at the
/// motion's start) rounded to the nearest encoder step, and the velocity as the difference of two such readings
/// over the velocity window. The true state stands beside it. Runs in the loop's own time from 0, the motion's
/// start, where the grip is at rest; without a wall clock, so it repeats bit for bit. Between two calls of `read` the
/// hand's target moves linearly over spans of at most 1 ms. `read` and `write` do not allocate; `read` costs about
/// 0.15 us a sub-step.
class SimulatedHandInterface : public HapticInterface {
 public:
  static constexpr double kSubstep = 20e-6;  ///< s

  /// Throws std::invalid_argument where a value is out of range. Allocates.
  SimulatedHandInterface(Trajectory intended, const SimulatedDevice& device, const HandImpedance& hand,
                         double substep = kSubstep);
  /// `intended` may not be null.
  SimulatedHandInterface(std::unique_ptr<IntendedMotion> intended, const SimulatedDevice& device,
                         const HandImpedance& hand, double substep = kSubstep);

  /// The device's, with its delay.
  InterfaceCapability capability() const override;

  /// Integrates up to `time`. kLost, and nothing moves, where it is not finite or over a second after the last.
  InterfaceStatus read(double time, InterfaceState& state) noexcept override;
  InterfaceStatus write(const InterfaceCommand& command) noexcept override;

  const GripState& grip() const noexcept { return grip_.state(); }  ///< the true one
  const Pose& intended() const noexcept { return X_WH_; }           ///< where the hand means the grip to be now
  const SimulatedGrip& mechanics() const noexcept { return grip_; }
  const Wrench& displayed() const noexcept { return displayed_; }       ///< what the motors give now
  std::uint64_t dropped_commands() const noexcept { return dropped_; }  ///< written faster than 20 kHz

  /// Puts the grip elsewhere, for tests that start away from the motion.
  void set_grip(const GripState& state) noexcept { grip_.set_state(state); }

  /// Goes on at `time` (s) from another state of the grip, as if it had always been at rest there: no command waits.
  void restart(double time, const Pose& X_WG) noexcept;

 private:
  struct Command {
    double due = 0.0;  ///< s
    Wrench wrench;
  };

  void advance_to(double time) noexcept;
  void display_due() noexcept;
  Pose quantised(const Pose& X_WG) const noexcept;

  std::unique_ptr<IntendedMotion> intended_;
  Pose X_WG_start_;
  Pose X_WH_;  ///< where the hand means to be at `time_`
  SimulatedDevice device_;
  SimulatedGrip grip_;
  double time_ = 0.0;  ///< s

  Wrench displayed_;
  std::vector<Command> waiting_;  ///< a ring
  std::size_t first_ = 0, count_ = 0;
  std::uint64_t dropped_ = 0;

  PoseHistory history_;  ///< of what was reported
};

}  // namespace tegotae
