// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/motion.hpp>
#include <tegotae/math/rotation.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tegotae {
namespace {

TEST(SmoothStep, HoldsItsEndsAndPassesTheMiddle) {
  const SmoothStep step{1.0, 3.0, 5.0, -5.0};
  EXPECT_EQ(step.at(0.0), 5.0);
  EXPECT_EQ(step.at(1.0), 5.0);
  EXPECT_NEAR(step.at(2.0), 0.0, 1e-15);
  EXPECT_EQ(step.at(3.0), -5.0);
  EXPECT_EQ(step.at(9.0), -5.0);
}

TEST(SmoothStep, HasNoVelocityAndAccelerationAtItsEnds) {
  const SmoothStep step{0.0, 1.0, 0.0, 1.0};
  constexpr double h = 1e-3;
  for (const double end : {0.0, 1.0}) {
    const double velocity = (step.at(end + h) - step.at(end - h)) / (2.0 * h);
    const double acceleration = (step.at(end + h) - 2.0 * step.at(end) + step.at(end - h)) / (h * h);
    EXPECT_NEAR(velocity, 0.0, 1e-5);
    EXPECT_NEAR(acceleration, 0.0, 2e-2);
  }
  // The fastest moment of the quintic, 15/8 in the middle, is there to be felt.
  EXPECT_NEAR((step.at(0.5 + h) - step.at(0.5 - h)) / (2.0 * h), 15.0 / 8.0, 1e-4);
}

TEST(SmoothStep, RisesMonotonically) {
  const SmoothStep step{0.0, 1.0, 2.0, 3.0};
  for (int i = 0; i < 1000; ++i) EXPECT_LE(step.at(i * 1e-3), step.at((i + 1) * 1e-3));
}

TEST(LowestHeight, OfATurnedBoxIsItsLowestVertex) {
  Tool tool;
  tool.pieces = {make_box({0.1, 0.2, 0.3})};
  for (const double angle : {0.0, 0.3, -1.0, 2.0}) {
    const Quaternion q = rotation_from_vector(angle * Vector3::UnitZ());
    const double expected = -0.1 * std::abs(std::sin(angle)) - 0.2 * std::abs(std::cos(angle));
    EXPECT_NEAR(lowest_height(tool, q, Vector3::UnitY()), expected, 1e-15);
    EXPECT_NEAR(lowest_height(tool, q, Vector3::UnitZ()), -0.3, 1e-15);
  }
}

TEST(LowestHeight, OfSeveralPiecesIsTheLowestOfAll) {
  Tool tool;
  tool.pieces = {make_sphere(0.1, {{0.0, 0.0, 1.0}, Quaternion::Identity()}),
                 make_sphere(0.2, {{1.0, 0.0, 0.0}, Quaternion::Identity()})};
  EXPECT_NEAR(lowest_height(tool, Quaternion::Identity(), Vector3::UnitZ()), -0.2, 1e-15);
  EXPECT_NEAR(lowest_height(tool, Quaternion::Identity(), -Vector3::UnitZ()), -1.1, 1e-15);
  // A quarter turn about y takes x down along -z.
  const Quaternion quarter = rotation_from_vector(0.5 * std::numbers::pi * Vector3::UnitY());
  EXPECT_NEAR(lowest_height(tool, quarter, Vector3::UnitZ()), -1.2, 1e-15);
}

TEST(Sampled, TakesBothEndsAndAMillisecondBetween) {
  const Trajectory motion = sampled(0.5, 0.75, [](double time) {
    return Pose{{time, 0.0, 0.0}, Quaternion::Identity()};
  });
  ASSERT_EQ(motion.samples().size(), 251U);
  EXPECT_EQ(motion.start(), 0.5);
  EXPECT_NEAR(motion.end(), 0.75, 1e-12);
  EXPECT_NEAR(motion.samples()[100].X_WT.p.x(), 0.6, 1e-12);
}

}  // namespace
}  // namespace tegotae
