// SPDX-License-Identifier: Apache-2.0
#include <tests/lab/reference_task.hpp>

#include <tegotae/lab/separation_step.hpp>

#include <tests/lab/placed_core.hpp>

#include <gtest/gtest.h>

namespace tegotae {
namespace {

constexpr double kStepLength = 0.02;

struct BoxOverFloor {
  ConvexCore box, floor;
  PlanePair pair;
  SeparationStepInput input;

  // A box of 40 mm whose lower face is `height` over the floor, its frame `aside` of a pillar 20 mm wide.
  BoxOverFloor(double height, double aside)
      : box(test::placed_core(make_box(Vector3::Constant(0.02)), placed_at(aside, 0, 0.02 + height))),
        floor(test::placed_core(make_box({0.01, 0.1, 0.1}, placed_at(0, 0, -0.1)), Pose{})) {
    pair.above = &box;
    pair.below = &floor;
    input = {.centre_W = {aside, 0.0, 0.02 + height},
             .metric_length = kStepLength,
             .tool_radius = 0.035,
             .skin = kThinSkin,
             .trust = 1e-4};
  }
};

TEST(SeparationStep, NothingInTheWayGoesToTheHand) {
  BoxOverFloor scene(1e-3, 0.0);
  scene.input.to_hand << 2e-5, -3e-5, 1e-5, 1e-4, 2e-4, -3e-4;
  const SeparationStep step = separation_step(scene.input, {&scene.pair, 1});
  ASSERT_TRUE(step.converged);
  EXPECT_LT((step.move - scene.input.to_hand).norm(), 1e-12);
  EXPECT_LT(step.value, 1e-18);
  EXPECT_LT(scene.pair.load, 1e-12);
}

TEST(SeparationStep, FaceIsCarriedAtTheSkin) {
  BoxOverFloor scene(1e-5, 0.0);
  scene.input.to_hand << 1e-5, 0.0, -1e-3, 0.0, 0.0, 0.0;
  const SeparationStep step = separation_step(scene.input, {&scene.pair, 1});
  ASSERT_TRUE(step.converged);
  EXPECT_NEAR(step.move[2], kThinSkin - 1e-5, 1e-9);
  EXPECT_NEAR(step.move[0], 1e-5, 1e-9);
  EXPECT_LT(step.move.tail<3>().norm(), 1e-9);
  const double load = 1e-3 - 1e-5 + kThinSkin;  // over the stiffness
  EXPECT_NEAR(scene.pair.load, load, 1e-6 * load);
  EXPECT_NEAR(scene.pair.slack, load / kViolationWeight, 1e-15);
}

TEST(SeparationStep, FaceOverAPillarTurnsAboutItsEdgeAndThePlaneWithIt) {
  const double lever = 0.005;
  BoxOverFloor scene(kThinSkin, 0.01 + lever);
  scene.input.to_hand << 0.0, 0.0, -2e-5, 0.0, 0.0, 0.0;
  const SeparationStep step = separation_step(scene.input, {&scene.pair, 1});
  ASSERT_TRUE(step.converged);
  const double load = 2e-5 / (1.0 + lever * lever / (kStepLength * kStepLength));
  EXPECT_NEAR(scene.pair.load, load, 1e-4 * load);
  const double turn = load * lever / (kStepLength * kStepLength);
  EXPECT_NEAR(step.move[4], turn, 1e-3 * turn);
  EXPECT_NEAR(scene.pair.n.x(), turn, 1e-3 * turn);
}

TEST(SeparationStep, StaysWithinTheTrust) {
  BoxOverFloor scene(0.1, 0.0);
  scene.input.to_hand << 1.0, -1.0, 0.0, 0.5, 0.0, -0.5;
  const SeparationStep step = separation_step(scene.input, {&scene.pair, 1});
  ASSERT_TRUE(step.converged);
  EXPECT_LE(step.move.head<3>().lpNorm<Eigen::Infinity>(), 0.5e-4 * (1.0 + 1e-9));
  EXPECT_LE(step.move.tail<3>().lpNorm<Eigen::Infinity>() * 0.035, 0.5e-4 * (1.0 + 1e-9));
  EXPECT_NEAR(step.move[0], 0.5e-4, 1e-9);
}

}  // namespace
}  // namespace tegotae
