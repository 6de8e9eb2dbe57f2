// SPDX-License-Identifier: Apache-2.0
#include <tegotae/math/rotation.hpp>
#include <tegotae/runtime/pose_guard.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace tegotae {
namespace {

constexpr double kGuardPeriod = 1e-3;

class Guarded {
 public:
  PoseVerdict at(double x, double angle = 0.0, double elapsed = kGuardPeriod) {
    InterfaceState state;
    state.X_WT = {{x, 0.0, 0.0}, rotation_from_vector({0.0, angle, 0.0})};
    return guard.judge(limits, state, elapsed);
  }
  PoseGuard guard;
  PoseGuard::Limits limits;
};

TEST(PoseGuard, TakesWhatAHandDoes) {
  Guarded guarded;
  for (int i = 0; i < 1000; ++i) {
    ASSERT_EQ(guarded.at(0.1 * std::sin(0.04 * i), 0.5 * std::sin(0.05 * i)), PoseVerdict::kGood) << "4 m/s, 25 rad/s";
  }
}

TEST(PoseGuard, RefusesWhatIsNoPoseAndTakesTheNext) {
  Guarded guarded;
  ASSERT_EQ(guarded.at(0.0), PoseVerdict::kGood);
  EXPECT_EQ(guarded.at(std::nan("")), PoseVerdict::kFault);
  InterfaceState state;
  state.X_WT.q = Quaternion(0.0, 0.0, 0.0, 0.0);
  EXPECT_EQ(guarded.guard.judge(guarded.limits, state, kGuardPeriod), PoseVerdict::kFault);
  state.X_WT.q = Quaternion::Identity();
  state.V_WT.angular.x() = std::numeric_limits<double>::infinity();
  EXPECT_EQ(guarded.guard.judge(guarded.limits, state, kGuardPeriod), PoseVerdict::kFault);
  EXPECT_EQ(guarded.at(1e-3), PoseVerdict::kGood) << "it is where the hand may have come meanwhile";
}

TEST(PoseGuard, ALeapIsAFaultAndThenElsewhere) {
  for (const bool turning : {false, true}) {
    Guarded guarded;
    const auto at = [&](double there) { return turning ? guarded.at(0.0, 5.0 * there) : guarded.at(there); };
    for (int i = 0; i < 1000; ++i) ASSERT_EQ(at(1e-6 * i), PoseVerdict::kGood);
    EXPECT_EQ(at(0.2), PoseVerdict::kFault);
    for (int i = 1; i < 50; ++i) ASSERT_EQ(at(0.2 + 1e-6 * i), PoseVerdict::kFault) << "not proven";
    at(0.2);  // sums of periods are rounded
    EXPECT_EQ(at(0.2001), PoseVerdict::kGood);
  }
}

TEST(PoseGuard, AGlitchOfOneReadingIsTwoFaults) {
  Guarded guarded;
  for (int i = 0; i < 100; ++i) guarded.at(1e-4 * i);
  EXPECT_EQ(guarded.at(0.2), PoseVerdict::kFault);
  EXPECT_EQ(guarded.at(0.0101), PoseVerdict::kFault);
  EXPECT_EQ(guarded.at(0.0102), PoseVerdict::kGood) << "where it was before";
}

TEST(PoseGuard, ALeapThatIsProvenIsElsewhere) {
  Guarded guarded;
  for (int i = 0; i < 100; ++i) guarded.at(0.0);
  int moved = 0, faults = 0;
  for (int i = 0; i < 100; ++i) {
    const PoseVerdict verdict = guarded.at(0.2);
    moved += verdict == PoseVerdict::kMoved ? 1 : 0;
    faults += verdict == PoseVerdict::kFault ? 1 : 0;
  }
  EXPECT_EQ(moved, 1);
  EXPECT_NEAR(faults, 50, 1);
}

TEST(PoseGuard, AGlitchThatEndsBeforeItIsProvenIsForgotten) {
  Guarded guarded;
  for (int i = 0; i < 100; ++i) guarded.at(0.0);
  for (int i = 0; i < 20; ++i) ASSERT_EQ(guarded.at(0.2, 3.0), PoseVerdict::kFault);
  EXPECT_EQ(guarded.at(0.001), PoseVerdict::kFault) << "the leap back";
  for (int i = 0; i < 200; ++i) ASSERT_EQ(guarded.at(0.001), PoseVerdict::kGood) << "never elsewhere";
}

TEST(PoseGuard, RefusesAnEnormousQuaternionAndAPlaceThatIsNone) {
  Guarded guarded;
  ASSERT_EQ(guarded.at(0.0), PoseVerdict::kGood);
  InterfaceState state;
  state.X_WT.q = Quaternion(1e160, 0.0, 0.0, 0.0);
  EXPECT_EQ(guarded.guard.judge(guarded.limits, state, kGuardPeriod), PoseVerdict::kFault);
  for (int i = 0; i < 200; ++i) ASSERT_EQ(guarded.at(1e300), PoseVerdict::kFault);
}

TEST(PoseGuard, PosesThatLeapToAndFroAreNeverTaken) {
  Guarded guarded;
  guarded.at(0.0);
  for (int i = 0; i < 100; ++i) ASSERT_EQ(guarded.at(i % 2 == 0 ? 0.2 : 0.0), PoseVerdict::kFault);
}

TEST(PoseGuard, ADeviceThatIsSlowerThanTheTicksMayMakeLongerSteps) {
  Guarded guarded;
  for (int i = 0; i < 500; ++i) ASSERT_EQ(guarded.at(0.004 * (i - i % 5)), PoseVerdict::kGood) << "200 Hz at 4 m/s";
  for (int i = 0; i < 1000; ++i) guarded.at(2.0);
  EXPECT_EQ(guarded.at(2.1), PoseVerdict::kFault) << "a rest is no excuse";
}

TEST(PoseGuard, MissedTicksAreTimeToo) {
  Guarded guarded;
  guarded.at(0.0);
  EXPECT_EQ(guarded.at(0.08, 0.0, 0.02), PoseVerdict::kGood);
  EXPECT_EQ(guarded.at(0.19, 0.0, 0.02), PoseVerdict::kFault);
}

TEST(PoseGuard, AnInterfaceThatComesBackIsTakenWhereItIs) {
  Guarded guarded;
  guarded.at(0.0);
  guarded.guard.lose();
  EXPECT_EQ(guarded.at(1e-3), PoseVerdict::kGood);
  for (int i = 0; i < 100; ++i) guarded.guard.lose();
  EXPECT_EQ(guarded.at(0.3), PoseVerdict::kMoved);
  EXPECT_EQ(guarded.at(0.3), PoseVerdict::kGood);
}

TEST(PoseGuard, WithoutLimitsAnyPoseIsTaken) {
  Guarded guarded;
  guarded.limits.speed = guarded.limits.turning_speed = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 10; ++i) EXPECT_EQ(guarded.at(i % 2, i), PoseVerdict::kGood);
}

}  // namespace
}  // namespace tegotae
