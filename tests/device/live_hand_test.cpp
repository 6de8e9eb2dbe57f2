// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/live_hand.hpp>
#include <tegotae/device/simulated_presets.hpp>

#include <tests/allocation_counter.hpp>

#include <gtest/gtest.h>

namespace tegotae {
namespace {

constexpr double kHandPeriod = 1e-3;  // s

Pose hand_at_x(double x) { return {{x, 0.0, 0.0}, Quaternion::Identity()}; }

struct Rig {
  explicit Rig(std::optional<Trajectory> exact = std::nullopt)
      : hand(hand_at_x(0.0), simulated_device("page"), simulated_hand("moderate"), std::move(exact)) {}

  void run(int ticks, double force_x = 0.0) {
    for (int i = 0; i < ticks; ++i) {
      ASSERT_EQ(hand.read(kHandPeriod * count++, state), InterfaceStatus::kOk);
      ASSERT_EQ(hand.write({{{force_x, 0.0, 0.0}, Vector3::Zero()}, 0.0}), InterfaceStatus::kOk);
    }
  }

  LiveHand hand;
  InterfaceState state;
  int count = 0;
};

TEST(LiveHand, FollowsWhoGuidesIt) {
  Rig rig;
  rig.hand.guide().guide(hand_at_x(0.1));
  rig.run(2000);
  EXPECT_NEAR(rig.state.X_WT.p.x(), 0.1, 1e-4);
}

TEST(LiveHand, GivesWayToAForceAsItsStiffnessAllows) {
  Rig rig;
  rig.run(3000, -7.0);
  EXPECT_NEAR(rig.state.X_WT.p.x(), -7.0 / simulated_hand("moderate").stiffness, 1e-5);
  EXPECT_NEAR(rig.hand.guide().intended().p.x(), 0.0, 1e-12) << "the hand means to be where it was";
}

TEST(LiveHand, PlaysAMotionExactlyWhateverIsDisplayedThenTakesTheTool) {
  Rig rig(Trajectory({{2.0, hand_at_x(0.5)}, {3.0, hand_at_x(0.7)}}));
  EXPECT_TRUE(rig.hand.is_playing_exactly());
  rig.run(501, 10.0);
  EXPECT_NEAR(rig.state.X_WT.p.x(), 0.6, 1e-9);
  rig.run(501, 10.0);
  EXPECT_FALSE(rig.hand.is_playing_exactly());
  rig.run(3000);
  EXPECT_NEAR(rig.state.X_WT.p.x(), 0.7, 1e-6) << "the hand means to be where the motion ended";
}

TEST(LiveHand, IsInterrupted) {
  Rig rig(Trajectory({{0.0, hand_at_x(0.0)}, {10.0, hand_at_x(1.0)}}));
  rig.run(1001);
  rig.hand.interrupt();
  rig.run(1000);
  EXPECT_FALSE(rig.hand.is_playing_exactly());
  EXPECT_NEAR(rig.state.X_WT.p.x(), 0.1, 1e-3);
  EXPECT_NEAR(rig.state.V_WT.linear.x(), 0.0, 1e-6);
}

TEST(LiveHand, TakesTheToolFromAMotionWithoutALeap) {
  Rig rig(Trajectory({{0.0, hand_at_x(0.0)}, {10.0, hand_at_x(0.0)}}));
  rig.run(5001);
  rig.hand.interrupt();
  rig.hand.guide().guide(hand_at_x(1.0));
  rig.run(51);
  EXPECT_LE(rig.hand.guide().intended().p.x(), 0.05 * (1.0 + 1e-9)) << "it comes at 1 m/s at most";
  EXPECT_LE(rig.state.X_WT.p.x(), 0.05);
}

TEST(LiveHand, IsLostForOneReadingAfterTheProgramWasStoppedAndHoldsTheToolWhereItWas) {
  Rig rig;
  rig.hand.guide().guide(hand_at_x(0.1));
  rig.run(2000);
  rig.count += 5000;
  EXPECT_EQ(rig.hand.read(kHandPeriod * rig.count++, rig.state), InterfaceStatus::kLost);
  rig.run(100);
  EXPECT_NEAR(rig.state.X_WT.p.x(), 0.1, 1e-4);
  rig.hand.guide().guide(hand_at_x(0.2));
  rig.run(2000);
  EXPECT_NEAR(rig.state.X_WT.p.x(), 0.2, 1e-4);
}

TEST(LiveHand, AScriptAfterAMotionTakesItsOwnTime) {
  Rig rig(Trajectory({{0.0, hand_at_x(0.0)}, {1.0, hand_at_x(0.0)}}));
  rig.run(500);
  rig.hand.interrupt();
  rig.hand.guide().play(Trajectory({{0.0, Pose()}, {1.0, hand_at_x(0.2)}}));
  rig.run(500);
  EXPECT_TRUE(rig.hand.guide().is_playing());
  EXPECT_NEAR(rig.hand.guide().intended().p.x(), 0.1, 2e-3);
}

TEST(LiveHand, AllocatesNothing) {
  Rig rig(Trajectory({{0.0, hand_at_x(0.0)}, {0.05, hand_at_x(0.1)}}));
  const test::AllocationCounter allocations;
  rig.run(200, 1.0);
  EXPECT_EQ(allocations.count(), 0u);
}

}  // namespace
}  // namespace tegotae
