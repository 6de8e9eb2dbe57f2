// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/force_dimension.hpp>
#include <tegotae/device/force_dimension_device.hpp>
#include <tegotae/math/rotation.hpp>

#include <tests/allocation_counter.hpp>
#include <tests/device/refusal.hpp>
#include <tests/device/waiting.hpp>
#include <tests/doubles/double_state_file.hpp>
#include <tests/lock_counter.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace tegotae {
namespace {

using test::comes_true;
using test::DoubleStateFile;
using test::refusal;
using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;

// A sigma.7 on the cable, which has all there is, in an orientation and at a place of no symmetry. Its clock stands
// still, so that it stays there.
class ForceDimensionTest : public ::testing::Test {
 protected:
  ForceDimensionTest() {
    sigma->has_gripper.store(true);
    sigma->manual_time.store(1);
    sigma.place(X_DG);
    const double speeds[] = {0.1, -0.2, 0.3, -1.0, 2.0, -3.0};
    for (std::size_t i = 0; i < 6; ++i) sigma->twist[i].store(speeds[i]);
  }

  // The library is the test's, whatever is installed: nothing that a test does may move a real device.
  void SetUp() override {
    ASSERT_THAT(driver.find().library, ::testing::StartsWith(TEGOTAE_DOUBLES)) << "this would drive a real device";
  }

  static std::unique_ptr<HapticInterface> open(const char* options = "") {
    return force_dimension_driver().open(options);
  }

  const InterfaceDriver& driver = force_dimension_driver();
  const Pose X_DG{{0.01, 0.02, -0.03}, rotation_from_vector({0.3, -0.2, 0.5})};
  DoubleStateFile sigma{"sigma.7"};
  InterfaceState state;
};

TEST_F(ForceDimensionTest, FindsADeviceWithoutTouchingIt) {
  sigma->uncalibrated.store(true);
  const InterfacePresence found = driver.find();
  EXPECT_THAT(found.library, EndsWith("force-dimension/libdrd.so"));
  EXPECT_THAT(found.looked_for, ::testing::ElementsAre("libdrd.so"));
  ASSERT_EQ(found.devices.size(), 1u);
  EXPECT_THAT(found.devices[0], HasSubstr("force-dimension:0"));
  EXPECT_EQ(found.trouble, "");
  EXPECT_EQ(sigma->opens.load(), 0u);
  EXPECT_EQ(sigma->calibrations.load(), 0u);
}

TEST_F(ForceDimensionTest, SaysWhereNoneIsOnTheCable) {
  sigma.unplug();
  EXPECT_THAT(driver.find().trouble, AllOf(HasSubstr("no device is seen"), HasSubstr("vendor 1451")));
  EXPECT_THAT(refusal([] { open(); }), AllOf(HasSubstr("force-dimension: a device cannot be opened (no device found)"),
                                             HasSubstr("cable"), EndsWith(".")));
}

TEST_F(ForceDimensionTest, ReportsPoseTwistButtonsAndGripperInItsOwnAxes) {
  sigma->buttons.store(5);
  sigma->gripper.store(0.021);
  const auto interface = open();
  ASSERT_EQ(interface->read(0.25, state), InterfaceStatus::kOk);
  EXPECT_EQ(state.time, 0.25);
  EXPECT_EQ(state.X_WT.p, X_DG.p);
  EXPECT_LT(rotation_vector(state.X_WT.q * X_DG.q.conjugate()).norm(), 1e-15);
  EXPECT_EQ(state.V_WT.linear, Vector3(0.1, -0.2, 0.3));
  EXPECT_EQ(state.V_WT.angular, Vector3(-1.0, 2.0, -3.0));
  EXPECT_EQ(state.buttons, 5u);
  EXPECT_EQ(state.gripper, 0.021);
}

// x towards the person, y right, z up becomes x right, y away, z up.
TEST_F(ForceDimensionTest, RenamesAxesWhereAskedTo) {
  const auto interface = open("0,axes=y-xz");
  ASSERT_EQ(interface->read(0.0, state), InterfaceStatus::kOk);
  EXPECT_EQ(state.X_WT.p, Vector3(0.02, -0.01, -0.03));
  EXPECT_LT((rotation_vector(state.X_WT.q) - Vector3(-0.2, -0.3, 0.5)).norm(), 1e-15);
  EXPECT_EQ(state.V_WT.linear, Vector3(-0.2, -0.1, 0.3));
  EXPECT_EQ(state.V_WT.angular, Vector3(2.0, 1.0, -3.0));
  ASSERT_EQ(interface->write({{{1.0, 2.0, 3.0}, {0.01, 0.02, 0.03}}, 0.0}), InterfaceStatus::kOk);
  EXPECT_EQ(sigma.commanded().force, Vector3(-2.0, 1.0, 3.0));
  EXPECT_EQ(sigma.commanded().torque, Vector3(-0.02, 0.01, 0.03));
}

TEST_F(ForceDimensionTest, CommandsTheWrenchAsItIsAndTheGripperOfBothHands) {
  for (const bool left_handed : {false, true}) {
    sigma->left_handed.store(left_handed);
    const auto interface = open();
    ASSERT_EQ(interface->write({{{1.0, 2.0, 3.0}, {0.01, 0.02, 0.03}}, 0.5}), InterfaceStatus::kOk);
    EXPECT_EQ(sigma.commanded().force, Vector3(1.0, 2.0, 3.0));
    EXPECT_EQ(sigma.commanded().torque, Vector3(0.01, 0.02, 0.03));
    EXPECT_EQ(sigma->gripper_force.load(), 0.5) << left_handed;
  }
}

TEST_F(ForceDimensionTest, ResultsAboveZeroAreNoErrors) {
  const auto interface = open();
  // The double says now and then that it was asked too fast (1), and that its motors are at their limit (2).
  for (int i = 0; i < 50; ++i) {
    ASSERT_EQ(interface->read(1e-3 * i, state), InterfaceStatus::kOk);
    ASSERT_EQ(interface->write({{{100.0, 0.0, 0.0}, Vector3::Zero()}, 0.0}), InterfaceStatus::kOk);
  }
  EXPECT_EQ(sigma.displayed().force.x(), 12.0);
}

TEST_F(ForceDimensionTest, WhatIsNotFiniteIsDisplayedAsZero) {
  const auto interface = open();
  ASSERT_EQ(interface->write({{{1.0, 0.0, 0.0}, Vector3::Zero()}, 0.0}), InterfaceStatus::kOk);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  ASSERT_EQ(interface->write({{{nan, 0.0, 0.0}, Vector3::Zero()}, 0.0}), InterfaceStatus::kOk);
  EXPECT_EQ(sigma.commanded().force.norm(), 0.0);
  ASSERT_EQ(interface->write({{{1.0, 0.0, 0.0}, Vector3::Zero()}, nan}), InterfaceStatus::kOk);
  EXPECT_EQ(sigma.commanded().force.norm(), 0.0);
  EXPECT_EQ(sigma->bad_commands.load(), 0u);
  sigma->nan_pose.store(true);
  ASSERT_EQ(interface->read(0.0, state), InterfaceStatus::kOk);
  EXPECT_FALSE(state.X_WT.is_finite());  // the safety stage's to refuse
}

TEST_F(ForceDimensionTest, AFrameThatIsNoRotationIsNotBelieved) {
  const auto interface = open();
  sigma->bad_frame.store(true);
  EXPECT_EQ(interface->read(0.0, state), InterfaceStatus::kLost);
  sigma->bad_frame.store(false);
  EXPECT_EQ(interface->read(0.0, state), InterfaceStatus::kOk);
}

TEST_F(ForceDimensionTest, OpensWithForcesOnAtZeroAndClosesWithForcesOff) {
  {
    const auto interface = open("gravity-compensation=on,effector-mass=0.15");
    EXPECT_TRUE(sigma->forces_on.load());
    EXPECT_EQ(sigma->largest_force.load(), 0.0);
    EXPECT_TRUE(sigma->gravity_compensated.load());
    EXPECT_EQ(sigma->effector_mass.load(), 0.15);
    EXPECT_EQ(sigma->limit_force.load(), 12.0);
    EXPECT_EQ(sigma->limit_torque.load(), 0.2);
    EXPECT_EQ(sigma->calibrations.load(), 0u);
    interface->write({{{1.0, 0.0, 0.0}, Vector3::Zero()}, 0.0});
  }
  EXPECT_EQ(sigma.commanded().force.norm(), 0.0);
  EXPECT_FALSE(sigma->forces_on.load());
  EXPECT_EQ(sigma->closes.load(), 1u);
  { const auto interface = open("gravity-compensation=off"); }
  EXPECT_FALSE(sigma->gravity_compensated.load());
}

TEST_F(ForceDimensionTest, CalibratesADeviceThatIsNot) {
  sigma->uncalibrated.store(true);
  EXPECT_THAT(refusal([] { open("auto-init=off"); }), HasSubstr("is not calibrated and may not move by itself"));
  EXPECT_EQ(sigma->closes.load(), 1u);
  EXPECT_EQ(sigma->calibrations.load(), 0u);
  const auto interface = open();
  EXPECT_EQ(sigma->calibrations.load(), 1u);
  EXPECT_EQ(interface->read(0.0, state), InterfaceStatus::kOk);
}

TEST_F(ForceDimensionTest, RefusesADeviceThatCannotBeCalibratedAndLetsGoOfIt) {
  sigma->uncalibrated.store(true);
  sigma->cannot_calibrate.store(true);
  EXPECT_THAT(refusal([] { open(); }), HasSubstr("cannot calibrate itself (the arm cannot move freely)"));
  EXPECT_FALSE(sigma->forces_on.load());
  EXPECT_EQ(sigma->opener.load(), 0);
}

TEST_F(ForceDimensionTest, RefusesADeviceThatAnotherProcessHas) {
  sigma->opener.store(1);  // the first process of all lives
  EXPECT_THAT(refusal([] { open(); }), HasSubstr("no other program has it"));
}

TEST_F(ForceDimensionTest, RefusesOptionsThatAreNone) {
  EXPECT_THAT(refusal([] { open("first"); }), HasSubstr("'first' is no number of a device"));
  EXPECT_THAT(refusal([] { open("7"); }), HasSubstr("device 7 cannot be opened"));
  EXPECT_THAT(refusal([] { open("axes=yxz"); }), HasSubstr("'yxz' does not name a right-handed turn"));
  EXPECT_THAT(refusal([] { open("effector-mass=10"); }), HasSubstr("no number from 0 to 1"));
  EXPECT_THAT(refusal([] { open("gravity=off"); }), HasSubstr("no option 'gravity'"));
  EXPECT_EQ(sigma->opens.load(), 0u);
}

TEST_F(ForceDimensionTest, WithoutAWristNothingTurns) {
  sigma->degrees.store(3);
  const auto interface = open();
  EXPECT_EQ(interface->capability().input_degrees_of_freedom, 3);
  EXPECT_EQ(interface->capability().output_degrees_of_freedom, 3);
  EXPECT_EQ(interface->capability().max_torque, 0.0);
  ASSERT_EQ(interface->read(0.0, state), InterfaceStatus::kOk);
  EXPECT_EQ(state.X_WT.p, X_DG.p);
  EXPECT_TRUE(state.X_WT.q.isApprox(Quaternion::Identity()));
  EXPECT_EQ(state.V_WT.angular.norm(), 0.0);
  ASSERT_EQ(interface->write({{{1.0, 0.0, 0.0}, {0.1, 0.0, 0.0}}, 0.0}), InterfaceStatus::kOk);
  EXPECT_EQ(sigma.commanded().force.x(), 1.0);
  EXPECT_EQ(sigma.commanded().torque.norm(), 0.0);
}

TEST_F(ForceDimensionTest, AWristWithoutMotorsIsMeasuredAlone) {
  sigma->degrees.store(3);
  sigma->has_passive_wrist.store(true);
  const auto interface = open();
  EXPECT_EQ(interface->capability().input_degrees_of_freedom, 6);
  EXPECT_EQ(interface->capability().output_degrees_of_freedom, 3);
  EXPECT_EQ(interface->capability().max_torque, 0.0);
  ASSERT_EQ(interface->read(0.0, state), InterfaceStatus::kOk);
  EXPECT_LT(rotation_vector(state.X_WT.q * X_DG.q.conjugate()).norm(), 1e-15);
}

// The double's clock goes on with the loop's; its grip moves in a hand that is elsewhere.
TEST_F(ForceDimensionTest, APoseThatFreezesInMotionIsDatedBackToItsLastChange) {
  sigma.move_hand({{0.2, 0.02, -0.03}, X_DG.q});
  const auto interface = open();
  int tick = 0;
  const auto age = [&] {
    ++tick;
    sigma->manual_time.store(1 + std::int64_t{1'000'000} * tick);
    EXPECT_EQ(interface->read(1e-3 * tick, state), InterfaceStatus::kOk);
    return 1e-3 * tick - state.time;
  };
  for (int i = 0; i < 60; ++i) ASSERT_EQ(age(), 0.0);
  ASSERT_GT(state.V_WT.linear.norm(), 0.05);
  sigma->frozen_pose.store(true);
  age();  // the reading that freezes may still be new
  for (int i = 1; i < 25; ++i) ASSERT_EQ(age(), 0.0) << i;
  for (int i = 0; i < 10; ++i) age();
  const double first = age();
  EXPECT_GT(first, PoseAge::kLongestStill);
  EXPECT_NEAR(age(), first + 1e-3, 1e-9);
  sigma->frozen_pose.store(false);
  EXPECT_EQ(age(), 0.0);
}

TEST_F(ForceDimensionTest, APoseThatRestsIsNew) {
  for (auto& each : sigma->twist) each.store(0.0);
  sigma->frozen_pose.store(true);
  const auto interface = open();
  for (int i = 0; i < 100; ++i) {
    ASSERT_EQ(interface->read(1e-3 * i, state), InterfaceStatus::kOk);
    ASSERT_EQ(state.time, 1e-3 * i);
  }
}

TEST(ForceDimensionCapability, IsThatOfTheModel) {
  const InterfaceCapability sigma = force_dimension_capability("sigma.7", true, true);
  EXPECT_EQ(sigma.name, "force-dimension:sigma.7");
  EXPECT_EQ(sigma.max_force, 12.0);
  EXPECT_EQ(sigma.max_torque, 0.2);
  EXPECT_EQ(sigma.max_stiffness, 4000.0);
  EXPECT_DOUBLE_EQ(sigma.max_rotational_stiffness, 10.0);
  EXPECT_DOUBLE_EQ(sigma.max_damping, 25.0);
  EXPECT_DOUBLE_EQ(sigma.max_rotational_damping, 0.0625);
  EXPECT_EQ(force_dimension_capability("lambda.7", true, true).max_stiffness, 8000.0);
  EXPECT_EQ(force_dimension_capability("omega.6", true, false).max_torque, 0.0);
  EXPECT_EQ(force_dimension_capability("delta.3", false, false).max_force, 20.0);
  EXPECT_EQ(force_dimension_capability("FALCON", false, false).max_force, 8.0);
  const InterfaceCapability unknown = force_dimension_capability("gamma.9", true, true);
  EXPECT_EQ(unknown.max_force, 5.0);
  EXPECT_EQ(unknown.max_torque, 0.1);
  EXPECT_EQ(unknown.max_stiffness, 1000.0);
}

TEST_F(ForceDimensionTest, ARefusedCallIsLostForItsTickAlone) {
  const auto interface = open();
  sigma->fail_every.store(7);
  int lost = 0;
  for (int i = 0; i < 700; ++i) {
    const bool read = interface->read(1e-3 * i, state) == InterfaceStatus::kOk;
    const bool written = interface->write({}) == InterfaceStatus::kOk;
    lost += read && written ? 0 : 1;
  }
  EXPECT_GT(lost, 100);
  EXPECT_LT(lost, 500);
  EXPECT_EQ(sigma->opens.load(), 1u);
  sigma->fail_every.store(0);
  EXPECT_EQ(interface->read(1.0, state), InterfaceStatus::kOk);
}

TEST_F(ForceDimensionTest, UnpluggedItIsLostAndComesBack) {
  const auto interface = open();
  ASSERT_EQ(interface->write({{{1.0, 0.0, 0.0}, Vector3::Zero()}, 0.0}), InterfaceStatus::kOk);
  sigma.unplug();
  for (int i = 0; i < 50; ++i) {
    EXPECT_EQ(interface->read(1e-3 * i, state), InterfaceStatus::kLost);
    EXPECT_EQ(interface->write({}), InterfaceStatus::kLost);
  }
  ASSERT_TRUE(comes_true([&] { return sigma->refused_opens.load() > 0; }));
  sigma->uncalibrated.store(true);
  sigma.plug_in();
  // It is opened, found without calibration, and let go of: nothing moves by itself under a hand.
  ASSERT_TRUE(comes_true([&] { return sigma->closes.load() > 1; }));
  EXPECT_EQ(sigma->calibrations.load(), 0u);
  EXPECT_EQ(interface->read(0.0, state), InterfaceStatus::kLost);
  sigma->uncalibrated.store(false);
  ASSERT_TRUE(comes_true([&] { return interface->read(0.0, state) == InterfaceStatus::kOk; }));
  EXPECT_EQ(sigma.displayed().force.norm(), 0.0);
  ASSERT_EQ(interface->write({{{2.0, 0.0, 0.0}, Vector3::Zero()}, 0.0}), InterfaceStatus::kOk);
  EXPECT_EQ(sigma.displayed().force.x(), 2.0);
}

TEST_F(ForceDimensionTest, AnotherDeviceOfTheSameModelIsNotTakenForTheLostOne) {
  sigma->serial_number.store(217);
  const auto interface = open();
  EXPECT_EQ(interface->capability().name, "force-dimension:sigma.7 (serial number 217)");
  sigma.unplug();
  for (int i = 0; i < 50; ++i) interface->read(1e-3 * i, state);
  sigma->serial_number.store(218);
  sigma.plug_in();
  ASSERT_TRUE(comes_true([&] { return sigma->closes.load() > 1; }));
  EXPECT_EQ(interface->read(0.0, state), InterfaceStatus::kLost);
  EXPECT_FALSE(sigma->forces_on.load());
  sigma->serial_number.store(217);
  EXPECT_TRUE(comes_true([&] { return interface->read(0.0, state) == InterfaceStatus::kOk; }));
}

TEST_F(ForceDimensionTest, ReadingAndWritingTakeNoMemoryAndNoLock) {
  const auto interface = open();
  const test::AllocationCounter allocations;
  const test::LockCounter locks;
  for (int i = 0; i < 100; ++i) {
    interface->read(1e-3 * i, state);
    interface->write({{{1.0, 0.0, 0.0}, Vector3::Zero()}, 0.0});
  }
  EXPECT_EQ(allocations.count(), 0u);
  EXPECT_EQ(locks.count(), 0u);
}

}  // namespace
}  // namespace tegotae
