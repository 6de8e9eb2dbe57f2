// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/spacenav.hpp>
#include <tegotae/device/spacenav_device.hpp>

#include <tests/allocation_counter.hpp>
#include <tests/device/driver_program.hpp>
#include <tests/device/refusal.hpp>
#include <tests/device/waiting.hpp>
#include <tests/doubles/double_state_file.hpp>
#include <tests/lock_counter.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace tegotae {
namespace {

using test::comes_true;
using test::DoubleStateFile;
using test::refusal;
using ::testing::AllOf;
using ::testing::HasSubstr;

std::unique_ptr<HapticInterface> open_mouse(std::string_view options = "") { return spacenav_driver().open(options); }
std::string refused_mouse(std::string_view options = "") {
  return refusal([options] { static_cast<void>(open_mouse(options)); });
}

class SpacenavTest : public ::testing::Test {
 protected:
  // Reads, a millisecond of the loop's time later each, until `condition` of the state holds.
  template <class Condition>
  bool reads_until(HapticInterface& interface, const Condition& condition) {
    return comes_true([&] {
      time_ += 1e-3;
      InterfaceState read;
      return interface.read(time_, read) == InterfaceStatus::kOk && condition(read);
    });
  }
  bool is_lost(HapticInterface& interface) {
    InterfaceState read;
    return interface.read(time_, read) == InterfaceStatus::kLost;
  }

  DoubleStateFile state{"SpaceMouse"};

 private:
  double time_ = 0.0;
};

TEST_F(SpacenavTest, IsFoundWhereItsDaemonAnswers) {
  InterfacePresence found = spacenav_driver().find();
  EXPECT_THAT(found.library, HasSubstr("libspnav.so.0"));
  EXPECT_EQ(found.devices.size(), 1U);
  EXPECT_EQ(found.trouble, "");
  EXPECT_EQ(state->opens, state->closes);
  state.unplug();
  found = spacenav_driver().find();
  EXPECT_TRUE(found.devices.empty());
  EXPECT_THAT(found.trouble, AllOf(HasSubstr("spacenavd does not answer"), HasSubstr("systemctl start spacenavd")));
  EXPECT_EQ(refused_mouse(), found.trouble);
}

TEST_F(SpacenavTest, DisplaysNothing) {
  const auto interface = open_mouse();
  const InterfaceCapability capability = interface->capability();
  EXPECT_EQ(capability.input_degrees_of_freedom, 6);
  EXPECT_EQ(capability.output_degrees_of_freedom, 0);
  EXPECT_EQ(capability.max_force, 0.0);
  EXPECT_EQ(capability.max_torque, 0.0);
  EXPECT_EQ(interface->write({Wrench{Vector3(1.0, 2.0, 3.0), Vector3::Zero()}, 0.0}), InterfaceStatus::kOk);
  EXPECT_EQ(state->command_count, 0U);
}

TEST_F(SpacenavTest, MovesWithTheMouseAndStops) {
  const auto interface = open_mouse("speed=0.2");
  state->deflection[2] = 350;  // away
  EXPECT_TRUE(reads_until(*interface, [](const InterfaceState& read) { return read.X_WT.p.y() > 0.05; }));
  EXPECT_TRUE(reads_until(*interface, [](const InterfaceState& read) {
    return (read.V_WT.linear - Vector3(0.0, 0.2, 0.0)).norm() < 1e-6;
  }));
  state->deflection[2] = 0;
  EXPECT_TRUE(reads_until(*interface, [](const InterfaceState& read) { return read.V_WT.linear.norm() < 1e-9; }));
}

TEST_F(SpacenavTest, FollowsAnOffsetAndTurns) {
  const auto interface = open_mouse("mode=offset,reach=0.1,tilt=0.5,dead-zone=0");
  state->deflection[0] = -175;
  state->deflection[4] = 350;
  EXPECT_TRUE(reads_until(*interface, [](const InterfaceState& read) {
    return (read.X_WT.p - Vector3(-0.05, 0.0, 0.0)).norm() < 1e-6 &&
           read.X_WT.q.angularDistance(Quaternion(Eigen::AngleAxisd(0.5, Vector3::UnitZ()))) < 1e-6;
  }));
}

TEST_F(SpacenavTest, TellsItsButtons) {
  const auto interface = open_mouse();
  state->buttons = 5;
  EXPECT_TRUE(reads_until(*interface, [](const InterfaceState& read) { return read.buttons == 5U; }));
  state->buttons = 4;
  EXPECT_TRUE(reads_until(*interface, [](const InterfaceState& read) { return read.buttons == 4U; }));
}

TEST_F(SpacenavTest, GoesOnWhereItWasWhenTheDaemonIsBack) {
  const auto interface = open_mouse();
  state->deflection[0] = 350;
  double reached = 0.0;
  ASSERT_TRUE(reads_until(*interface, [&](const InterfaceState& read) { return (reached = read.X_WT.p.x()) > 0.05; }));
  state.unplug();
  ASSERT_TRUE(comes_true([&] { return is_lost(*interface); }));
  state->deflection[0] = 0;
  ASSERT_TRUE(comes_true([&] { return is_lost(*interface) && state->refused_opens > 0U; }));
  state.plug_in();
  ASSERT_TRUE(reads_until(*interface, [](const InterfaceState&) { return true; }));
  InterfaceState read;
  interface->read(0.0, read);
  EXPECT_GE(read.X_WT.p.x(), reached);
  EXPECT_EQ(state->opens, 2U);
}

TEST_F(SpacenavTest, RefusesOptionsThatAreNone) {
  EXPECT_THAT(refused_mouse("left"), HasSubstr("spacenav: 'left' is no option"));
  EXPECT_THAT(refused_mouse("mode=fast"), HasSubstr("spacenav"));
  EXPECT_THAT(refused_mouse("speed=0"), HasSubstr("spacenav"));
  EXPECT_THAT(refused_mouse("dead-zone=1"), HasSubstr("spacenav"));
  EXPECT_THAT(refused_mouse("axes=xzy"), HasSubstr("right-handed"));
  EXPECT_THAT(refused_mouse("colour=red"), HasSubstr("colour"));
  EXPECT_EQ(state->opens, 0U);
  const auto interface = open_mouse();
  EXPECT_THAT(refused_mouse(), HasSubstr("listens to the daemon already"));
}

TEST_F(SpacenavTest, WithoutItsLibrarySaysWhatToInstall) {
  const std::string text = test::run_probe("", "find spacenav").text;
  if (text.find("library ''") == std::string::npos) GTEST_SKIP() << "libspnav is installed here";
  EXPECT_THAT(text, AllOf(HasSubstr("looked for 'libspnav.so.0'"), HasSubstr("sudo apt install libspnav0 spacenavd")));
}

TEST_F(SpacenavTest, ReadingNeitherAllocatesNorLocks) {
  const auto interface = open_mouse();
  state->deflection[0] = 350;
  ASSERT_TRUE(reads_until(*interface, [](const InterfaceState& read) { return read.X_WT.p.x() > 0.01; }));
  const test::AllocationCounter allocations;
  const test::LockCounter locks;
  InterfaceState read;
  for (int i = 0; i < 100; ++i) {
    interface->read(1e-3 * i, read);
    interface->write({});
  }
  EXPECT_EQ(allocations.count(), 0U);
  EXPECT_EQ(locks.count(), 0U);
}

}  // namespace
}  // namespace tegotae
