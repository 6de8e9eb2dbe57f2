// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/guided_motion.hpp>
#include <tegotae/math/rotation.hpp>

#include <tests/allocation_counter.hpp>

#include <gtest/gtest.h>

#include <atomic>
#include <cmath>
#include <thread>

namespace tegotae {
namespace {

constexpr double kPeriod = 1e-3;  // s

Pose at_x(double x) { return {{x, 0.0, 0.0}, Quaternion::Identity()}; }

Trajectory shift(double way, double duration) { return Trajectory({{0.0, Pose()}, {duration, at_x(way)}}); }

TEST(GuidedMotion, RestsWhereItBegins) {
  GuidedMotion motion(at_x(0.3));
  EXPECT_EQ(motion.start().p.x(), 0.3);
  EXPECT_EQ(motion.intended().p.x(), 0.3);
  EXPECT_EQ(motion.at(1.0).p.x(), 0.3);
}

TEST(GuidedMotion, ComesToItsTargetWithoutALeap) {
  GuidedMotion motion(at_x(0.0));
  motion.guide({{0.2, 0.0, 0.0}, rotation_from_vector({0.0, 0.0, 1.0})});
  Pose before = motion.at(0.0);
  for (int i = 1; i <= 1000; ++i) {
    const Pose now = motion.at(kPeriod * i);
    const Vector6 way = displacement(before, now, Vector3::Zero());
    ASSERT_LE(way.head<3>().norm(), 1.0 * kPeriod * (1.0 + 1e-9));
    ASSERT_LE(way.tail<3>().norm(), 10.0 * kPeriod * (1.0 + 1e-9));
    before = now;
  }
  EXPECT_NEAR(before.p.x(), 0.2, 1e-9);
  EXPECT_NEAR(rotation_vector(before.q).z(), 1.0, 1e-9);
  EXPECT_NEAR(motion.intended().p.x(), 0.2, 1e-9);
}

TEST(GuidedMotion, PlaysAScriptFromWhereItIsAndStaysAtItsEnd) {
  GuidedMotion motion(at_x(1.0));
  motion.at(0.5);
  motion.play(shift(0.4, 2.0));
  EXPECT_TRUE(motion.is_playing());
  motion.at(0.5);
  EXPECT_NEAR(motion.at(1.5).p.x(), 1.2, 1e-12);
  EXPECT_TRUE(motion.is_playing());
  EXPECT_NEAR(motion.at(2.5).p.x(), 1.4, 1e-12);
  EXPECT_FALSE(motion.is_playing());
  EXPECT_NEAR(motion.at(3.0).p.x(), 1.4, 1e-12);
}

TEST(GuidedMotion, TurnsAboutTheGripInWorldAxes) {
  const Quaternion turned = rotation_from_vector({0.0, 0.0, 1.0});
  GuidedMotion motion({{0.0, 0.0, 0.5}, turned});
  motion.play(Trajectory({{0.0, Pose()}, {1.0, {Vector3::Zero(), rotation_from_vector({0.3, 0.0, 0.0})}}}));
  motion.at(0.0);
  const Pose end = motion.at(1.0);
  EXPECT_NEAR((end.p - Vector3(0.0, 0.0, 0.5)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(rotation_vector(end.q * turned.conjugate()).x(), 0.3, 1e-9);
}

TEST(GuidedMotion, APoseOrAStopEndsAScript) {
  GuidedMotion motion(at_x(0.0));
  motion.play(shift(1.0, 10.0));
  motion.at(0.0);
  motion.at(1.0);
  motion.stop();
  const double stopped = motion.at(1.0 + kPeriod).p.x();
  EXPECT_FALSE(motion.is_playing());
  EXPECT_NEAR(motion.at(2.0).p.x(), stopped, 1e-12) << "it stays where it was";
  motion.play(shift(1.0, 10.0));
  motion.at(2.0);
  motion.guide(at_x(0.0));
  for (int i = 0; i < 1000; ++i) motion.at(2.0 + kPeriod * i);
  EXPECT_NEAR(motion.intended().p.x(), 0.0, 1e-6);
}

TEST(GuidedMotion, TheLaterOfTwoOrdersCountsWhateverTheirKind) {
  GuidedMotion motion(at_x(0.0));
  motion.play(shift(1.0, 1.0));
  motion.stop();
  EXPECT_EQ(motion.at(kPeriod).p.x(), 0.0);
  EXPECT_EQ(motion.at(1.0).p.x(), 0.0);
  EXPECT_FALSE(motion.is_playing());
  motion.stop();
  motion.play(shift(1.0, 1.0));
  motion.at(1.0);
  EXPECT_NEAR(motion.at(2.0).p.x(), 1.0, 1e-12);
}

TEST(GuidedMotion, IsPlacedElsewhereAndForgetsItsTarget) {
  GuidedMotion motion(at_x(0.0));
  motion.guide(at_x(1.0));
  motion.at(kPeriod);
  motion.place(0.5, at_x(5.0));
  EXPECT_EQ(motion.at(1.0).p.x(), 5.0);
}

TEST(GuidedMotion, DoesNotLeapAfterItWasPlaced) {
  GuidedMotion motion(at_x(0.0));
  motion.guide(at_x(1.0));
  motion.place(7.0, at_x(0.0));
  EXPECT_LE(motion.at(7.0 + kPeriod).p.x(), 1.0 * kPeriod * (1.0 + 1e-9)) << "whatever went by before";
}

TEST(GuidedMotion, AScriptThatWaitsIsPlayingThoughTheHandWasPlacedMeanwhile) {
  GuidedMotion motion(at_x(0.0));
  motion.play(shift(1.0, 1.0));
  motion.place(0.0, at_x(2.0));
  EXPECT_TRUE(motion.is_playing());
  motion.at(0.0);
  EXPECT_NEAR(motion.at(1.0).p.x(), 3.0, 1e-12);
  EXPECT_FALSE(motion.is_playing());
}

TEST(GuidedMotion, AllocatesNothingForTheHand) {
  GuidedMotion motion(at_x(0.0));
  motion.play(shift(1.0, 0.01));
  motion.guide(at_x(0.5));
  motion.play(shift(1.0, 0.01));
  const test::AllocationCounter allocations;
  for (int i = 0; i < 100; ++i) motion.at(kPeriod * i);
  EXPECT_EQ(allocations.count(), 0u);
}

TEST(GuidedMotion, IsGuidedFromAnotherThread) {
  GuidedMotion motion(at_x(0.0));
  std::atomic<bool> done{false};
  std::thread hand([&] {
    for (int i = 0; !done; ++i) ASSERT_TRUE(motion.at(kPeriod * i).is_finite());
  });
  for (int i = 0; i < 3000; ++i) {
    motion.guide(at_x(1e-3 * i));
    if (i % 3 == 0) motion.play(shift(0.1, 0.05));
    if (i % 7 == 0) motion.stop();
    ASSERT_TRUE(motion.intended().is_finite());
  }
  done = true;
  hand.join();
}

}  // namespace
}  // namespace tegotae
