// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/berkelman_method.hpp>

#include <tests/allocation_counter.hpp>
#include <tests/render/contact_models.hpp>

#include <gtest/gtest.h>

#include <limits>

namespace tegotae {
namespace {

using test::cube_on_floor;
using test::cube_pose;
using test::height_for;
using test::kHalfEdge;
using test::kTick;
using test::points_on_floor;

constexpr double kSpringStiffness = 9000.0;

BerkelmanMethod berkelman_method(double damping = 0.0) { return {{kSpringStiffness, damping, 1.0}, Vector3::Zero()}; }

TEST(BerkelmanMethod, TheForceGrowsWithTheNumberOfPoints) {
  RenderOutput output;
  BerkelmanMethod berkelman = berkelman_method();
  const double depth = 1e-4;
  const auto one = points_on_floor({{0.0, -kHalfEdge, 0.0}});
  berkelman.render({*one, cube_pose(0.0, kHalfEdge - depth), kTick}, output);
  EXPECT_NEAR(output.wrench.force.y(), kSpringStiffness * depth, 1e-9);
  EXPECT_LT(output.wrench.torque.norm(), 1e-12);

  const auto cube = cube_on_floor();
  berkelman.render({*cube, cube_pose(0.0, kHalfEdge - depth), kTick}, output);
  EXPECT_NEAR(output.wrench.force.y(), 4.0 * kSpringStiffness * depth, 1e-9) << "a face";
  EXPECT_LT(output.wrench.torque.norm(), 1e-12);
  EXPECT_EQ(output.active_count, 4);
  EXPECT_EQ(output.constraint_count, 8);

  berkelman.render({*cube, cube_pose(0.5, height_for(0.5, depth)), kTick}, output);
  EXPECT_NEAR(output.wrench.force.y(), 2.0 * kSpringStiffness * depth, 1e-9) << "an edge";
}

TEST(BerkelmanMethod, TheTorqueIsThatOfTheForces) {
  const auto cube = cube_on_floor();
  BerkelmanMethod berkelman = berkelman_method();
  RenderOutput output;
  for (int i = 0; i <= 15; ++i) {
    const double angle = 0.02 + 0.05 * i;
    berkelman.render({*cube, cube_pose(angle, height_for(angle, 1e-4)), kTick}, output);
    const double lever = kHalfEdge * (std::cos(angle) - std::sin(angle));
    const double force = 2.0 * kSpringStiffness * 1e-4;
    EXPECT_NEAR(output.wrench.force.y(), force, 1e-9);
    EXPECT_NEAR(output.wrench.torque.z(), -lever * force, 1e-9) << angle;
  }
}

TEST(BerkelmanMethod, TheCentreOfMassIsWhereTheTorqueIsTakenAbout) {
  const auto one = points_on_floor({{0.0, -kHalfEdge, 0.0}});
  BerkelmanMethod berkelman({kSpringStiffness, 0.0, 1.0}, Vector3(0.05, 0.0, 0.0));
  RenderOutput output;
  berkelman.render({*one, cube_pose(0.0, kHalfEdge - 1e-4), kTick}, output);
  EXPECT_NEAR(output.wrench.torque.z(), -0.05 * 0.9, 1e-9);
}

TEST(BerkelmanMethod, TheWrenchIsContinuousWhileTiltingOverAFace) {
  const auto cube = cube_on_floor();
  BerkelmanMethod berkelman = berkelman_method();
  RenderOutput output;
  Wrench last;
  for (int i = 0; i <= 4000; ++i) {
    const double angle = 1e-6 * (i - 2000);
    berkelman.render({*cube, cube_pose(angle, kHalfEdge - 1e-4), kTick}, output);
    // Each of four points moves by at most 0.1 um a step.
    if (i > 0) {
      EXPECT_LT((output.wrench.force - last.force).norm(), 4.01 * kSpringStiffness * 1e-7);
      EXPECT_LT((output.wrench.torque - last.torque).norm(), 4.1 * kHalfEdge * kSpringStiffness * 1e-7);
    }
    last = output.wrench;
  }
}

TEST(BerkelmanMethod, EveryPointHasADamperThatNeverPulls) {
  const auto cube = cube_on_floor();
  BerkelmanMethod berkelman = berkelman_method(10.0);
  RenderOutput output;
  const auto force_at = [&](double depth) {
    berkelman.render({*cube, cube_pose(0.0, kHalfEdge - depth), kTick}, output);
    return output.wrench.force.y();
  };
  EXPECT_NEAR(force_at(1e-4), 4.0 * 0.9, 1e-9) << "no past";
  EXPECT_NEAR(force_at(2e-4), 4.0 * (1.8 + 10.0 * 0.1), 1e-9);
  EXPECT_EQ(force_at(1e-5), 0.0);
  EXPECT_EQ(force_at(-1e-3), 0.0);
  EXPECT_NEAR(force_at(1e-4), 4.0 * (0.9 + 10.0 * 0.1), 1e-9) << "the way above the floor does not count";
  berkelman.reset();
  EXPECT_NEAR(force_at(2e-4), 4.0 * 1.8, 1e-9);
}

TEST(BerkelmanMethod, MovingBodiesAreGivenTheOpposite) {
  const auto model = test::cube_in_a_corner();
  model->planes[0].moving_index = 0;
  model->planes[0].p_WC = Vector3(0.3, -0.1, 0.0);
  model->planes[1].moving_index = 1;
  model->planes[1].p_WC = Vector3(-0.2, 0.1, 0.1);
  BerkelmanMethod berkelman = berkelman_method(5.0);
  RenderOutput output;
  const Pose X_WT{{-2e-4, kHalfEdge - 1e-4, 0.0}, rotation_from_vector({0.0, 0.0, 1e-3})};
  berkelman.render({*model, X_WT, kTick}, output);
  ASSERT_EQ(output.bodies.moving().size(), 2u);
  const Wrench sum = test::sum_on_bodies(output, X_WT.p) + output.wrench;
  EXPECT_GT(output.wrench.torque.norm(), 0.1);
  EXPECT_LT(sum.force.norm(), 1e-12);
  EXPECT_LT(sum.torque.norm(), 1e-12);
}

TEST(BerkelmanMethod, WithoutModelOrFiniteInputThereIsNoForce) {
  const auto empty = std::make_unique<IntermediateRepresentation>();
  const auto cube = cube_on_floor();
  BerkelmanMethod berkelman = berkelman_method();
  RenderOutput output;
  berkelman.render({*empty, cube_pose(0.0, 0.0), kTick}, output);
  EXPECT_EQ(output.status, RenderStatus::kNoModel);
  berkelman.render({*cube, {{0.0, std::nan(""), 0.0}, Quaternion::Identity()}, kTick}, output);
  EXPECT_EQ(output.status, RenderStatus::kInvalidInput);
  EXPECT_EQ(output.wrench.force.norm(), 0.0);
  cube->planes[0].moving_index = 0;
  cube->points[0].p_T = Vector3(0.0, -std::numeric_limits<double>::infinity(), 0.0);
  berkelman.render({*cube, cube_pose(0.0, 0.0), kTick}, output);
  EXPECT_EQ(output.status, RenderStatus::kInvalidInput);
  EXPECT_EQ(output.wrench.force.norm(), 0.0);
  EXPECT_TRUE(output.bodies.moving().empty());
}

TEST(BerkelmanMethod, RenderingAllocatesNothing) {
  const auto cube = cube_on_floor();
  BerkelmanMethod berkelman = berkelman_method(1.0);
  RenderOutput output;
  const test::AllocationCounter counter;
  for (int i = 0; i < 100; ++i) berkelman.render({*cube, cube_pose(0.01 * i, 0.0995), kTick}, output);
  EXPECT_EQ(counter.count(), 0u);
}

}  // namespace
}  // namespace tegotae
