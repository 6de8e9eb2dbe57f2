// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/openhaptics_servo.hpp>
#include <tegotae/math/rotation.hpp>

#include <tests/allocation_counter.hpp>
#include <tests/device/waiting.hpp>
#include <tests/doubles/double_state_file.hpp>
#include <tests/lock_counter.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace tegotae {
namespace {

using test::DoubleStateFile;
using test::HdOddity;

constexpr int kReadingFails = 0x0302;  // an error of the HD API's: the device does not answer

// The double's library with the test in the place of its scheduler.
class OpenHapticsServoTest : public ::testing::Test {
 protected:
  OpenHapticsServoTest() {
    device = library.init_device(nullptr);
    library.enable(hd::kForceOutput);
  }
  ~OpenHapticsServoTest() override { library.disable_device(device); }

  // One callback, as it answers.
  static unsigned call(OpenHapticsServo& servo) { return OpenHapticsServo::callback(&servo); }
  static OpenHapticsSample after(OpenHapticsServo& servo, int callbacks = 1) {
    for (int i = 0; i < callbacks; ++i) call(servo);
    servo.samples().update();
    return servo.samples().get();
  }
  double displayed() const { return state.displayed().force.norm(); }
  static PlainWrench push(double force) { return Wrench{Vector3(force, 0.0, 0.0), Vector3::Zero()}; }

  DoubleStateFile state{"Touch"};
  OpenHapticsLibrary library{OpenHapticsLibrary::find()};
  hd::Handle device = hd::kInvalidHandle;
  OpenHapticsServo servo{library, 0, AxisMap("zxy"), true};
};

TEST_F(OpenHapticsServoTest, ReadsMillimetresColumnByColumnInTheWorldsAxes) {
  state->manual_time = 1;  // nothing moves
  const Quaternion q_DG(Eigen::AngleAxisd(0.7, Vector3(0.36, 0.48, 0.8)));
  state.place({{0.03, 0.07, -0.11}, q_DG});
  state->twist[0] = 0.1;
  state->twist[1] = 0.2;
  state->twist[2] = -0.3;
  state->buttons = 2;
  const OpenHapticsSample sample = after(servo);
  ASSERT_TRUE(sample.is_plausible);
  // x towards the person, y to the right, z up.
  EXPECT_LT((sample.X_WT.p.vector() - Vector3(-0.11, 0.03, 0.07)).norm(), 1e-12);
  EXPECT_LT((sample.V_WT.linear.vector() - Vector3(-0.3, 0.1, 0.2)).norm(), 1e-12);
  EXPECT_NEAR(std::abs(sample.X_WT.pose().q.dot(Quaternion(q_DG.w(), q_DG.z(), q_DG.x(), q_DG.y()))), 1.0, 1e-12);
  EXPECT_EQ(sample.buttons, 2U);
  EXPECT_EQ(sample.counts.frames, 1U);
}

TEST_F(OpenHapticsServoTest, TurnsAreDifferencesOfThePose) {
  state->hand_stiffness = state->hand_rotational_stiffness = 0.0;
  state->hand_damping = state->hand_rotational_damping = 0.0;
  state->damping = state->rotational_damping = 0.0;
  library.disable_device(device);
  device = library.init_device(nullptr);  // which takes the new mechanics
  const Vector3 w_D(0.5, -1.0, 2.0);
  for (std::size_t i = 0; i < 3; ++i) state->twist[3 + i] = w_D[static_cast<int>(i)];
  // Within 5 %, where nothing stopped the test between the reading and its time.
  EXPECT_TRUE(
      test::comes_true([&] { return (after(servo).V_WT.angular.vector() - Vector3(2.0, 0.5, -1.0)).norm() < 0.1; }));
}

TEST_F(OpenHapticsServoTest, CommandsNewtonsAndMillinewtonMetresInTheDevicesAxes) {
  state->max_force = 10.0;
  state->max_torque = 1.0;
  call(servo);
  servo.commands().write(Wrench{Vector3(1.0, 2.0, 3.0), Vector3(0.1, 0.2, 0.3)});
  call(servo);
  EXPECT_LT((state.commanded().force - Vector3(2.0, 3.0, 1.0)).norm(), 1e-12);
  EXPECT_LT((state.commanded().torque - Vector3(0.2, 0.3, 0.1)).norm(), 1e-12);
  EXPECT_LT((state.displayed().force - Vector3(2.0, 3.0, 1.0)).norm(), 1e-12);
}

TEST_F(OpenHapticsServoTest, TorqueIsLeftOutWhereTheLibraryDoesNotTakeIt) {
  state->oddity = HdOddity::kNoCartesianTorque;
  const OpenHapticsSample sample = after(servo, 5);
  EXPECT_FALSE(servo.turns());
  EXPECT_EQ(sample.counts.failed_frames, 0U);
  servo.commands().write(Wrench{Vector3(1.0, 0.0, 0.0), Vector3(0.1, 0.0, 0.0)});
  EXPECT_FALSE(after(servo).has_failed);
  EXPECT_EQ(state.commanded().torque.norm(), 0.0);
  EXPECT_EQ(state.commanded().force.norm(), 1.0);
}

TEST_F(OpenHapticsServoTest, WithholdsACommandThatNoOtherFollows) {
  servo.commands().write(push(2.0));
  OpenHapticsSample sample = after(servo, OpenHapticsServo::kPatience);
  EXPECT_EQ(displayed(), 2.0);
  EXPECT_FALSE(sample.is_withheld);
  sample = after(servo);
  EXPECT_EQ(displayed(), 0.0) << "after as many callbacks as it says";
  EXPECT_TRUE(sample.is_withheld);
  EXPECT_EQ(sample.counts.withheld, 1U);
  servo.commands().write(push(2.0));
  EXPECT_TRUE(after(servo).is_withheld) << "the haptic thread must begin from zero";
  EXPECT_EQ(displayed(), 0.0);
  servo.commands().write({});
  EXPECT_FALSE(after(servo).is_withheld);
  servo.commands().write(push(0.5));
  EXPECT_FALSE(after(servo).is_withheld);
  EXPECT_EQ(displayed(), 0.5);
}

TEST_F(OpenHapticsServoTest, WithholdsNothingFromAThreadThatCommandsNothingOrGoesOn) {
  servo.commands().write({});
  EXPECT_FALSE(after(servo, 10 * OpenHapticsServo::kPatience).is_withheld);
  for (int i = 0; i < 10; ++i) {
    servo.commands().write(push(1.0));
    ASSERT_FALSE(after(servo, OpenHapticsServo::kPatience).is_withheld);
    ASSERT_EQ(displayed(), 1.0);
  }
}

TEST_F(OpenHapticsServoTest, CountsErrorsThatAreNone) {
  for (const unsigned code : {hd::kWarmMotors, hd::kExceededForce, hd::kExceededImpulse, hd::kExceededVelocity,
                              hd::kForceError, hd::kForceError}) {
    state->error_once = static_cast<int>(code);
    servo.commands().write(push(1.0));
    ASSERT_EQ(call(servo), hd::kCallbackContinue);
    ASSERT_EQ(displayed(), 1.0);
  }
  const OpenHapticsCounts counts = after(servo).counts;
  EXPECT_EQ(counts.warm_motors, 1U);
  EXPECT_EQ(counts.exceeded_force, 1U);
  EXPECT_EQ(counts.exceeded_impulse, 1U);
  EXPECT_EQ(counts.exceeded_velocity, 1U);
  EXPECT_EQ(counts.force_errors, 2U);
  EXPECT_EQ(counts.failed_frames, 0U);
  EXPECT_EQ(counts.frames, 7U);
}

TEST_F(OpenHapticsServoTest, AFrameThatFailsIsNotBelievedAndThreeOnEndAreTheEnd) {
  OpenHapticsSample sample = after(servo);
  const std::int64_t time = sample.time;
  for (int i = 1; i < OpenHapticsServo::kMostFailedFrames; ++i) {
    state->error_once = kReadingFails;
    ASSERT_EQ(call(servo), hd::kCallbackContinue);
  }
  servo.samples().update();
  sample = servo.samples().get();
  EXPECT_EQ(sample.time, time);
  EXPECT_EQ(sample.counts.failed_frames, 2U);
  EXPECT_EQ(sample.counts.last_failure, 0x0302U);
  EXPECT_FALSE(sample.has_failed);
  EXPECT_FALSE(sample.is_withheld) << "there was nothing to take back";
  EXPECT_GT(after(servo).time, time) << "not on end";
  for (int i = 1; i < OpenHapticsServo::kMostFailedFrames; ++i) {
    state->error_once = kReadingFails;
    ASSERT_EQ(call(servo), hd::kCallbackContinue);
  }
  state->error_once = kReadingFails;
  EXPECT_EQ(call(servo), hd::kCallbackDone);
  EXPECT_TRUE(servo.has_ended());
  servo.samples().update();
  EXPECT_TRUE(servo.samples().get().has_failed);
}

TEST_F(OpenHapticsServoTest, AFrameThatFailsCommandsZeroAndSoDoTheOthersUntilTheHapticThreadDid) {
  servo.commands().write(push(2.0));
  call(servo);
  ASSERT_EQ(displayed(), 2.0);
  state->error_once = kReadingFails;
  servo.commands().write(push(2.1));
  EXPECT_TRUE(after(servo).is_withheld);
  EXPECT_EQ(displayed(), 0.0);
  for (int i = 0; i < 3; ++i) {
    servo.commands().write(push(2.1));
    EXPECT_TRUE(after(servo).is_withheld);
    EXPECT_EQ(displayed(), 0.0) << "it would be a blow";
  }
  servo.commands().write({});
  EXPECT_FALSE(after(servo).is_withheld);
  servo.commands().write(push(0.5));
  call(servo);
  EXPECT_EQ(displayed(), 0.5);
}

TEST_F(OpenHapticsServoTest, IsGivenUpAtZeroWhateverIsCommandedMeanwhile) {
  servo.commands().write(push(4.0));
  call(servo);
  ASSERT_GT(displayed(), 3.0);
  for (int i = 1; i <= OpenHapticsServo::kMostFailedFrames; ++i) {
    servo.commands().write(i == 2 ? PlainWrench{} : push(4.0));
    state->error_once = kReadingFails;
    ASSERT_EQ(call(servo), i < OpenHapticsServo::kMostFailedFrames ? hd::kCallbackContinue : hd::kCallbackDone);
    ASSERT_EQ(displayed(), 0.0) << i;
  }
  EXPECT_EQ(state.commanded().force.norm(), 0.0);
}

// Reading goes well, sending does not, so that the frame is known to have failed after it was ended.
TEST_F(OpenHapticsServoTest, TheFrameAfterOneWhoseSendingFailedCommandsZero) {
  servo.commands().write(push(2.0));
  call(servo);
  ASSERT_EQ(displayed(), 2.0);
  state->fail_every = 2;
  servo.commands().write(push(2.0));
  if (after(servo).counts.failed_frames == 0) FAIL() << "neither the reading nor the command failed";
  state->fail_every = 0;
  servo.commands().write(push(2.0));
  EXPECT_TRUE(after(servo).is_withheld);
  EXPECT_EQ(displayed(), 0.0);
}

TEST_F(OpenHapticsServoTest, APoseThatIsNoneIsToldAsSuch) {
  EXPECT_TRUE(after(servo).is_plausible);
  state->nan_pose = true;
  const OpenHapticsSample sample = after(servo);
  EXPECT_FALSE(sample.is_plausible);
  EXPECT_TRUE(sample.X_WT.pose().is_finite());
  state->nan_pose = false;
  EXPECT_TRUE(after(servo).is_plausible);
  state->oddity = HdOddity::kTransformByRows;
  state.place({{0.05, 0.0, 0.0}, Quaternion::Identity()});
  EXPECT_FALSE(after(servo).is_plausible);
}

TEST_F(OpenHapticsServoTest, CommandsZeroForWhatIsNotFiniteAndInTheEnd) {
  servo.commands().write(push(std::numeric_limits<double>::quiet_NaN()));
  call(servo);
  EXPECT_EQ(displayed(), 0.0);
  servo.commands().write(push(1.0));
  call(servo);
  EXPECT_EQ(displayed(), 1.0);
  servo.end();
  EXPECT_FALSE(servo.has_ended());
  EXPECT_EQ(call(servo), hd::kCallbackDone);
  EXPECT_EQ(displayed(), 0.0);
  EXPECT_TRUE(servo.has_ended());
  EXPECT_EQ(state->bad_commands, 0U);
}

TEST_F(OpenHapticsServoTest, NeitherAllocatesNorLocks) {
  call(servo);
  const test::AllocationCounter allocations;
  const test::LockCounter locks;
  for (int i = 0; i < 100; ++i) {
    servo.commands().write(push(1.0));
    call(servo);
  }
  EXPECT_EQ(allocations.count(), 0U);
  EXPECT_EQ(locks.count(), 0U);
}

std::array<double, 16> transform_of(const Matrix3& R, const Vector3& p_mm) {
  std::array<double, 16> transform{};
  for (std::size_t column = 0; column < 3; ++column) {
    for (std::size_t row = 0; row < 3; ++row) {
      transform[4 * column + row] = R(static_cast<int>(row), static_cast<int>(column));
    }
    transform[12 + column] = p_mm[static_cast<int>(column)];
  }
  transform[15] = 1.0;
  return transform;
}

TEST(OpenHapticsTransform, MustBeARigidMotionInMillimetres) {
  const Matrix3 R = rotation_from_vector(Vector3(0.3, -0.4, 0.5)).toRotationMatrix();
  Vector3 p;
  Matrix3 found;
  EXPECT_TRUE(rigid_motion_of(transform_of(R, {10.0, 20.0, 30.0}), p, found));
  EXPECT_LT((p - Vector3(0.01, 0.02, 0.03)).norm(), 1e-15);
  EXPECT_EQ(found, R);
  EXPECT_FALSE(rigid_motion_of(transform_of(R, {10.0, 2001.0, 30.0}), p, found)) << "out of reach";
  EXPECT_FALSE(rigid_motion_of(transform_of(1.01 * R, Vector3::Zero()), p, found)) << "scaled";
  EXPECT_FALSE(rigid_motion_of(transform_of(-R, Vector3::Zero()), p, found)) << "a mirror";
  EXPECT_FALSE(rigid_motion_of({}, p, found));
  std::array<double, 16> other = transform_of(R, Vector3::Zero());
  other[3] = 0.5;
  EXPECT_FALSE(rigid_motion_of(other, p, found)) << "something in the last row";
}

}  // namespace
}  // namespace tegotae
