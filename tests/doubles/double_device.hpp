// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/simulated_grip.hpp>

#include <tests/doubles/double_state.hpp>

#include <atomic>
#include <optional>
#include <string>

namespace tegotae::test {

/// What a double's sensors report, in the maker's axes, its faults included.
struct DoubleReading {
  Pose X;
  Twist V;
  unsigned buttons = 0;
  double gripper = 0.0, gripper_angle = 0.0;  ///< m, rad
};

/// The device behind a maker's test library: a grip with mass and damping in a hand, clipped motors, buttons and the
/// faults of DoubleState. The library is a shell of the maker's functions around `instance`.
///
/// It moves when it is called, up to the time of the call (at most 0.1 s at once), in sub-steps of 50 us. A motor gives
/// the last command until the next, whoever dies. Every function may be called from any thread; none allocates but
/// `open`, and none takes a lock of the system's.
class DoubleDevice {
 public:
  /// The one device, on the file that the environment names whenever a function below is called without a device open.
  static DoubleDevice& instance();

  /// On the cable, open or not.
  bool is_present();
  /// False: none on the cable, or another living process has it.
  bool open();
  /// False: it was not open in this process.
  bool close();
  /// In this process, and not unplugged since.
  bool is_open();

  /// State shared with the test; null where the environment names none.
  DoubleState* state();

  /// Sensors and motors. False, and nothing is done: not open, unplugged, or a fault's turn. A command reaches the
  /// motors only with forces on.
  bool read(DoubleReading& reading);
  bool command(const Wrench& wrench, double gripper_force);
  /// Off: the motors give nothing from now on.
  bool set_forces(bool on);
  /// False where it cannot be calibrated.
  bool calibrate();

 private:
  class Guard;  // holds busy_

  bool map();
  bool usable() const;
  bool begin_call();
  std::int64_t now() const;
  void lose_power();
  void step();
  void display(const Wrench& wrench);
  void count(const Wrench& wrench);

  std::atomic<bool> busy_{false};
  std::string path_;
  DoubleState* state_ = nullptr;
  std::optional<SimulatedGrip> grip_;
  bool open_ = false;
  int plugged_in_ = 0;  ///< unplugged_times when it was opened
  std::uint64_t turns_ = 0;
  DoubleReading frozen_;
  bool is_frozen_ = false;
};

}  // namespace tegotae::test
