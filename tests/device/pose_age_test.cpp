// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/pose_age.hpp>

#include <gtest/gtest.h>

#include <limits>

namespace tegotae {
namespace {

constexpr double kTick = 1e-3;  // s

const Twist kMoving{Vector3(0.1, 0.0, 0.0), Vector3::Zero()};
const Twist kTurning{Vector3::Zero(), Vector3(0.0, 1.0, 0.0)};
const Twist kNearlyStill{Vector3(0.0, 0.01, 0.0), Vector3(0.1, 0.0, 0.0)};

Pose at(double x) { return {{x, 0.0, 0.0}, Quaternion::Identity()}; }

TEST(PoseAge, APoseThatStandsWhileItIsSaidToMoveDatesFromItsLastChange) {
  for (const Twist& V : {kMoving, kTurning}) {
    PoseAge age;
    EXPECT_EQ(age.measured(1.0, at(0.1), V), 1.0);
    EXPECT_EQ(age.measured(2.0, at(0.2), V), 2.0);
    EXPECT_EQ(age.measured(2.0 + PoseAge::kLongestStill - kTick, at(0.2), V), 2.0 + PoseAge::kLongestStill - kTick);
    EXPECT_EQ(age.measured(2.0 + PoseAge::kLongestStill + kTick, at(0.2), V), 2.0);
    EXPECT_EQ(age.measured(3.0, at(0.2), V), 2.0);
    EXPECT_EQ(age.measured(3.1, at(0.2 + 1e-15), V), 3.1) << "it goes on";
  }
}

TEST(PoseAge, AHandThatRestsIsAsNewAsItIs) {
  PoseAge age;
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(age.measured(kTick * i, at(0.1), kNearlyStill), kTick * i);
  EXPECT_EQ(age.measured(1.0, at(0.1), kMoving), 0.0) << "the library says otherwise";
}

TEST(PoseAge, WhatIsNoNumberIsNotTheSame) {
  PoseAge age;
  const Pose none = at(std::numeric_limits<double>::quiet_NaN());
  age.measured(1.0, none, kMoving);
  EXPECT_EQ(age.measured(2.0, none, kMoving), 2.0) << "it is refused for what it is";
}

}  // namespace
}  // namespace tegotae
