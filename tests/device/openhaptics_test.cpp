// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/interface_remarks.hpp>
#include <tegotae/device/openhaptics.hpp>
#include <tegotae/device/openhaptics_device.hpp>
#include <tegotae/runtime/periodic_timer.hpp>

#include <tests/allocation_counter.hpp>
#include <tests/device/driver_program.hpp>
#include <tests/device/refusal.hpp>
#include <tests/device/waiting.hpp>
#include <tests/doubles/double_state_file.hpp>
#include <tests/lock_counter.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <thread>

namespace tegotae {
namespace {

using test::comes_true;
using test::DoubleStateFile;
using test::HdOddity;
using test::HoldingProbe;
using test::refusal;
using test::run_probe;
using ::testing::AllOf;
using ::testing::HasSubstr;
using Calibrate = OpenHapticsDevice::Calibrate;

std::unique_ptr<HapticInterface> open_stylus(std::string_view options = "") {
  return openhaptics_driver().open(options);
}

std::string refused(std::string_view options = "") {
  return refusal([options] { static_cast<void>(open_stylus(options)); });
}

// A Touch: six degrees in, three out.
class OpenHapticsTest : public ::testing::Test {
 protected:
  OpenHapticsTest() {
    state->degrees = 3;
    state->max_force = 3.3;
  }

  // A tick of a loop that displays `force` (N, along x) where the interface is there.
  InterfaceStatus tick(HapticInterface& interface, double force) const {
    InterfaceState read;
    const InterfaceStatus status = interface.read(1e-9 * static_cast<double>(monotonic_nanoseconds()), read);
    InterfaceCommand command;
    if (status == InterfaceStatus::kOk) command.wrench.force.x() = force;
    interface.write(command);
    return status;
  }
  // Ticks until `condition` holds, a millisecond apart.
  template <class Condition>
  bool ticks_until(HapticInterface& interface, double force, const Condition& condition) const {
    return comes_true([&] {
      tick(interface, force);
      return condition();
    });
  }
  bool is_ok(HapticInterface& interface) const { return tick(interface, 0.0) == InterfaceStatus::kOk; }
  double displayed() const { return state.displayed().force.norm(); }

  DoubleStateFile state{"Touch"};
};

TEST_F(OpenHapticsTest, IsFoundThroughItsLibraryWithoutForce) {
  InterfacePresence found = openhaptics_driver().find();
  EXPECT_THAT(found.library, HasSubstr("libHD.so"));
  ASSERT_EQ(found.devices.size(), 1U);
  EXPECT_THAT(found.devices[0], HasSubstr("Touch"));
  EXPECT_EQ(found.trouble, "");
  EXPECT_EQ(state->command_count, 0U);
  EXPECT_EQ(state->opens, state->closes);
  state.unplug();
  found = openhaptics_driver().find();
  EXPECT_TRUE(found.devices.empty());
  EXPECT_THAT(found.trouble,
              AllOf(HasSubstr("openhaptics: the default device does not answer"), HasSubstr("GTDD_HOME")));
}

TEST_F(OpenHapticsTest, TellsWhatADeviceOfThreeDegreesCanDo) {
  const auto interface = open_stylus();
  const InterfaceCapability capability = interface->capability();
  EXPECT_EQ(capability.name, "Touch");
  EXPECT_EQ(capability.input_degrees_of_freedom, 6);
  EXPECT_EQ(capability.output_degrees_of_freedom, 3);
  EXPECT_EQ(capability.max_force, 3.3);
  EXPECT_EQ(capability.max_torque, 0.0);
  EXPECT_NEAR(capability.max_stiffness, 400.0, 1e-9);
  EXPECT_GE(capability.rate, 10.0);
  EXPECT_EQ(capability.delay, 1.0 / capability.rate) << "a command waits for the next callback";
  EXPECT_NEAR(capability.max_damping, 4.0, 1e-9);
}

TEST_F(OpenHapticsTest, TellsWhatADeviceOfSixDegreesCanDo) {
  state->degrees = 6;
  state->max_force = 8.5;
  state->nominal_stiffness = 800.0;
  EXPECT_NEAR(open_stylus()->capability().max_torque, 0.2, 1e-12);
  const InterfaceCapability capability = open_stylus()->capability();
  EXPECT_NEAR(capability.max_stiffness, 800.0, 1e-9);
  EXPECT_NEAR(capability.max_rotational_stiffness, 2.0, 1e-9);
  EXPECT_NEAR(capability.max_damping, 8.0, 1e-9);
  EXPECT_NEAR(capability.max_rotational_damping, 0.02, 1e-9);
  state->max_torque = 2e3;
  state->nominal_stiffness = 4e5;
  EXPECT_EQ(open_stylus()->capability().max_torque, 0.188) << "in another unit, it seems: not believed";
  EXPECT_EQ(open_stylus()->capability().max_stiffness, 400.0);
  state->oddity = HdOddity::kNoCartesianTorque;
  EXPECT_EQ(open_stylus()->capability().max_torque, 0.0);
  EXPECT_EQ(open_stylus()->capability().output_degrees_of_freedom, 3);
}

TEST_F(OpenHapticsTest, ReadsAndCommands) {
  const auto interface = open_stylus();
  InterfaceState read;
  EXPECT_EQ(interface->read(12.5, read), InterfaceStatus::kOk);
  EXPECT_LT(read.time, 12.5) << "a callback read it before";
  EXPECT_GT(read.time, 12.4);
  state.move_hand({{0.02, 0.03, 0.01}, Quaternion::Identity()});
  EXPECT_TRUE(comes_true([&] {
    interface->read(0.0, read);
    return (read.X_WT.p - Vector3(0.01, 0.02, 0.03)).norm() < 1e-3;
  }));
  state->buttons = 1;
  EXPECT_TRUE(comes_true([&] { return interface->read(0.0, read) == InterfaceStatus::kOk && read.buttons == 1U; }));
  EXPECT_TRUE(ticks_until(*interface, 1.5, [&] { return displayed() == 1.5; }));
  EXPECT_EQ(state.displayed().force.z(), 1.5) << "x of the world is z of the device";
}

TEST_F(OpenHapticsTest, AnotherAxisOfTheDeviceCanPointUp) {
  const auto interface = open_stylus("axes=xyz");
  EXPECT_TRUE(ticks_until(*interface, 1.5, [&] { return state.displayed().force.x() == 1.5; }));
}

TEST_F(OpenHapticsTest, LeavesAtZero) {
  {
    const auto interface = open_stylus();
    ASSERT_TRUE(ticks_until(*interface, 2.0, [&] { return displayed() == 2.0; }));
  }
  EXPECT_EQ(displayed(), 0.0);
  EXPECT_FALSE(state->forces_on);
  EXPECT_EQ(state->opens, state->closes);
  EXPECT_EQ(state.commanded().force.norm(), 0.0) << "by a command, before forces were disabled";
}

TEST_F(OpenHapticsTest, ALoopThatStandsStillIsTakenItsForce) {
  const auto interface = open_stylus();
  ASSERT_TRUE(ticks_until(*interface, 2.0, [&] { return displayed() == 2.0; }));
  ASSERT_TRUE(comes_true([&] { return displayed() == 0.0; }));
  InterfaceState read;
  ASSERT_TRUE(comes_true([&] { return interface->read(0.0, read) == InterfaceStatus::kLost; }));
  InterfaceCommand old;
  old.wrench.force.x() = 2.0;
  const std::uint64_t commands = state->command_count;
  interface->write(old);
  ASSERT_TRUE(comes_true([&] { return state->command_count > commands + 5; }));
  EXPECT_EQ(displayed(), 0.0);
  EXPECT_TRUE(ticks_until(*interface, 2.0, [&] { return displayed() == 2.0; })) << "it goes on from zero";
  EXPECT_EQ(state->opens, 1U);
}

TEST_F(OpenHapticsTest, IsOpenedAgainWhenItIsBackOnItsCable) {
  const auto interface = open_stylus();
  ASSERT_TRUE(ticks_until(*interface, 2.0, [&] { return displayed() == 2.0; }));
  for (std::uint64_t times = 1; times <= 2; ++times) {
    state.unplug();
    ASSERT_TRUE(comes_true([&] { return !is_ok(*interface); }));
    ASSERT_TRUE(ticks_until(*interface, 2.0, [&] { return state->refused_opens >= times; }));
    EXPECT_EQ(displayed(), 0.0);
    state.plug_in();
    ASSERT_TRUE(ticks_until(*interface, 2.0, [&] { return displayed() == 2.0; }));
    EXPECT_EQ(state->opens, 1U + times);
  }
  auto* told = dynamic_cast<InterfaceRemarks*>(interface.get());
  ASSERT_NE(told, nullptr);
  EXPECT_THAT(told->remarks(), HasSubstr("Touch was lost and opened again, times: 2."));
}

TEST_F(OpenHapticsTest, GoesOnWhereACallFailsNowAndThen) {
  const auto interface = open_stylus();
  state->fail_every = 7;
  const std::uint64_t failed = state->failed_calls;
  ASSERT_TRUE(ticks_until(*interface, 1.0, [&] { return state->failed_calls > failed + 50; }));
  EXPECT_EQ(state->opens, 1U);
  EXPECT_TRUE(ticks_until(*interface, 1.0, [&] { return displayed() == 1.0; }));
}

TEST_F(OpenHapticsTest, GivenUpItIsClosedAtZero) {
  const auto interface = open_stylus();
  ASSERT_TRUE(ticks_until(*interface, 2.0, [&] { return displayed() == 2.0; }));
  state->fail_every = 1;  // zero does not reach it by a command either
  ASSERT_TRUE(ticks_until(*interface, 2.0, [&] { return displayed() == 0.0; }));
  state->fail_every = 0;
  EXPECT_TRUE(ticks_until(*interface, 2.0, [&] { return displayed() == 2.0; }));
}

TEST_F(OpenHapticsTest, ASchedulerThatStallsIsLostAndComesBack) {
  const auto interface = open_stylus();
  ASSERT_TRUE(comes_true([&] { return is_ok(*interface); }));
  state->stall = 400;  // ms
  ASSERT_TRUE(ticks_until(*interface, 1.0, [&] { return tick(*interface, 1.0) != InterfaceStatus::kOk; }));
  EXPECT_TRUE(ticks_until(*interface, 1.0, [&] { return displayed() == 1.0; }));
}

// While no callback comes, and before it is lost for that. In one of many tries the test itself stood still for so
// long.
TEST_F(OpenHapticsTest, APoseGrowsOldWhileNoCallbackComes) {
  OpenHapticsDevice device(OpenHapticsLibrary(OpenHapticsLibrary::find()), {}, Calibrate::kYes);
  InterfaceState read;
  const auto age = [&] { return device.read(5.0, read) == DeviceAnswer::kOk ? 5.0 - read.time : -1.0; };
  EXPECT_TRUE(comes_true([&] {
    state->oddity = HdOddity::kNone;
    if (!comes_true([&] { return age() >= 0.0; })) return false;
    state->oddity = HdOddity::kNoCallbacks;
    const double before = age();
    std::this_thread::sleep_for(std::chrono::milliseconds(25));
    return before >= 0.0 && age() > std::max(before, 0.02);
  }));
}

TEST_F(OpenHapticsTest, APoseThatIsNoneIsLostUntilItIsBack) {
  const auto interface = open_stylus();
  state->nan_pose = true;
  ASSERT_TRUE(comes_true([&] { return !is_ok(*interface); }));
  state->nan_pose = false;
  EXPECT_TRUE(comes_true([&] { return is_ok(*interface); }));
  EXPECT_EQ(state->opens, 1U);
}

TEST_F(OpenHapticsTest, CalibratesWhereItsStylusIsInItsInkwell) {
  state->uncalibrated = true;
  const auto interface = open_stylus();
  EXPECT_EQ(state->calibrations, 1U);
  EXPECT_TRUE(is_ok(*interface));
}

TEST_F(OpenHapticsTest, RefusesWhatIsNotCalibrated) {
  state->uncalibrated = true;
  state->cannot_calibrate = true;
  EXPECT_THAT(refused(), AllOf(HasSubstr("'Touch' is not calibrated"), HasSubstr("inkwell")));
  state->cannot_calibrate = false;
  state->oddity = HdOddity::kResetStyle;
  EXPECT_THAT(refused(), HasSubstr("reset position")) << "where it stands is not where it would be reset";
  EXPECT_EQ(state->calibrations, 0U);
  EXPECT_EQ(state->opens, state->closes);
}

TEST_F(OpenHapticsTest, RefusesWhatIsOtherwiseThanKnown) {
  state.place({{0.05, 0.02, 0.0}, Quaternion::Identity()});
  state->oddity = HdOddity::kTransformByRows;
  EXPECT_THAT(refused(), HasSubstr("column by column, in millimetres"));
  state->oddity = HdOddity::kMicrometres;
  EXPECT_THAT(refused(), HasSubstr("column by column, in millimetres"));
  state->oddity = HdOddity::kManyDegrees;
  EXPECT_THAT(refused(), HasSubstr("1000 degrees of freedom"));
  state->oddity = HdOddity::kNone;
  state->max_force = 3300.0;
  EXPECT_THAT(refused(), HasSubstr("3300 N as the greatest force of 'Touch'"));
  EXPECT_EQ(state->opens, state->closes) << "and lets go of it each time";
  EXPECT_EQ(state->largest_force, 0.0);
}

TEST_F(OpenHapticsTest, RefusesASchedulerThatCallsNobody) {
  state->oddity = HdOddity::kNoCallbacks;
  EXPECT_THAT(refused(), HasSubstr("the servo loop of 'Touch' does not run"));
}

TEST_F(OpenHapticsTest, OneNameAtATime) {
  EXPECT_THAT(refused("Omni 7"), HasSubstr("the device 'Omni 7' does not answer"));
  EXPECT_THAT(refused("rate=5"), HasSubstr("openhaptics"));
  EXPECT_THAT(refused("axes=xxz"), HasSubstr("right-handed"));
  const auto interface = open_stylus("Touch");
  EXPECT_THAT(refused(), HasSubstr("has a device open already"));
  EXPECT_TRUE(comes_true([&] { return is_ok(*interface); })) << "which goes on";
}

TEST_F(OpenHapticsTest, BringsToZeroWhatADeadProcessLeft) {
  state->forces_on = true;
  state->displayed[1] = 2.5;
  ASSERT_EQ(displayed(), 2.5);
  EXPECT_TRUE(openhaptics_driver().silence(""));
  EXPECT_EQ(displayed(), 0.0);
  EXPECT_GT(state->command_count, 10U);
  EXPECT_EQ(state->opens, state->closes);
  state.unplug();
  EXPECT_FALSE(openhaptics_driver().silence(""));
  EXPECT_FALSE(openhaptics_driver().silence("axes=1"));
}

TEST_F(OpenHapticsTest, ReadingAndWritingNeitherAllocateNorLock) {
  const auto interface = open_stylus();
  const test::AllocationCounter allocations;
  const test::LockCounter locks;
  for (int i = 0; i < 100; ++i) tick(*interface, 1.0);
  state.unplug();
  for (int i = 0; i < 100; ++i) tick(*interface, 1.0);
  EXPECT_EQ(allocations.count(), 0U);
  EXPECT_EQ(locks.count(), 0U);
}

TEST_F(OpenHapticsTest, CountsAreTold) {
  OpenHapticsDevice device(OpenHapticsLibrary(OpenHapticsLibrary::find()), {}, Calibrate::kYes);
  InterfaceState read;
  EXPECT_EQ(device.remarks(), "");
  state->error_once = hd::kWarmMotors;
  EXPECT_TRUE(comes_true([&] {
    device.read(0.0, read);
    return device.counts().warm_motors == 1U;
  }));
  EXPECT_EQ(device.remarks(), "Touch told of: motors warm 1.");
  state->error_once = 0x0302;
  EXPECT_TRUE(comes_true([&] {
    device.read(0.0, read);
    return device.counts().failed_frames == 1U;
  }));
  EXPECT_EQ(device.remarks(), "Touch told of: motors warm 1, frames that failed 1 (last error 0x0302).");
}

TEST_F(OpenHapticsTest, ADriverThatWasKilledLeavesItsForceUntilSomebodySilencesIt) {
  // In one of many tries the probe stood still just before its death, and the servo loop had taken the force.
  ASSERT_TRUE(comes_true([&] {
    HoldingProbe probe("openhaptics", "openhaptics", "");
    if (!comes_true([&] { return displayed() == 2.0 || !probe.is_running(); })) return false;
    EXPECT_FALSE(openhaptics_driver().silence("")) << "it is another one's";
    probe.kill_it();
    return displayed() == 2.0;
  }));
  EXPECT_TRUE(openhaptics_driver().silence(""));
  EXPECT_EQ(displayed(), 0.0);
  EXPECT_FALSE(state->forces_on);
  EXPECT_EQ(state->opener, 0);
}

TEST_F(OpenHapticsTest, WithoutItsLibraryOrAFunctionOfItSaysSo) {
  EXPECT_THAT(run_probe("", "find openhaptics").text,
              AllOf(HasSubstr("looked for 'libHD.so'\nlooked for 'libHD.so.3.4'\nlooked for 'libHD.so.3.0'\n"),
                    HasSubstr("OpenHaptics (its HD API) was not found"), HasSubstr("3D Systems")));
  const test::ProbeResult incomplete = run_probe("openhaptics-incomplete", "open openhaptics");
  EXPECT_EQ(incomplete.exit_code, 1);
  EXPECT_THAT(incomplete.text, HasSubstr("libHD.so has no function 'hdUpdateCalibration'"));
  EXPECT_EQ(state->opens, 0U);
}

}  // namespace
}  // namespace tegotae
