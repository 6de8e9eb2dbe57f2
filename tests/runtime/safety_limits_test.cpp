// SPDX-License-Identifier: Apache-2.0
#include <tegotae/runtime/safety_limits.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace tegotae {
namespace {

constexpr double kInfinite = std::numeric_limits<double>::infinity();
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

TEST(SafetyLimits, DefaultsAreThoseOfTheStatedCase) {
  const SafetyLimits defaults, computed = safety_limits(InterfaceCapability(), 9000.0, 0.1, 0.05);
  EXPECT_DOUBLE_EQ(defaults.period, computed.period);
  EXPECT_DOUBLE_EQ(defaults.force_rate, computed.force_rate);
  EXPECT_DOUBLE_EQ(defaults.torque_rate, computed.torque_rate);
  EXPECT_DOUBLE_EQ(defaults.max_model_age, computed.max_model_age);
  EXPECT_DOUBLE_EQ(defaults.metric_length, computed.metric_length);
}

TEST(SafetyLimits, TakesWhatTheInterfaceStatesAndKeepsTheDefaultElsewhere) {
  InterfaceCapability capability;
  capability.max_force = 3.3;
  capability.rate = 2000.0;
  const SafetyLimits limits = safety_limits(capability, 400.0, 0.1, 0.01);
  EXPECT_EQ(limits.max_force, 3.3);
  EXPECT_EQ(limits.max_torque, SafetyLimits().max_torque);
  EXPECT_EQ(limits.period, 0.5e-3);
}

TEST(SafetyLimits, RatesAllowTheStrikesThatTheyAreMadeFor) {
  constexpr double kStiffness = 9000.0, kGripArm = 0.05;
  StrikeAllowance strike;
  strike.grip_arm = kGripArm;
  for (const double length : {0.01, 0.08, 1.0}) {
    const SafetyLimits limits = safety_limits(InterfaceCapability(), kStiffness, length, 0.05, strike);
    for (int millimetres = 0; millimetres < 2000; ++millimetres) {
      const double x = 1e-3 * millimetres;  // lever arm of the contact point, m
      const double force_growth = kStiffness * strike.speed / (1.0 + x * x / (length * length));
      EXPECT_LE(strike.margin * force_growth, limits.force_rate * (1.0 + 1e-12));
      EXPECT_LE(strike.margin * force_growth * (x + kGripArm), limits.torque_rate);
    }
    EXPECT_LE(strike.margin * kStiffness * length * length * strike.turning_speed, limits.torque_rate);
  }
}

TEST(SafetyLimits, RefusesWhatIsNoLimit) {
  const InterfaceCapability capability;
  for (const double bad : {0.0, -1.0, kNaN, kInfinite}) {
    EXPECT_THROW(safety_limits(capability, bad, 0.1, 0.05), std::invalid_argument);
    EXPECT_THROW(safety_limits(capability, 9000.0, bad, 0.05), std::invalid_argument);
    EXPECT_THROW(safety_limits(capability, 9000.0, 0.1, bad), std::invalid_argument);
    InterfaceCapability bad_rate;
    bad_rate.rate = bad;
    EXPECT_THROW(safety_limits(bad_rate, 9000.0, 0.1, 0.05), std::invalid_argument);
    StrikeAllowance strike;
    strike.margin = bad;
    EXPECT_THROW(safety_limits(capability, 9000.0, 0.1, 0.05, strike), std::invalid_argument);
    if (bad == 0.0) continue;
    StrikeAllowance arm;
    arm.grip_arm = bad;
    EXPECT_THROW(safety_limits(capability, 9000.0, 0.1, 0.05, arm), std::invalid_argument);
  }
}

TEST(SafetyLimits, RefusesNegativeLimitsOfAnInterface) {
  for (const double bad : {-1.0, -kInfinite, kNaN}) {
    InterfaceCapability force, torque;
    force.max_force = bad;
    torque.max_torque = bad;
    EXPECT_THROW(safety_limits(force, 9000.0, 0.1, 0.05), std::invalid_argument) << bad;
    EXPECT_THROW(safety_limits(torque, 9000.0, 0.1, 0.05), std::invalid_argument) << bad;
  }
}

TEST(SafetyLimits, ThreeDegreesOfForceOnlyMayHaveNoTorque) {
  InterfaceCapability capability;
  capability.max_torque = 0.0;
  EXPECT_EQ(safety_limits(capability, 9000.0, 0.1, 0.05).max_torque, 0.0);
}

}  // namespace
}  // namespace tegotae
