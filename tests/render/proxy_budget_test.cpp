// SPDX-License-Identifier: Apache-2.0
// More near pairs than a tick may measure: the last planes of the rest stand in.
#include <tegotae/render/tolerances.hpp>

#include <tests/allocation_counter.hpp>
#include <tests/random_shapes.hpp>
#include <tests/render/proxy_rig.hpp>
#include <tests/sweep_size.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tegotae::test {
namespace {

constexpr int kPieces = 450;

// A shell of balls about the origin, evenly spread (a Fibonacci lattice), `clearance` from a ball of radius 20 mm.
std::vector<Shape> shell_of_balls(double clearance) {
  constexpr double kRadius = 0.004;
  const Shape ball = make_sphere(kRadius);
  std::vector<Shape> balls;
  for (int i = 0; i < kPieces; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / kPieces, turn = i * std::numbers::pi * (3.0 - std::sqrt(5.0));
    const double across = std::sqrt(1.0 - z * z);
    const Vector3 direction(across * std::cos(turn), across * std::sin(turn), z);
    balls.push_back(ball);
    balls.back().X_BS.p = (0.02 + kRadius + clearance) * direction;
  }
  return balls;
}

// A floor of boxes, 2 mm wide, tops at z = 0, each turned in its place by a little.
std::vector<Shape> floor_of_blocks() {
  std::vector<Shape> blocks;
  const int side = 21;
  for (int i = 0; i < side * side; ++i) {
    const int column = i % side - side / 2, row = i / side - side / 2;
    const Vector3 p(0.002 * column, 0.002 * row, -0.005);
    blocks.push_back(make_box({0.00095, 0.00095, 0.005}, {p, rotation_from_vector({0.0, 0.0, 0.003 * (i % 7)})}));
  }
  return blocks;
}

TEST(ProxyBudget, APairWithoutMeasurementIsGuardedByItsLastPlane) {
  std::mt19937_64 random(21);
  ProxyRig rig({make_sphere(0.02)});
  rig.add_body(shell_of_balls(0.3e-3));
  rig.tick(at(0.0, 0.0, 0.0));
  EXPECT_EQ(rig.output.skipped_pairs, kPieces - tolerance::kDistanceBudget) << "all are near and none is known";
  Vector3 hand = Vector3::Zero(), velocity = Vector3::Zero();
  int skipped = 0, pressed = 0;
  const AllocationCounter counter;
  for (int i = 0; i < 600; ++i) {
    velocity = 0.98 * velocity + 4e-4 * random_unit(random) - 2e-3 * hand;
    hand += velocity;
    rig.tick({hand, Quaternion::Identity()});
    skipped += rig.output.skipped_pairs;
    pressed += rig.output.wrench.force.norm() > 1.0 ? 1 : 0;
    if (i % (4 * test::kSweepDivisor) == 0) {
      ASSERT_GT(rig.clearance(), 0.0) << i;
    }
  }
  EXPECT_EQ(counter.count(), 0u);
  EXPECT_GT(skipped, 1000) << "the budget does not suffice in this scene";
  EXPECT_GT(pressed, 200);
}

TEST(ProxyBudget, AFloorOfManyBlocksCarriesAsAFloorDoes) {
  ProxyRig rig({make_box({0.02, 0.02, 0.01})}), whole({make_box({0.02, 0.02, 0.01})});
  rig.add_body(floor_of_blocks());
  whole.add_body(make_plane());
  rig.start();
  // As physics tells the planes of new pairs.
  for (int i = 0; i < rig.model->pair_count; ++i) rig.model->pairs[static_cast<size_t>(i)].n_B = Vector3(0.0, 0.0, 1.0);
  int skipped = 0;
  for (int i = 0; i < 400; ++i) {
    const double t = 1e-3 * i;
    const Pose X_WT = at({1e-4 * std::sin(20.0 * t), 0.0, 0.0105 - 3e-3 * std::sin(5.0 * t)},
                         {0.02 * std::sin(9.0 * t), 0.02 * std::sin(7.0 * t), 0.0});
    const Wrench& wrench = rig.tick(X_WT);
    const Wrench& expected = whole.tick(X_WT);
    skipped += rig.output.skipped_pairs;
    if (i % (4 * test::kSweepDivisor) == 0) {
      ASSERT_GT(rig.clearance(), 0.4e-6) << i;
    }
    // A corner over the crossing of two gaps sinks by up to 6 um.
    EXPECT_NEAR((wrench.force - expected.force).norm(), 0.0, 0.1 + 0.01 * expected.force.norm()) << i;
    EXPECT_NEAR((wrench.torque - expected.torque).norm(), 0.0, 1e-3) << i;
  }
  EXPECT_GT(skipped, 1000);
}

TEST(ProxyBudget, WhereTheBudgetSufficesNothingIsSkipped) {
  ProxyRig rig({make_box({0.02, 0.02, 0.01})});
  std::vector<Shape> blocks = floor_of_blocks();
  blocks.resize(tolerance::kDistanceBudget / 4);
  rig.add_body(blocks);
  for (int i = 0; i < 100; ++i) {
    rig.tick(at(-0.01, -0.015, 0.011 - 2e-5 * i));
    EXPECT_EQ(rig.output.skipped_pairs, 0) << i;
  }
  EXPECT_GT(rig.output.active_count, 0);
}

// The shell is shaken with the tool in it.
TEST(ProxyBudget, ManyMovingPiecesDoNotPassThroughTheTool) {
  std::mt19937_64 random(5);
  ProxyRig rig({make_sphere(0.02)});
  const std::vector<Shape> balls = shell_of_balls(0.5e-3);
  const int body = rig.add_body(balls, {}, true);
  rig.tick(at(0.0, 0.0, 0.0));
  int skipped = 0;
  for (int i = 0; i < 300; ++i) {
    const double t = 1e-3 * i;
    const Pose X_WB = at({3e-3 * std::sin(6.0 * t), 2e-3 * std::sin(9.0 * t), 1e-3 * std::sin(11.0 * t)},
                         {0.3 * std::sin(5.0 * t), 0.2 * std::sin(4.0 * t), 0.0});
    rig.move_body(body, X_WB);
    rig.tick(at(0.0, 0.0, 0.0));
    skipped += rig.output.skipped_pairs;
    rig.scene.bodies[static_cast<size_t>(body)].X_WB = X_WB;
    if (i % (4 * test::kSweepDivisor) == 0) {
      ASSERT_GT(rig.clearance(), 0.0) << i;
    }
  }
  EXPECT_GT(skipped, 1000);
}

}  // namespace
}  // namespace tegotae::test
