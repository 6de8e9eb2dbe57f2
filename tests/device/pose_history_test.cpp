// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/pose_history.hpp>
#include <tegotae/math/rotation.hpp>

#include <gtest/gtest.h>

namespace tegotae {
namespace {

Pose pose_at(double t) { return {{0.1 * t, 0.0, t * t}, rotation_from_vector({0.0, 2.0 * t, 0.0})}; }

TEST(PoseHistory, KnowsNoVelocityOfOneReading) {
  PoseHistory history;
  EXPECT_EQ(history.velocity(0.01).linear.norm(), 0.0);
  history.add(0.0, pose_at(0.0));
  EXPECT_EQ(history.velocity(0.01).linear.norm(), 0.0);
}

TEST(PoseHistory, IsTheDifferenceOverTheWindowOrOverOneReading) {
  PoseHistory history;
  for (int k = 0; k <= 200; ++k) history.add(1e-3 * k, pose_at(1e-3 * k));
  for (const double window : {0.0, 1e-3, 0.01, 0.063}) {
    const double span = window < 1e-3 ? 1e-3 : window;
    const Twist velocity = history.velocity(window);
    EXPECT_NEAR(velocity.linear.x(), 0.1, 1e-12);
    EXPECT_NEAR(velocity.linear.z(), 0.4 - span, 1e-9) << window;
    EXPECT_NEAR(velocity.angular.y(), 2.0, 1e-9);
  }
  // No more than 63 readings back.
  EXPECT_NEAR(history.velocity(1.0).linear.z(), 0.4 - 0.063, 1e-9);
}

TEST(PoseHistory, ForgetsWhenCleared) {
  PoseHistory history;
  history.add(0.0, pose_at(0.0));
  history.add(1e-3, pose_at(1e-3));
  history.clear();
  EXPECT_EQ(history.velocity(0.01).linear.norm(), 0.0);
  history.add(2e-3, pose_at(5.0));
  EXPECT_EQ(history.velocity(0.01).linear.norm(), 0.0);
}

TEST(PoseHistory, ReadingsAtOneInstantHaveNoVelocity) {
  PoseHistory history;
  history.add(1.0, pose_at(0.0));
  history.add(1.0, pose_at(1.0));
  EXPECT_EQ(history.velocity(0.01).linear.norm(), 0.0);
}

}  // namespace
}  // namespace tegotae
