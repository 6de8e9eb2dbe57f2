// SPDX-License-Identifier: Apache-2.0
// The driver of a SPIDAR on a library with the functions of spidar_transport.h, loaded as its owner's would be.
#include <tegotae/device/interface_remarks.hpp>
#include <tegotae/device/spidar_device.hpp>
#include <tegotae/math/rotation.hpp>

#include <tests/allocation_counter.hpp>
#include <tests/device/refusal.hpp>
#include <tests/device/spidar_double.hpp>
#include <tests/device/waiting.hpp>
#include <tests/lock_counter.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <limits>
#include <thread>

namespace tegotae {
namespace {

using test::comes_true;
using test::on_spidar_double;
using test::refusal;
using ::testing::AllOf;
using ::testing::HasSubstr;

constexpr double kPoseStep = 30e-6;  // m, and rad at the knots: rounding to pulses of 17 um, and what the strings give

Wrench spidar_push(double x, double y, double z) { return {{x, y, z}, Vector3::Zero()}; }

// The double's clock stands still, so its grip stays where a test puts it.
class SpidarDeviceTest : public ::testing::Test {
 protected:
  SpidarDeviceTest() { spidar->manual_time = 1; }

  static std::unique_ptr<HapticInterface> open(const std::string& more = "") {
    return spidar_driver().open(on_spidar_double(more));
  }

  test::SpidarDoubleFile spidar;
  InterfaceState state;
};

TEST_F(SpidarDeviceTest, SaysWhatIsThereWithoutOpeningIt) {
  const InterfacePresence found = find_interface(spidar_driver(), on_spidar_double());
  EXPECT_EQ(found.library, std::string(TEGOTAE_DOUBLES) + "/spidar/libmyboard.so");
  EXPECT_EQ(found.trouble, "");
  ASSERT_EQ(found.devices.size(), 1U);
  EXPECT_EQ(spidar->opens, 0U);
  EXPECT_THAT(find_interface(spidar_driver(), "").trouble, HasSubstr("transport=/path/libmyboard.so"));
}

TEST_F(SpidarDeviceTest, ReadsThePoseInTheAxesThatAreAskedFor) {
  const Pose X_SG{{0.01, -0.02, 0.015}, rotation_from_vector({0.2, -0.1, 0.3})};
  const auto interface = open();
  spidar.place(X_SG);
  spidar->buttons = 5;
  ASSERT_EQ(interface->read(0.0, state), InterfaceStatus::kOk);
  EXPECT_LT((state.X_WT.p - X_SG.p).norm(), kPoseStep);
  EXPECT_LT(rotation_vector(state.X_WT.q * X_SG.q.conjugate()).norm(), kPoseStep / 0.0225);
  EXPECT_EQ(state.buttons, 5U);
  EXPECT_EQ(state.time, 0.0);
}

TEST_F(SpidarDeviceTest, RenamesItsAxes) {
  const auto interface = open(",axes=xz-y");  // y up
  spidar.place({{0.01, -0.02, 0.015}, rotation_from_vector({0.2, -0.1, 0.3})});
  ASSERT_EQ(interface->read(0.0, state), InterfaceStatus::kOk);
  EXPECT_LT((state.X_WT.p - Vector3(0.01, 0.015, 0.02)).norm(), kPoseStep);
  EXPECT_LT((rotation_vector(state.X_WT.q) - Vector3(0.2, 0.3, 0.1)).norm(), kPoseStep / 0.0225);
  ASSERT_EQ(interface->write({spidar_push(1.0, 2.0, 3.0), 0.0}), InterfaceStatus::kOk);
  EXPECT_LT((spidar.commanded().force - Vector3(1.0, -3.0, 2.0)).norm(), 1e-2);
}

// Off the middle as well: the driver knows the pose to some micrometres only, so a part in a thousand.
TEST_F(SpidarDeviceTest, DisplaysTheWrenchByItsTensions) {
  const auto interface = open();
  spidar.place({{0.008, 0.004, -0.01}, rotation_from_vector({0.1, 0.1, 0.0})});
  ASSERT_EQ(interface->read(0.0, state), InterfaceStatus::kOk);
  const Wrench wanted{{1.0, -2.0, 3.0}, {0.02, -0.01, 0.03}};
  ASSERT_EQ(interface->write({wanted, 0.0}), InterfaceStatus::kOk);
  EXPECT_LT((spidar.displayed().force - wanted.force).norm(), 5e-3);
  EXPECT_LT((spidar.displayed().torque - wanted.torque).norm(), 1e-4);
  for (std::size_t i = 0; i < 8; ++i) EXPECT_GE(spidar.tension(i), 0.3 - 1e-12);
}

TEST_F(SpidarDeviceTest, WhatIsNotFiniteIsLeastTensions) {
  const auto interface = open();
  ASSERT_EQ(interface->read(0.0, state), InterfaceStatus::kOk);
  interface->write({spidar_push(std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0), 0.0});
  EXPECT_DOUBLE_EQ(spidar.greatest_tension(), 0.3);
  EXPECT_EQ(spidar->bad_commands, 0U);
}

TEST_F(SpidarDeviceTest, IsHeldToTheStiffnessThatIsSaid) {
  const InterfaceCapability usual = open()->capability();
  EXPECT_EQ(usual.name, "spidar-g6:x3r");
  EXPECT_NEAR(usual.max_force, 23.6, 0.1);
  EXPECT_EQ(usual.max_stiffness, 1000.0);
  EXPECT_DOUBLE_EQ(usual.max_damping, 10.0);
  EXPECT_EQ(open(",stiffness=3000")->capability().max_stiffness, 3000.0);
  EXPECT_EQ(open(",rate=500")->capability().rate, 500.0);
}

TEST_F(SpidarDeviceTest, ClosingTakesTheCurrentOffTheMotors) {
  {
    const auto interface = open();
    ASSERT_EQ(interface->read(0.0, state), InterfaceStatus::kOk);
    interface->write({spidar_push(5.0, 0.0, 0.0), 0.0});
    EXPECT_GT(spidar.greatest_tension(), 1.0);
  }
  EXPECT_EQ(spidar.greatest_tension(), 0.0);
  EXPECT_FALSE(spidar->forces_on);
  EXPECT_EQ(spidar->closes, 1U);
}

TEST_F(SpidarDeviceTest, ABoardThatKnowsHowOldItsCountsAreDatesThePose) {
  const auto interface = open();
  spidar->reading_age = 4'000'000;
  ASSERT_EQ(interface->read(1.0, state), InterfaceStatus::kOk);
  EXPECT_DOUBLE_EQ(state.time, 1.0 - 4e-3);
}

// Counts that were never measured, say: they must not pass for new ones.
TEST_F(SpidarDeviceTest, AnAgeThatIsNoneIsLost) {
  const auto interface = open();
  ASSERT_EQ(interface->read(0.0, state), InterfaceStatus::kOk);
  spidar->reading_age = INT64_MAX;
  EXPECT_EQ(interface->read(1e-3, state), InterfaceStatus::kLost);
  spidar->reading_age = 0;
  EXPECT_EQ(interface->read(2e-3, state), InterfaceStatus::kOk);
}

TEST_F(SpidarDeviceTest, CountsThatFitNoPoseAreLostButTheBoardIsKept) {
  const auto interface = open();
  spidar->slip[3] = 2000.0;
  for (int i = 0; i < 50; ++i) EXPECT_EQ(interface->read(1e-3 * i, state), InterfaceStatus::kLost);
  EXPECT_DOUBLE_EQ(spidar.greatest_tension(), 0.3);
  spidar->slip[3] = 0.0;
  EXPECT_EQ(interface->read(0.1, state), InterfaceStatus::kOk);
  EXPECT_EQ(spidar->opens, 1U);
}

TEST_F(SpidarDeviceTest, RefusesWhatCannotBe) {
  const auto with = [](const std::string& options) { return refusal([&] { spidar_driver().open(options); }); };
  EXPECT_THAT(with("x3r"), AllOf(HasSubstr("spidar-g6:x3r: no transport"), HasSubstr("spidar.md")));
  EXPECT_THAT(with("x9,transport=a.so"), HasSubstr("'x9' is neither a SPIDAR that has a name"));
  EXPECT_THAT(with("x3f,transport=a.so"), HasSubstr("x3f"));
  EXPECT_THAT(with("x3r,transport=/none/a.so"), AllOf(HasSubstr("was not found"), HasSubstr("/none/a.so")));
  EXPECT_THAT(with(on_spidar_double(",axes=xzy")), HasSubstr("does not name a right-handed turn"));
  EXPECT_THAT(with(on_spidar_double(",zero=there")), HasSubstr("none of here|kept"));
  EXPECT_THAT(with(on_spidar_double(",volts=3")), HasSubstr("no option 'volts'"));
  EXPECT_THAT(with(on_spidar_double(",board=board 8")),
              HasSubstr("'board 8' cannot be opened (no board of that name)"));
  spidar->strings = 4;
  EXPECT_THAT(with(on_spidar_double()), HasSubstr("has 4 strings"));
  EXPECT_EQ(spidar->opener, 0);
  spidar->strings = 8;
  spidar->cannot_calibrate = true;
  EXPECT_THAT(with(on_spidar_double()), HasSubstr("does not answer"));
  EXPECT_EQ(spidar->opener, 0);
}

TEST_F(SpidarDeviceTest, ALibraryOfAnotherVersionOrWithoutAFunctionIsRefused) {
  EXPECT_THAT(find_interface(spidar_driver(), on_spidar_double("", "spidar-incomplete")).trouble,
              HasSubstr("libmyboard.so has no function 'tegotae_spidar_stop'"));
  spidar->library_major = 7;
  EXPECT_THAT(refusal([] { open(); }),
              AllOf(HasSubstr("made for version 7 of spidar_transport.h"), HasSubstr("this program speaks version 1")));
  spidar->library_major = 0;
  spidar->sharing = 3;
  EXPECT_THAT(refusal([] { open(); }), HasSubstr("tegotae_spidar_sharing"));
  EXPECT_EQ(spidar->opens, 0U);
}

TEST_F(SpidarDeviceTest, AnotherProcessMayStopItWhereTheLibrarySaysSo) {
  EXPECT_EQ(rescue_of(spidar_driver(), on_spidar_double()).time, RescueTime::kAfterDeath);
  spidar->sharing = TEGOTAE_SPIDAR_ANY_TIME;
  EXPECT_EQ(rescue_of(spidar_driver(), on_spidar_double()).time, RescueTime::kAnyTime);
  spidar->sharing = TEGOTAE_SPIDAR_NEVER;
  const InterfaceRescue never = rescue_of(spidar_driver(), on_spidar_double());
  EXPECT_EQ(never.time, RescueTime::kNever);
  EXPECT_THAT(never.after_a_crash, HasSubstr("watchdog"));
  EXPECT_FALSE(spidar_driver().silence(on_spidar_double()));
  EXPECT_EQ(spidar->opens, 0U);
}

// The guard may be needed hours after its file was read.
TEST_F(SpidarDeviceTest, ItIsStoppedAlsoWhereTheFileOfItsGeometryIsGone) {
  std::string options = on_spidar_double();
  options.replace(0, 3, "/none/geometry.txt");
  EXPECT_THROW(spidar_driver().open(options), InterfaceError);
  EXPECT_TRUE(spidar_driver().silence(options));
  EXPECT_EQ(spidar->opens, 1U);
  EXPECT_FALSE(spidar_driver().silence("x3r")) << "no library";
}

// While its counts are no numbers they never stand.
TEST_F(SpidarDeviceTest, WaitsUntilTheGripIsHeldStill) {
  spidar->nan_pose = true;
  std::unique_ptr<HapticInterface> interface;
  std::thread opening([&] { interface = spidar_driver().open(on_spidar_double(",hold=0.05")); });
  EXPECT_TRUE(comes_true([&] { return spidar->calls > 50; }));
  EXPECT_EQ(spidar->calibrations, 0U);
  EXPECT_DOUBLE_EQ(spidar.greatest_tension(), 0.3) << "the strings are pulled taut";
  spidar->nan_pose = false;
  opening.join();
  ASSERT_NE(interface, nullptr);
  EXPECT_EQ(spidar->calibrations, 1U);
}

TEST_F(SpidarDeviceTest, ReadingAndWritingTakeNoMemoryAndNoLock) {
  const auto interface = open();
  const test::AllocationCounter allocations;
  const test::LockCounter locks;
  for (int i = 0; i < 100; ++i) {
    interface->read(1e-3 * i, state);
    interface->write({spidar_push(1.0, 0.0, 0.0), 0.0});
  }
  EXPECT_EQ(allocations.count(), 0U);
  EXPECT_EQ(locks.count(), 0U);
}

// A board on the mains: its cable goes, its counters stay.
TEST_F(SpidarDeviceTest, UnpluggedItIsLostAndComesBackWithItsZero) {
  const auto interface = open();
  ASSERT_EQ(interface->read(0.0, state), InterfaceStatus::kOk);
  spidar.unplug();
  for (int i = 0; i < 50; ++i) {
    EXPECT_EQ(interface->read(1e-3 * i, state), InterfaceStatus::kLost);
    EXPECT_EQ(interface->write({}), InterfaceStatus::kLost);
  }
  const Pose X_SG{{0.01, 0.0, -0.01}, Quaternion::Identity()};
  ASSERT_TRUE(comes_true([&] { return spidar->refused_opens > 0; }));
  spidar.place(X_SG);
  spidar.plug_in();
  ASSERT_TRUE(comes_true([&] { return interface->read(0.0, state) == InterfaceStatus::kOk; }));
  EXPECT_LT((state.X_WT.p - X_SG.p).norm(), kPoseStep);
  EXPECT_EQ(spidar->calibrations, 1U);
}

// Where the hand holds it then nobody knows.
TEST_F(SpidarDeviceTest, ComingBackWithoutItsZeroItStaysLostUntilItIsCalibrated) {
  const auto interface = open();
  spidar.unplug();
  for (int i = 0; i < 50; ++i) interface->read(1e-3 * i, state);
  ASSERT_TRUE(comes_true([&] { return spidar->refused_opens > 0; }));
  spidar->uncalibrated = true;
  spidar.plug_in();
  ASSERT_TRUE(comes_true([&] { return spidar->closes > 1; }));
  EXPECT_EQ(interface->read(0.0, state), InterfaceStatus::kLost);
  EXPECT_EQ(spidar.greatest_tension(), 0.0);
  EXPECT_EQ(spidar->calibrations, 1U);
  spidar->uncalibrated = false;
  EXPECT_TRUE(comes_true([&] { return interface->read(0.0, state) == InterfaceStatus::kOk; }));
}

TEST_F(SpidarDeviceTest, AZeroThatIsLostWhileItRunsIsLeastTensions) {
  const auto interface = open();
  ASSERT_EQ(interface->read(0.0, state), InterfaceStatus::kOk);
  interface->write({spidar_push(5.0, 0.0, 0.0), 0.0});
  spidar->uncalibrated = true;
  EXPECT_EQ(interface->read(1e-3, state), InterfaceStatus::kLost);
  EXPECT_DOUBLE_EQ(spidar.greatest_tension(), 0.3);
  EXPECT_THAT(dynamic_cast<InterfaceRemarks&>(*interface).remarks(), HasSubstr("lost their zero"));
}

TEST_F(SpidarDeviceTest, AnEarlierZeroIsKeptOnlyWhereTheBoardHasIt) {
  static_cast<void>(open());
  EXPECT_EQ(spidar->calibrations, 1U);
  const Pose X_SG{{0.0, 0.02, 0.0}, Quaternion::Identity()};
  spidar.place(X_SG);
  const auto interface = open(",zero=kept");
  ASSERT_EQ(interface->read(0.0, state), InterfaceStatus::kOk);
  EXPECT_LT((state.X_WT.p - X_SG.p).norm(), kPoseStep);
  EXPECT_EQ(spidar->calibrations, 1U);
  spidar->uncalibrated = true;
  EXPECT_THAT(refusal([] { open(",zero=kept"); }), HasSubstr("lost their zero"));
}

}  // namespace
}  // namespace tegotae
