// SPDX-License-Identifier: Apache-2.0
// What the other tests of drivers rest on: the device behind the makers' test libraries.
#include <tegotae/math/rotation.hpp>

#include <tests/doubles/double_device.hpp>
#include <tests/doubles/double_state_file.hpp>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>

namespace tegotae {
namespace {

using test::DoubleDevice;
using test::DoubleReading;
using test::DoubleStateFile;

Wrench push(double x, double y, double z) { return {{x, y, z}, Vector3::Zero()}; }

constexpr std::int64_t kMillisecond = 1'000'000;  // ns

// A device of its own for each test, on a clock that the test moves.
class DoubleDeviceTest : public ::testing::Test {
 protected:
  DoubleDeviceTest() { file->manual_time.store(1); }
  ~DoubleDeviceTest() override { device.close(); }
  void pass(std::int64_t milliseconds) { file->manual_time.fetch_add(milliseconds * kMillisecond); }

  DoubleStateFile file{"test"};
  DoubleDevice device;
};

TEST_F(DoubleDeviceTest, AFreeGripMovesAsNewtonHasIt) {
  file->hand_stiffness.store(0.0);
  file->hand_damping.store(0.0);
  file->damping.store(0.0);
  ASSERT_TRUE(device.open());
  ASSERT_TRUE(device.set_forces(true));
  ASSERT_TRUE(device.command(push(2.0, 0.0, 0.0), 0.0));
  pass(50);
  DoubleReading reading;
  ASSERT_TRUE(device.read(reading));
  // f t^2 / 2 m and f t / m of 2 N on 0.2 kg in 50 ms.
  EXPECT_NEAR(reading.X.p.x(), 0.0125, 1e-9);
  EXPECT_NEAR(reading.V.linear.x(), 0.5, 1e-9);
  EXPECT_EQ(file.pose().p, reading.X.p);
}

TEST_F(DoubleDeviceTest, TheHandDrawsTheGripToItsTarget) {
  const Pose target{{0.01, -0.02, 0.03}, rotation_from_vector({0.1, 0.0, -0.2})};
  file.move_hand(target);
  ASSERT_TRUE(device.open());
  DoubleReading reading;
  for (int i = 0; i < 40; ++i) {
    pass(50);
    ASSERT_TRUE(device.read(reading));
  }
  EXPECT_LT((reading.X.p - target.p).norm(), 1e-6);
  EXPECT_LT(rotation_vector(reading.X.q * target.q.conjugate()).norm(), 1e-6);
}

TEST_F(DoubleDeviceTest, MotorsClipAndGiveNothingWithForcesOff) {
  file->max_force.store(10.0);
  file->max_torque.store(0.1);
  ASSERT_TRUE(device.open());
  ASSERT_TRUE(device.command(push(1.0, 0.0, 0.0), 0.0));
  EXPECT_EQ(file.displayed().force.norm(), 0.0);
  ASSERT_TRUE(device.set_forces(true));
  ASSERT_TRUE(device.command({{0.0, 30.0, 40.0}, {0.0, 0.0, -1.0}}, 0.25));
  EXPECT_LT((file.displayed().force - Vector3(0.0, 6.0, 8.0)).norm(), 1e-12);
  EXPECT_LT((file.displayed().torque - Vector3(0.0, 0.0, -0.1)).norm(), 1e-12);
  EXPECT_EQ(file->largest_force.load(), 50.0);
  EXPECT_EQ(file->largest_force_growth.load(), 49.0);
  EXPECT_EQ(file->largest_torque.load(), 1.0);
  EXPECT_EQ(file->command_count.load(), 2u);
  EXPECT_EQ(file->commands[1].force[1].load(), 30.0);
  EXPECT_EQ(file->gripper_force.load(), 0.25);
  ASSERT_TRUE(device.set_forces(false));
  EXPECT_EQ(file.displayed().force.norm(), 0.0);
}

TEST_F(DoubleDeviceTest, UnpluggedItGivesNothingAndTheHandleIsDeadForGood) {
  ASSERT_TRUE(device.open());
  ASSERT_TRUE(device.set_forces(true));
  ASSERT_TRUE(device.command(push(1.0, 0.0, 0.0), 0.0));
  file.unplug();
  EXPECT_EQ(file.displayed().force.norm(), 0.0);
  DoubleReading reading;
  EXPECT_FALSE(device.read(reading));
  EXPECT_FALSE(device.open());
  file.plug_in();
  EXPECT_FALSE(device.read(reading));
  EXPECT_FALSE(device.is_open());
  ASSERT_TRUE(device.open());
  EXPECT_TRUE(device.read(reading));
  EXPECT_FALSE(file->forces_on.load());
  EXPECT_EQ(file->refused_opens.load(), 1u);
}

TEST_F(DoubleDeviceTest, FaultsOnDemand) {
  ASSERT_TRUE(device.open());
  DoubleReading reading;
  file->fail_every.store(3);
  int failed = 0;
  for (int i = 0; i < 9; ++i) failed += device.read(reading) ? 0 : 1;
  EXPECT_EQ(failed, 3);
  file->fail_every.store(0);
  file->jump[1].store(0.2);
  ASSERT_TRUE(device.read(reading));
  EXPECT_EQ(reading.X.p.y(), file.pose().p.y() + 0.2);
  file->jump[1].store(0.0);
  file->frozen_pose.store(true);
  ASSERT_TRUE(device.read(reading));
  const Vector3 frozen = reading.X.p;
  file.move_hand({{0.05, 0.0, 0.0}, Quaternion::Identity()});
  pass(100);
  ASSERT_TRUE(device.read(reading));
  EXPECT_EQ(reading.X.p, frozen);
  EXPECT_GT(file.pose().p.x(), 0.01);
  file->nan_pose.store(true);
  ASSERT_TRUE(device.read(reading));
  EXPECT_TRUE(std::isnan(reading.X.p.x()));
}

TEST_F(DoubleDeviceTest, AFirmwareWithAWatchdogDropsTheForceByItself) {
  file->command_timeout.store(20);
  ASSERT_TRUE(device.open());
  ASSERT_TRUE(device.set_forces(true));
  ASSERT_TRUE(device.command(push(1.0, 0.0, 0.0), 0.0));
  DoubleReading reading;
  pass(20);
  ASSERT_TRUE(device.read(reading));
  EXPECT_EQ(file.displayed().force.x(), 1.0);
  pass(1);
  ASSERT_TRUE(device.read(reading));
  EXPECT_EQ(file.displayed().force.x(), 0.0);
}

// Another process, which dies with its force on: the motors go on until somebody opens it and says zero.
TEST_F(DoubleDeviceTest, HoldsTheForceOfADeadProcessAndIsRefusedWhileThatLives) {
  const pid_t child = fork();
  if (child == 0) {
    DoubleDevice theirs;
    const bool done = theirs.open() && theirs.set_forces(true) && theirs.command(push(3.0, 0.0, 0.0), 0.0);
    if (!done) _exit(1);
    for (;;) pause();
  }
  ASSERT_GT(child, 0);
  while (file->command_count.load() == 0 && waitpid(child, nullptr, WNOHANG) == 0) usleep(1000);
  EXPECT_EQ(file->opener.load(), child);
  EXPECT_FALSE(device.open());
  kill(child, SIGKILL);
  siginfo_t information{};
  ASSERT_EQ(waitid(P_PID, static_cast<id_t>(child), &information, WEXITED | WNOWAIT), 0);
  EXPECT_EQ(file.displayed().force.x(), 3.0);
  EXPECT_TRUE(device.open());
  EXPECT_EQ(file.displayed().force.x(), 3.0);
  EXPECT_TRUE(device.command({}, 0.0));
  EXPECT_EQ(file.displayed().force.x(), 0.0);
  waitpid(child, nullptr, 0);
}

}  // namespace
}  // namespace tegotae
