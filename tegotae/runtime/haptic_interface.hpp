// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/pose.hpp>
#include <tegotae/math/twist.hpp>
#include <tegotae/math/wrench.hpp>

#include <cstdint>
#include <limits>
#include <string>

namespace tegotae {

/// What an interface can do. SI units. Limits that are not known are infinite.
struct InterfaceCapability {
  std::string name;
  int input_degrees_of_freedom = 6;
  int output_degrees_of_freedom = 6;
  double max_force = std::numeric_limits<double>::infinity();                 ///< N
  double max_torque = std::numeric_limits<double>::infinity();                ///< N m
  double max_stiffness = std::numeric_limits<double>::infinity();             ///< N/m, as rated
  double max_rotational_stiffness = std::numeric_limits<double>::infinity();  ///< N m/rad, as rated
  double max_damping = std::numeric_limits<double>::infinity();               ///< N s/m, as rated
  double max_rotational_damping = std::numeric_limits<double>::infinity();    ///< N m s/rad, as rated
  double rate = 1000.0;                                                       ///< Hz, of its servo loop
  double encoder_step = 0.0;                                                  ///< m at the grip; 0: not quantised
  double delay = 0.0;  ///< s, from writing a command to its being displayed, as far as it is known
  /// A hand holds it and feels what is commanded. False: a motion is played, whatever is displayed.
  bool in_hand = true;
};

/// What an interface reports: pose of the grip and so of the tool's frame.
struct InterfaceState {
  /// s on the loop's clock, when the pose was measured. A driver that learns from its device when that was sets it, so
  /// that a pose that stands still is told from a hand that does; the others leave the time that they were asked for.
  double time = 0.0;
  Pose X_WT;
  Twist V_WT;  ///< of the tool frame's origin, world axes
  std::uint32_t buttons = 0;
  double gripper = 0.0;  ///< opening, m
};

/// What an interface is told to display.
struct InterfaceCommand {
  Wrench wrench;               ///< on the hand, world axes, torque about the grip (the tool frame's origin)
  double gripper_force = 0.0;  ///< N, positive opens
};

enum class InterfaceStatus : std::uint8_t { kOk, kLost };

/// Port to a force-feedback interface. Axes, units and calibration are settled behind it: metres, newtons, right-handed
/// world axes. `read` and `write` are called once each a haptic tick from one thread, outside the tick's pure function.
class HapticInterface {
 public:
  HapticInterface() = default;
  HapticInterface(const HapticInterface&) = delete;
  HapticInterface& operator=(const HapticInterface&) = delete;
  virtual ~HapticInterface() = default;

  virtual InterfaceCapability capability() const = 0;
  /// State at `time` (s on the loop's clock).
  virtual InterfaceStatus read(double time, InterfaceState& state) noexcept = 0;
  virtual InterfaceStatus write(const InterfaceCommand& command) noexcept = 0;
};

}  // namespace tegotae
