// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstdint>

namespace tegotae::test {

/// Environment variable with the path of the file that holds a DoubleState.
inline constexpr const char* kDoubleStateVariable = "TEGOTAE_DOUBLE_STATE";

/// A command as a double received it, in its maker's axes.
struct DoubleCommand {
  std::atomic<std::int64_t> time{0};                     ///< ns of CLOCK_MONOTONIC
  std::array<std::atomic<double>, 3> force{}, torque{};  ///< N, N m
};

/// A fact about the HD API that is otherwise than it is known to the driver.
enum class HdOddity : int {
  kNone,
  kTransformByRows,
  kMicrometres,
  kNoCartesianTorque,
  kManyDegrees,
  kResetStyle,   ///< calibrated at a position in which the device must be held
  kNoCallbacks,  ///< the scheduler runs and calls nobody
};

/// What stands behind a maker's test library: one simulated device on its cable. It lies in a file that the test, the
/// library in the test's process and the library in any other process have mapped, so each sees what the others did
/// even when one of them was killed. Everything is atomic, in SI units and in the maker's own axes.
struct DoubleState {
  static constexpr std::size_t kCommands = 8192;  // 8 s at 1 kHz

  // What the device is: set by the test before a process opens it.
  std::array<char, 32> model{};       ///< the maker's name for it
  std::atomic<int> serial_number{0};  ///< 0: the library cannot tell it
  std::atomic<int> degrees{6};        ///< of freedom that it measures and displays: 6 or 3
  std::atomic<bool> left_handed{false}, has_gripper{false};
  std::atomic<bool> has_passive_wrist{false};                  ///< with 3 degrees: turns are measured too
  std::atomic<double> max_force{12.0}, max_torque{0.2};        ///< N, N m: motors clip to these
  std::atomic<double> mass{0.2}, inertia{1e-3};                ///< kg, kg m^2, at the grip
  std::atomic<double> damping{1.0}, rotational_damping{1e-2};  ///< N s/m, N m s/rad
  std::atomic<double> hand_stiffness{200.0}, hand_rotational_stiffness{2.0};  ///< N/m, N m/rad; 0: nobody holds it
  std::atomic<double> hand_damping{5.0}, hand_rotational_damping{0.1};        ///< N s/m, N m s/rad
  std::atomic<int> command_timeout{0};  ///< ms without a command after which the firmware drops the force; 0: never
  std::atomic<int> library_major{0}, library_minor{0};  ///< what the library calls itself; 0: as it is
  std::atomic<int> first_button{0}, button_count{2};    ///< number of the first one, where the maker's are numbered
  std::atomic<double> servo_rate{1000.0};               ///< Hz, of a library that has a scheduler of its own
  std::atomic<double> nominal_stiffness{400.0};         ///< N/m, as the library tells it
  std::atomic<HdOddity> oddity{HdOddity::kNone};
  std::atomic<bool> shared{false};               ///< several living processes may have it open
  std::atomic<int> strings{8};                   ///< of a SPIDAR, as its board tells it
  std::atomic<int> sharing{1};                   ///< of a SPIDAR's board, as its library tells it
  std::atomic<double> axial_stiffness{50000.0};  ///< N, tension that would stretch a SPIDAR's string by its length

  // What the test does to it while it runs.
  std::array<std::atomic<double>, 7> hand{0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0};  ///< where the hand means to be
  std::atomic<unsigned> buttons{0};                                            ///< a bit each
  std::array<std::atomic<int>, 6> deflection{};                                ///< of a 3-D mouse: x y z, about x y z
  std::atomic<double> gripper{0.0}, gripper_angle{0.0};                        ///< m, rad
  std::atomic<std::int64_t> manual_time{-1};  ///< ns; not negative: the double's clock instead of the monotonic one

  // Faults, each until it is taken back unless it says "once".
  std::atomic<bool> unplugged{false};
  std::atomic<int> unplugged_times{0};  ///< a handle opened before is dead for good
  std::atomic<int> fail_every{0};       ///< every so manieth reading or command fails; 0: none
  std::atomic<bool> nan_pose{false}, frozen_pose{false};
  std::atomic<bool> bad_frame{false};         ///< the rotation is reported as no rotation
  std::array<std::atomic<double>, 3> jump{};  ///< m, added to the reported position
  std::array<std::atomic<double>, 8> slip{};  ///< pulses, added to a SPIDAR's counts
  std::atomic<std::int64_t> reading_age{0};  ///< ns, of a SPIDAR's counts, as its library tells it; INT64_MAX: infinite
  std::atomic<int> stall{0};                 ///< ms, once, in the next reading or command
  std::atomic<bool> uncalibrated{false};     ///< until the library calibrates it
  std::atomic<bool> cannot_calibrate{false};
  std::atomic<bool> emergency_stop{false}, power_off{false}, hand_off{false};  ///< hand_off: dead-man's switch let go
  std::atomic<bool> offset_button{false};  ///< pressed: no force, where the library was told so
  std::atomic<int> failed_buttons{0};      ///< so many times more, asking for a button fails
  std::atomic<int> error_once{0};          ///< number of a maker's error that the next reading or command raises

  // What the device does.
  std::array<std::atomic<double>, 7> pose{0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0};  ///< true: x y z qw qx qy qz
  std::array<std::atomic<double>, 6> twist{};             ///< true: linear, of the grip's origin, then angular
  std::array<std::atomic<double>, 6> displayed{};         ///< by the motors, as long as it is plugged in: force, torque
  std::array<std::atomic<double>, 6> commanded{};         ///< last one received, before the motors' limits
  std::atomic<double> gripper_force{0.0};                 ///< N, commanded last
  std::array<std::atomic<double>, 8> tensions{};          ///< N, of a SPIDAR's strings
  std::array<std::atomic<double>, 8> let_out_at_reset{};  ///< m, of a SPIDAR's strings, where its counts are zero
  std::atomic<bool> forces_on{false}, gravity_compensated{false}, powered{false};
  std::atomic<double> effector_mass{-1.0};                    ///< kg; -1: nobody set it
  std::atomic<double> limit_force{-1.0}, limit_torque{-1.0};  ///< N, N m, that the library was told; -1: nobody did
  std::atomic<std::int64_t> stepped_at{0};                    ///< ns, up to where the mechanics are integrated
  std::atomic<int> plugged_in{0};                             ///< unplugged_times when it was opened last

  // What was done to it.
  std::atomic<int> opener{0};  ///< process that has it open; stays when that process dies
  std::atomic<std::uint64_t> opens{0}, refused_opens{0}, closes{0}, calls{0}, failed_calls{0}, calibrations{0};
  std::atomic<std::uint64_t> command_count{0};                                ///< received
  std::atomic<std::uint64_t> bad_commands{0};                                 ///< of those, not finite
  std::atomic<std::int64_t> last_command{0};                                  ///< ns
  std::atomic<double> largest_force{0.0}, largest_torque{0.0};                ///< N, N m, of the commands
  std::atomic<double> largest_force_growth{0.0}, largest_torque_growth{0.0};  ///< of the norm, between two commands
  std::array<DoubleCommand, kCommands> commands{};  ///< a ring: command i (from 0) at i % kCommands
};

static_assert(std::atomic<double>::is_always_lock_free && std::atomic<std::int64_t>::is_always_lock_free &&
                  std::atomic<bool>::is_always_lock_free,
              "processes cannot share a lock that is hidden in an atomic");

}  // namespace tegotae::test
