// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/spacenav_motion.hpp>
#include <tegotae/math/rotation.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace tegotae {
namespace {

constexpr int kFull = SpacenavDeflection::kFull;
constexpr double kMousePeriod = 1e-3;  // s

// From `begin` (s) for `duration` (s), at 1 kHz.
double hold(SpacenavMotion& motion, const SpacenavDeflection& deflection, double duration, double begin = 0.0) {
  const long ticks = std::lround(duration / kMousePeriod);
  for (long i = 0; i <= ticks; ++i) motion.advance(begin + kMousePeriod * static_cast<double>(i), deflection);
  return begin + kMousePeriod * static_cast<double>(ticks);
}

SpacenavSettings offset_mode() {
  SpacenavSettings settings;
  settings.mode = SpacenavSettings::Mode::kOffset;
  settings.reach = 0.08;
  settings.tilt = 0.4;
  return settings;
}

TEST(SpacenavMotion, AtRateGoesAsFastAsItIsDeflectedAndStaysWhereItWasBrought) {
  SpacenavMotion motion{{}};
  const double time = hold(motion, {{kFull, 0, 0}, {}}, 1.0);
  EXPECT_LT((motion.V_WT().linear - Vector3(0.1, 0.0, 0.0)).norm(), 1e-9);
  // Less the way of one time constant, in which the mouse is approached.
  EXPECT_NEAR(motion.X_WT().p.x(), 0.1 * (1.0 - SpacenavMotion::kTimeConstant), 1e-4);
  hold(motion, {}, 1.0, time);
  EXPECT_LT(motion.V_WT().linear.norm(), 1e-9);
  EXPECT_NEAR(motion.X_WT().p.x(), 0.1, 1e-4);
}

// Right, up and away of the mouse are x, z and y of a world with z up, and turns by the right-hand rule about them:
// libspnav's frame is left-handed.
TEST(SpacenavMotion, PushesAndTurnsGoTheSameWayInTheWorld) {
  const Vector3 directions[] = {Vector3::UnitX(), Vector3::UnitZ(), Vector3::UnitY()};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    SpacenavMotion pushed{offset_mode()};
    SpacenavDeflection push;
    push.push[axis] = kFull;
    hold(pushed, push, 1.0);
    EXPECT_LT((pushed.X_WT().p - 0.08 * directions[axis]).norm(), 1e-9) << axis;
    SpacenavMotion turned{offset_mode()};
    SpacenavDeflection turn;
    turn.turn[axis] = kFull;
    hold(turned, turn, 1.0);
    EXPECT_LT((rotation_vector(turned.X_WT().q) - 0.4 * directions[axis]).norm(), 1e-9) << axis;
  }
}

TEST(SpacenavMotion, AnotherAxisCanPointUp) {
  SpacenavSettings settings = offset_mode();
  settings.axes = AxisMap("xyz");
  SpacenavMotion motion{settings};
  hold(motion, {{0, 0, kFull}, {}}, 1.0);
  EXPECT_LT((motion.X_WT().p - Vector3(0.0, 0.0, -0.08)).norm(), 1e-9) << "towards the person is z";
}

TEST(SpacenavMotion, WithAnOffsetReturnsWhenItIsLetGo) {
  SpacenavMotion motion{offset_mode()};
  const double time = hold(motion, {{kFull, 0, 0}, {0, -kFull, 0}}, 1.0);
  EXPECT_NEAR(motion.X_WT().p.x(), 0.08, 1e-9);
  EXPECT_NEAR(rotation_vector(motion.X_WT().q).z(), -0.4, 1e-9);
  hold(motion, {}, 1.0, time);
  EXPECT_LT(motion.X_WT().p.norm(), 1e-9);
  EXPECT_LT(rotation_vector(motion.X_WT().q).norm(), 1e-9);
}

TEST(SpacenavMotion, TheVelocityIsThatOfThePose) {
  for (const auto mode : {SpacenavSettings::Mode::kRate, SpacenavSettings::Mode::kOffset}) {
    SpacenavSettings settings;
    settings.mode = mode;
    SpacenavMotion motion{settings};
    Pose before;
    double fastest = 0.0;
    for (int tick = 0; tick < 300; ++tick) {
      const int counts = tick < 150 ? kFull : -kFull / 2;
      motion.advance(kMousePeriod * tick, {{counts, 0, counts / 3}, {counts, counts / 2, 0}});
      const Vector6 way = displacement(before, motion.X_WT(), Vector3::Zero());
      ASSERT_LT((way.head<3>() / kMousePeriod - motion.V_WT().linear).norm(), 1e-9);
      ASSERT_LT((way.tail<3>() / kMousePeriod - motion.V_WT().angular).norm(), 1e-6);
      before = motion.X_WT();
      fastest = std::max(fastest, motion.V_WT().linear.norm());
    }
    EXPECT_GT(fastest, 0.05);
    EXPECT_LT(fastest, 5.0) << "no leap";
  }
}

TEST(SpacenavMotion, TheDeadZoneEndsWithoutAStep) {
  SpacenavSettings settings = offset_mode();
  settings.dead_zone = 0.2;
  const auto reach_of = [&](int counts) {
    SpacenavMotion motion{settings};
    hold(motion, {{counts, 0, 0}, {}}, 1.0);
    return motion.X_WT().p.x();
  };
  EXPECT_EQ(reach_of(kFull / 5), 0.0);
  EXPECT_EQ(reach_of(-kFull / 5), 0.0);
  EXPECT_NEAR(reach_of(kFull / 5 + 1), 0.08 / kFull / 0.8, 1e-9);
  EXPECT_NEAR(reach_of(kFull), 0.08, 1e-9);
  EXPECT_NEAR(reach_of(-kFull), -0.08, 1e-9);
  EXPECT_NEAR(reach_of(3 * kFull), 0.08, 1e-9) << "beyond its stops";
}

TEST(SpacenavMotion, ATimeThatStandsStillOrLeapsMovesLittle) {
  SpacenavMotion motion{{}};
  const SpacenavDeflection full{{kFull, 0, 0}, {}};
  motion.advance(1000.0, full);
  EXPECT_EQ(motion.X_WT().p.norm(), 0.0) << "the first time is when it begins";
  motion.advance(1000.0, full);
  EXPECT_EQ(motion.X_WT().p.norm(), 0.0);
  motion.advance(2000.0, full);
  EXPECT_LE(motion.X_WT().p.norm(), 0.1 * SpacenavMotion::kLongestStep);
  motion.advance(0.0, full);
  EXPECT_TRUE(motion.X_WT().is_finite());
}

}  // namespace
}  // namespace tegotae
