// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/assumed_ratings.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace tegotae {
namespace {

InterfaceCapability rated(double stiffness) {
  InterfaceCapability capability;
  capability.max_force = 10.0;
  capability.max_torque = 0.2;
  capability.max_stiffness = stiffness;
  return capability;
}

TEST(AssumedRatings, FollowFromTheStiffness) {
  const InterfaceCapability found = with_assumed_ratings(rated(1000.0));
  EXPECT_DOUBLE_EQ(found.max_rotational_stiffness, 2.5);
  EXPECT_DOUBLE_EQ(found.max_damping, 10.0);
  EXPECT_DOUBLE_EQ(found.max_rotational_damping, 0.025);
  EXPECT_EQ(found.max_stiffness, 1000.0);
  EXPECT_EQ(found.max_force, 10.0);
}

TEST(AssumedRatings, ADamperIsNoStrongerThanALateVelocityBears) {
  const InterfaceCapability found = with_assumed_ratings(rated(8000.0));
  EXPECT_EQ(found.max_damping, assumed::kMostDamping);
  EXPECT_DOUBLE_EQ(found.max_rotational_damping, 0.0625);
  // A free grip of 0.2 kg, its velocity 10 ms late, comes to rest under the strongest damper, and would not under twice
  // that.
  const auto last_speed = [](double damping) {
    constexpr int kLate = 10;  // ms
    double late[kLate], speed = 1.0;
    std::fill(std::begin(late), std::end(late), 0.0);
    for (int i = 0; i < 2000; ++i) {
      double& oldest = late[i % kLate];
      const double known = oldest;
      oldest = speed;
      speed -= 1e-3 * damping * known / 0.2;
    }
    return std::abs(speed);
  };
  EXPECT_LT(last_speed(found.max_damping), 0.5);
  EXPECT_GT(last_speed(2.0 * found.max_damping), 10.0);
}

TEST(AssumedRatings, WhatIsStatedStays) {
  InterfaceCapability stated = rated(1000.0);
  stated.max_damping = 3.0;
  stated.max_rotational_stiffness = 7.0;
  InterfaceCapability found = with_assumed_ratings(stated);
  EXPECT_EQ(found.max_damping, 3.0);
  EXPECT_EQ(found.max_rotational_stiffness, 7.0);
  EXPECT_DOUBLE_EQ(found.max_rotational_damping, 0.0075) << "from the damping that is stated";
  stated.max_rotational_damping = 0.5;
  EXPECT_EQ(with_assumed_ratings(stated).max_rotational_damping, 0.5);
}

TEST(AssumedRatings, NothingIsMadeUpWithoutAStiffnessOrForATorqueThatIsNotDisplayed) {
  const InterfaceCapability unknown = with_assumed_ratings(InterfaceCapability{});
  EXPECT_TRUE(std::isinf(unknown.max_damping));
  EXPECT_TRUE(std::isinf(unknown.max_rotational_stiffness));
  InterfaceCapability without_torque = rated(400.0);
  without_torque.max_torque = 0.0;
  const InterfaceCapability found = with_assumed_ratings(without_torque);
  EXPECT_DOUBLE_EQ(found.max_damping, 4.0);
  EXPECT_TRUE(std::isinf(found.max_rotational_stiffness));
  EXPECT_TRUE(std::isinf(found.max_rotational_damping));
}

}  // namespace
}  // namespace tegotae
