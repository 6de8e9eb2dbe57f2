// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/trajectory.hpp>
#include <tegotae/runtime/haptic_interface.hpp>

namespace tegotae {

/// A simulated interface whose hand plays a motion, whatever is displayed to it: the motion's start is the loop's time
/// 0.
class PlaybackInterface : public HapticInterface {
 public:
  explicit PlaybackInterface(Trajectory trajectory, const InterfaceCapability& capability = default_capability());

  /// Six degrees of freedom in and out, no limits of its own, and no hand.
  static InterfaceCapability default_capability();

  InterfaceCapability capability() const override { return capability_; }
  InterfaceStatus read(double time, InterfaceState& state) noexcept override;
  InterfaceStatus write(const InterfaceCommand& command) noexcept override;

  const Trajectory& trajectory() const noexcept { return trajectory_; }
  const InterfaceCommand& last_command() const noexcept { return last_command_; }

 private:
  Trajectory trajectory_;
  InterfaceCapability capability_;
  InterfaceCommand last_command_;
};

}  // namespace tegotae
