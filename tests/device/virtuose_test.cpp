// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/virtuose.hpp>
#include <tegotae/device/virtuose_device.hpp>
#include <tegotae/math/rotation.hpp>

#include <tests/allocation_counter.hpp>
#include <tests/device/refusal.hpp>
#include <tests/device/waiting.hpp>
#include <tests/doubles/double_state_file.hpp>
#include <tests/lock_counter.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <limits>

namespace tegotae {
namespace {

using test::comes_true;
using test::DoubleStateFile;
using test::refusal;
using ::testing::AllOf;
using ::testing::EndsWith;
using ::testing::HasSubstr;

constexpr double kSingle = 1e-7;  // the API speaks in single precision; relative

Wrench virtuose_push(double x, double y, double z) { return {{x, y, z}, Vector3::Zero()}; }

// An arm whose controller answers to "arm.local#5125", at a pose of no symmetry; its clock stands still.
class VirtuoseTest : public ::testing::Test {
 protected:
  VirtuoseTest() {
    arm->max_force.store(30.0);
    arm->max_torque.store(3.0);
    arm->manual_time.store(1);
    arm.place(X_DG);
    const double speeds[] = {0.1, -0.2, 0.3, -1.0, 2.0, -3.0};
    for (std::size_t i = 0; i < 6; ++i) arm->twist[i].store(speeds[i]);
  }
  void SetUp() override {
    ASSERT_THAT(driver.find().library, ::testing::StartsWith(TEGOTAE_DOUBLES)) << "this would drive a real device";
  }

  static std::unique_ptr<HapticInterface> open(const std::string& options = "") {
    return virtuose_driver().open("arm.local#5125" + options);
  }

  bool stays_lost(HapticInterface& interface) {
    for (int i = 0; i < 2 * VirtuoseDevice::kReleased; ++i) {
      if (interface.read(0.0, state) != InterfaceStatus::kLost) return false;
    }
    return true;
  }
  bool reads_after_a_tick(HapticInterface& interface) {
    interface.read(0.0, state);
    return interface.read(0.0, state) == InterfaceStatus::kOk;
  }

  const InterfaceDriver& driver = virtuose_driver();
  const Pose X_DG{{0.3, 0.02, -0.1}, rotation_from_vector({0.3, -0.2, 0.5})};
  DoubleStateFile arm{"arm.local#5125"};
  InterfaceState state;
};

TEST_F(VirtuoseTest, FindsTheLibraryAndAsksForAnAddress) {
  const InterfacePresence found = driver.find();
  EXPECT_THAT(found.library, EndsWith("virtuose/virtuoseAPI.so"));
  EXPECT_THAT(found.devices, ::testing::IsEmpty());
  EXPECT_THAT(found.trouble, HasSubstr("name the address"));
  EXPECT_THAT(refusal([&] { driver.open(""); }), HasSubstr("give the address of the device's controller"));
  EXPECT_EQ(arm->opens.load(), 0u);
}

TEST_F(VirtuoseTest, RefusesOtherVersionsOfTheApi) {
  arm->library_major.store(3);
  arm->library_minor.store(98);
  for (const std::string& sentence : {refusal([] { open(); }), driver.find().trouble}) {
    EXPECT_THAT(sentence, AllOf(HasSubstr("calls itself version 3.98"), HasSubstr("only version 4"), EndsWith(".")));
  }
  EXPECT_EQ(arm->opens.load(), 0u);
  EXPECT_FALSE(driver.silence("arm.local#5125"));
}

TEST_F(VirtuoseTest, ReportsPoseWithTheQuaternionsScalarInItsPlace) {
  const auto interface = open();
  ASSERT_EQ(interface->read(0.25, state), InterfaceStatus::kOk);
  EXPECT_EQ(state.time, 0.25);
  EXPECT_LT((state.X_WT.p - X_DG.p).norm(), kSingle);
  EXPECT_LT(rotation_vector(state.X_WT.q * X_DG.q.conjugate()).norm(), 3 * kSingle);
  EXPECT_NEAR(state.X_WT.q.norm(), 1.0, 1e-12);
  EXPECT_LT((state.V_WT.linear - Vector3(0.1, -0.2, 0.3)).norm(), kSingle);
  EXPECT_LT((state.V_WT.angular - Vector3(-1.0, 2.0, -3.0)).norm(), 4 * kSingle);
}

TEST_F(VirtuoseTest, CommandsTheWrenchForceFirst) {
  const auto interface = open();
  ASSERT_EQ(interface->write({{{1.0, 2.0, 3.0}, {0.1, 0.2, 0.3}}, 0.0}), InterfaceStatus::kOk);
  EXPECT_LT((arm.displayed().force - Vector3(1.0, 2.0, 3.0)).norm(), kSingle);
  EXPECT_LT((arm.displayed().torque - Vector3(0.1, 0.2, 0.3)).norm(), kSingle);
}

TEST_F(VirtuoseTest, RenamesAxesWhereAskedTo) {
  const auto interface = open(",axes=y-xz");
  ASSERT_EQ(interface->read(0.0, state), InterfaceStatus::kOk);
  EXPECT_LT((state.X_WT.p - Vector3(0.02, -0.3, -0.1)).norm(), kSingle);
  EXPECT_LT((rotation_vector(state.X_WT.q) - Vector3(-0.2, -0.3, 0.5)).norm(), 4 * kSingle);
  ASSERT_EQ(interface->write({virtuose_push(1.0, 2.0, 3.0), 0.0}), InterfaceStatus::kOk);
  EXPECT_EQ(arm.displayed().force, Vector3(-2.0, 1.0, 3.0));
}

TEST_F(VirtuoseTest, AButtonIsTheBitOfItsNumberWhicheverIsTheFirst) {
  for (const int first : {0, 1}) {
    arm->first_button.store(first);
    arm->button_count.store(3);
    const auto interface = open();
    for (const unsigned buttons : {0u, 1u, 4u, 7u}) {
      arm->buttons.store(buttons);
      ASSERT_EQ(interface->read(0.0, state), InterfaceStatus::kOk);
      EXPECT_EQ(state.buttons, buttons << first);
    }
  }
}

TEST_F(VirtuoseTest, QueriesThatFailWhileItIsOpenedShiftNoButton) {
  for (const int failing : {1, 8, 12}) {
    arm->failed_buttons.store(failing);
    const auto interface = open();
    arm->buttons.store(2);
    ASSERT_EQ(interface->read(0.0, state), InterfaceStatus::kOk);
    EXPECT_EQ(state.buttons, 2u) << failing;
  }
}

TEST_F(VirtuoseTest, TheControllerClipsToTheLimitsOfTheOptions) {
  const auto interface = open(",max-force=8,max-torque=0.5,period=0.002");
  EXPECT_EQ(interface->capability().max_force, 8.0);
  EXPECT_EQ(interface->capability().max_torque, 0.5);
  EXPECT_EQ(interface->capability().rate, 500.0);
  EXPECT_DOUBLE_EQ(interface->capability().max_rotational_stiffness, 2.5);
  EXPECT_DOUBLE_EQ(interface->capability().max_damping, 10.0);
  EXPECT_DOUBLE_EQ(interface->capability().max_rotational_damping, 0.025);
  ASSERT_EQ(interface->write({{{0.0, 20.0, 0.0}, {0.0, 0.0, 2.0}}, 0.0}), InterfaceStatus::kOk);
  EXPECT_NEAR(arm.displayed().force.y(), 8.0, 8.0 * kSingle);
  EXPECT_NEAR(arm.displayed().torque.z(), 0.5, kSingle);
}

TEST_F(VirtuoseTest, WhatIsNotFiniteIsDisplayedAsZero) {
  const auto interface = open();
  ASSERT_EQ(interface->write({virtuose_push(1.0, 0.0, 0.0), 0.0}), InterfaceStatus::kOk);
  ASSERT_EQ(interface->write({virtuose_push(std::numeric_limits<double>::infinity(), 0.0, 0.0), 0.0}),
            InterfaceStatus::kOk);
  EXPECT_EQ(arm.commanded().force.norm(), 0.0);
  EXPECT_EQ(arm->bad_commands.load(), 0u);
}

TEST_F(VirtuoseTest, ClosesWithZeroAndWithoutPower) {
  {
    const auto interface = open();
    EXPECT_TRUE(arm->powered.load());
    EXPECT_EQ(arm->largest_force.load(), 0.0);
    interface->write({virtuose_push(1.0, 0.0, 0.0), 0.0});
  }
  EXPECT_EQ(arm.commanded().force.norm(), 0.0);
  EXPECT_FALSE(arm->powered.load());
  EXPECT_FALSE(arm->forces_on.load());
  EXPECT_EQ(arm->closes.load(), 1u);
}

TEST_F(VirtuoseTest, RefusesAnAddressThatDoesNotAnswerAndOptionsThatAreNone) {
  EXPECT_THAT(refusal([&] { driver.open("nobody"); }),
              AllOf(HasSubstr("the controller at nobody cannot be opened (communication failure)"), EndsWith(".")));
  EXPECT_THAT(refusal([] { open(",axes=left"); }), HasSubstr("'left' does not name"));
  EXPECT_THAT(refusal([] { open(",period=1"); }), HasSubstr("period=1 is no number from 0.001 to 0.01"));
  EXPECT_THAT(refusal([] { open(",force=3"); }), HasSubstr("no option 'force'"));
}

TEST_F(VirtuoseTest, RefusesToStartWithTheEmergencyStopPressed) {
  arm->emergency_stop.store(true);
  EXPECT_THAT(refusal([] { open(); }), HasSubstr("the emergency stop is pressed"));
  EXPECT_FALSE(arm->powered.load());
  EXPECT_EQ(arm->opener.load(), 0);
}

TEST_F(VirtuoseTest, WithoutPowerItIsLostAndGoesOnWithoutOpeningAnew) {
  const auto interface = open();
  ASSERT_EQ(interface->read(0.0, state), InterfaceStatus::kOk);
  arm->hand_off.store(true);
  for (int i = 0; i < 50; ++i) EXPECT_EQ(interface->read(0.0, state), InterfaceStatus::kLost);
  arm->hand_off.store(false);
  EXPECT_EQ(interface->read(0.0, state), InterfaceStatus::kOk);
  EXPECT_EQ(arm->opens.load(), 1u);
}

// The force would come back in one step.
TEST_F(VirtuoseTest, TheOffsetButtonNeitherSilencesTheForceNorGoesUnseen) {
  const auto interface = open();
  ASSERT_EQ(interface->write({virtuose_push(1.0, 0.0, 0.0), 0.0}), InterfaceStatus::kOk);
  arm->offset_button.store(true);
  EXPECT_EQ(interface->read(0.0, state), InterfaceStatus::kLost) << "so the loop commands zero and begins its ramp";
  ASSERT_EQ(interface->write({virtuose_push(1.0, 0.0, 0.0), 0.0}), InterfaceStatus::kOk);
  EXPECT_EQ(arm.displayed().force.x(), 1.0) << "the command alone says what is displayed";
  arm->offset_button.store(false);
  EXPECT_EQ(interface->read(0.0, state), InterfaceStatus::kOk);
  EXPECT_EQ(arm->opens.load(), 1u);
}

TEST_F(VirtuoseTest, AfterAnEmergencyStopPowerWaitsForAButton) {
  const auto interface = open();
  ASSERT_EQ(interface->write({virtuose_push(1.0, 0.0, 0.0), 0.0}), InterfaceStatus::kOk);
  arm->buttons.store(1);  // held all the time
  arm->emergency_stop.store(true);
  EXPECT_TRUE(stays_lost(*interface));
  EXPECT_EQ(arm.commanded().force.norm(), 0.0);
  arm->emergency_stop.store(false);
  EXPECT_TRUE(stays_lost(*interface)) << "the chain closed";
  EXPECT_FALSE(arm->powered.load());
  arm->buttons.store(0);
  arm->failed_buttons.store(20);
  EXPECT_TRUE(stays_lost(*interface));
  arm->buttons.store(2);
  EXPECT_TRUE(reads_after_a_tick(*interface)) << "pressed after the chain closed";
  EXPECT_TRUE(arm->powered.load());
  EXPECT_EQ(arm->opens.load(), 1u);
}

TEST_F(VirtuoseTest, AButtonThatIsHeldIsNotPressedWhereAskingForItFails) {
  const auto interface = open();
  arm->buttons.store(1);
  arm->emergency_stop.store(true);
  interface->read(0.0, state);
  arm->emergency_stop.store(false);
  EXPECT_TRUE(stays_lost(*interface));
  arm->failed_buttons.store(20);  // ten readings of two buttons
  EXPECT_TRUE(stays_lost(*interface));
  EXPECT_FALSE(arm->powered.load());
}

TEST_F(VirtuoseTest, AfterAnEmergencyStopPowerSwitchedOnAtTheDeviceIsEnough) {
  const auto interface = open();
  arm->emergency_stop.store(true);
  EXPECT_TRUE(stays_lost(*interface));
  arm->powered.store(true);  // its switch says so, and the chain keeps it off
  EXPECT_TRUE(stays_lost(*interface));
  arm->powered.store(true);
  arm->emergency_stop.store(false);
  EXPECT_TRUE(stays_lost(*interface)) << "power that comes by itself with the chain is switched off";
  EXPECT_FALSE(arm->powered.load());
  arm->powered.store(true);
  EXPECT_TRUE(reads_after_a_tick(*interface));
}

TEST_F(VirtuoseTest, AnEmergencyStopIsNotForgottenWhereTheDeviceIsOpenedAnew) {
  const auto interface = open();
  arm->emergency_stop.store(true);
  EXPECT_TRUE(stays_lost(*interface));
  arm.unplug();
  arm->emergency_stop.store(false);
  EXPECT_TRUE(stays_lost(*interface));
  arm.plug_in();
  ASSERT_TRUE(comes_true([&] { return interface->read(0.0, state), arm->opens.load() >= 2; }));
  for (int i = 0; i < 3; ++i) EXPECT_TRUE(stays_lost(*interface));
  EXPECT_FALSE(arm->powered.load());
  // The thread that opens it hands it over a moment after.
  ASSERT_TRUE(comes_true([&] {
    arm->buttons.store(0);
    if (!stays_lost(*interface)) return false;
    arm->buttons.store(1);
    return reads_after_a_tick(*interface);
  }));
  EXPECT_TRUE(arm->powered.load());
}

TEST_F(VirtuoseTest, UnpluggedItIsLostAndComesBack) {
  const auto interface = open();
  arm.unplug();
  for (int i = 0; i < 50; ++i) {
    EXPECT_EQ(interface->read(0.0, state), InterfaceStatus::kLost);
    EXPECT_EQ(interface->write({virtuose_push(1.0, 0.0, 0.0), 0.0}), InterfaceStatus::kLost);
  }
  arm.plug_in();
  ASSERT_TRUE(comes_true([&] { return interface->read(0.0, state) == InterfaceStatus::kOk; }));
  EXPECT_EQ(arm.displayed().force.norm(), 0.0);
  ASSERT_EQ(interface->write({virtuose_push(2.0, 0.0, 0.0), 0.0}), InterfaceStatus::kOk);
  EXPECT_EQ(arm.displayed().force.x(), 2.0);
}

TEST_F(VirtuoseTest, ReadingAndWritingTakeNoMemoryAndNoLock) {
  const auto interface = open();
  const test::AllocationCounter allocations;
  const test::LockCounter locks;
  for (int i = 0; i < 100; ++i) {
    interface->read(1e-3 * i, state);
    interface->write({virtuose_push(1.0, 0.0, 0.0), 0.0});
  }
  EXPECT_EQ(allocations.count(), 0u);
  EXPECT_EQ(locks.count(), 0u);
}

}  // namespace
}  // namespace tegotae
