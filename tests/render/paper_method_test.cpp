// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/paper_method.hpp>

#include <tests/allocation_counter.hpp>
#include <tests/render/contact_models.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

namespace tegotae {
namespace {

using test::cube_on_floor;
using test::cube_pose;
using test::height_for;
using test::kGyration;
using test::kHalfEdge;

constexpr double kPaperStiffness = 9000.0;

PaperMethod paper_method(double metric_length, ConstraintSet set = ConstraintSet::kPenetratingPoints) {
  return PaperMethod({{kPaperStiffness, 0.0, metric_length}, set}, Vector3::Zero());
}

TEST(PaperMethod, AnEdgeIsFeltAsTheClosedFormSays) {
  const double depth = 0.35e-3;
  const auto model = cube_on_floor();
  RenderOutput output;
  for (const double metric_length : {1.0, kGyration}) {
    PaperMethod paper = paper_method(metric_length);
    // The second edge carries when the cube's freed pose would dip it: depth sets that angle, about 0.5 degrees.
    for (double degrees = 45.0; degrees >= 1.0; degrees -= 0.25) {
      const double angle = degrees * std::numbers::pi / 180.0;
      const double lever = kHalfEdge * (std::cos(angle) - std::sin(angle));
      paper.render({*model, cube_pose(angle, height_for(angle, depth)), 1e-3}, output);
      const double force = kPaperStiffness * depth / (1.0 + lever * lever / (metric_length * metric_length));
      ASSERT_EQ(output.status, RenderStatus::kOk);
      EXPECT_NEAR(output.wrench.force.y(), force, 1e-3 * force) << degrees;
      EXPECT_NEAR(output.wrench.torque.z(), -lever * force, 1e-3 * force * kHalfEdge) << degrees;
      EXPECT_NEAR(output.deepest, depth, 1e-12);
    }
  }
}

TEST(PaperMethod, FaceAndEdgeAreClosedFormsOfTheirDepth) {
  RenderOutput output;
  const auto model = cube_on_floor();
  PaperMethod paper = paper_method(kGyration);
  paper.render({*model, cube_pose(0.0, kHalfEdge - 1e-3), 1e-3}, output);
  EXPECT_NEAR(output.wrench.force.y(), 9.0, 9.0 * 1e-5);
  EXPECT_LT(output.wrench.torque.norm(), 1e-9);
  EXPECT_LT(std::hypot(output.wrench.force.x(), output.wrench.force.z()), 1e-9);
  EXPECT_EQ(output.active_count, 4);
  // The freed pose stands on the floor.
  EXPECT_NEAR((output.X_WP * Vector3(kHalfEdge, -kHalfEdge, kHalfEdge)).y(), 0.0, 2e-8);
}

TEST(PaperMethod, PenetratingPointsAloneMakeTheForceJumpAndNearPointsDoNot) {
  const auto model = cube_on_floor();
  RenderOutput output;
  const auto largest_step = [&](ConstraintSet set) {
    PaperMethod paper = paper_method(kGyration, set);
    double largest = 0.0, last = 0.0;
    for (int i = -2000; i <= 2000; ++i) {
      const double angle = 0.00025 * i * std::numbers::pi / 180.0;
      paper.render({*model, cube_pose(angle, kHalfEdge - 0.3e-3), 1e-3}, output);
      const double force = output.wrench.force.norm();
      if (i > -2000) largest = std::max(largest, std::abs(force - last));
      last = force;
    }
    return largest;
  };
  EXPECT_NEAR(largest_step(ConstraintSet::kPenetratingPoints), 0.54, 0.02);
  EXPECT_LT(largest_step(ConstraintSet::kNearPoints), 0.002);
}

TEST(PaperMethod, OpposedWallsAreSharedWithoutChatter) {
  auto model = std::make_unique<IntermediateRepresentation>();
  model->sequence = 1;
  model->plane_count = model->point_count = 2;
  // A slot 0.2 mm too narrow for the two points.
  model->planes[0].n_W = Vector3(1.0, 0.0, 0.0);
  model->planes[0].p_W = Vector3(-0.0099, 0.0, 0.0);
  model->planes[1].n_W = Vector3(-1.0, 0.0, 0.0);
  model->planes[1].p_W = Vector3(0.0099, 0.0, 0.0);
  model->planes[0].point_count = model->planes[1].point_count = 1;
  model->planes[1].first_point = 1;
  model->points[0] = {Vector3(-0.01, 0.0, 0.0), 1};
  model->points[1] = {Vector3(0.01, 0.0, 0.0), 2};
  PaperMethod paper = paper_method(1.0);
  RenderOutput output;
  double last = 0.0;
  // Beyond 0.1 mm off the middle only one point penetrates.
  for (int i = 1; i < 200; ++i) {
    const double x = 1e-6 * (i - 100);
    paper.render({*model, {{x, 0.0, 0.0}, Quaternion::Identity()}, 1e-3}, output);
    EXPECT_LT(std::abs(output.wrench.force.x() + kPaperStiffness * x), 1e-3) << "the middle is the least violation";
    EXPECT_EQ(output.status, RenderStatus::kInfeasible) << "and it is said that it is a compromise";
    if (i > 1) {
      EXPECT_LT(std::abs(output.wrench.force.x() - last), 0.0091);
    }
    last = output.wrench.force.x();
  }
}

TEST(PaperMethod, DampingIsThatOfEquationTwo) {
  const auto model = cube_on_floor();
  PaperMethod paper({{kPaperStiffness, 10.0, 1.0}, ConstraintSet::kPenetratingPoints}, Vector3::Zero());
  RenderOutput output;
  paper.render({*model, cube_pose(0.0, kHalfEdge), 1e-3}, output);
  paper.render({*model, cube_pose(0.0, kHalfEdge - 1e-3), 1e-3}, output);
  EXPECT_NEAR(output.wrench.force.y(), 9.0 + 10.0 * 1.0, 1e-3);
  paper.render({*model, cube_pose(0.0, kHalfEdge - 1e-3), 1e-3}, output);
  EXPECT_NEAR(output.wrench.force.y(), 9.0, 1e-3);
  // Leaving contact: the damper must not remember it at the next touch.
  paper.render({*model, cube_pose(0.0, kHalfEdge + 1e-3), 1e-3}, output);
  paper.render({*model, cube_pose(0.0, kHalfEdge + 1e-3), 1e-3}, output);
  EXPECT_EQ(output.wrench.force.norm(), 0.0);
}

TEST(PaperMethod, AStartInContactIsNoMotion) {
  const auto model = cube_on_floor();
  PaperMethod paper({{kPaperStiffness, 10.0, 1.0}, ConstraintSet::kPenetratingPoints}, Vector3::Zero());
  RenderOutput output;
  for (int i = 0; i < 3; ++i) {
    paper.render({*model, cube_pose(0.0, kHalfEdge - 1e-3), 1e-3}, output);
    EXPECT_NEAR(output.wrench.force.y(), 9.0, 1e-3);
  }
}

TEST(PaperMethod, MovingBodiesAreGivenTheOppositeOfWhatIsFelt) {
  auto model = cube_on_floor();
  model->planes[0].moving_index = 5;
  model->planes[0].p_WC = Vector3(0.3, -0.1, 0.0);
  PaperMethod paper = paper_method(1.0);
  RenderOutput output;
  paper.render({*model, cube_pose(0.2, height_for(0.2, 1e-3)), 1e-3}, output);
  ASSERT_EQ(output.bodies.moving().size(), 1u);
  const BodyWrench& body = output.bodies.moving()[0];
  const Vector3 centre = cube_pose(0.2, height_for(0.2, 1e-3)).p;
  const Wrench sum = body.on_body.shifted(body.p_WC) + output.wrench.shifted(centre);
  EXPECT_LT(sum.force.norm(), 1e-9);
  EXPECT_LT(sum.torque.norm(), 1e-9);
}

TEST(PaperMethod, WithoutModelOrWithANonFinitePoseThereIsNoForce) {
  const auto empty = std::make_unique<IntermediateRepresentation>();
  const auto model = cube_on_floor();
  PaperMethod paper = paper_method(1.0);
  RenderOutput output;
  paper.render({*empty, cube_pose(0.0, 0.0), 1e-3}, output);
  EXPECT_EQ(output.status, RenderStatus::kNoModel);
  EXPECT_EQ(output.wrench.force.norm(), 0.0);
  paper.render({*model, {{0.0, std::nan(""), 0.0}, Quaternion::Identity()}, 1e-3}, output);
  EXPECT_EQ(output.status, RenderStatus::kInvalidInput);
  EXPECT_EQ(output.wrench.force.norm(), 0.0);
}

TEST(PaperMethod, RenderingAllocatesNothing) {
  const auto model = cube_on_floor();
  PaperMethod paper = paper_method(1.0, ConstraintSet::kNearPoints);
  RenderOutput output;
  const test::AllocationCounter counter;
  for (int i = 0; i < 100; ++i) paper.render({*model, cube_pose(0.01 * i, 0.0995), 1e-3}, output);
  EXPECT_EQ(counter.count(), 0u);
}

}  // namespace
}  // namespace tegotae
