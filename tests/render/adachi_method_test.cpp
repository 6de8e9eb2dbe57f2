// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/adachi_method.hpp>

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

constexpr double kPlaneStiffness = 9000.0;

AdachiMethod adachi_method(double damping = 0.0) { return {{kPlaneStiffness, damping, 1.0}, Vector3::Zero()}; }

TEST(AdachiMethod, TheDeepestPointIsPushedOutWithoutTorque) {
  const auto model = cube_on_floor();
  RenderOutput output;
  for (const double angle : {0.0, 0.1, -0.3, 0.7}) {
    AdachiMethod adachi = adachi_method();
    const Pose X_WT = cube_pose(angle, height_for(angle, 0.5e-3));
    adachi.render({*model, X_WT, kTick}, output);
    EXPECT_EQ(output.status, RenderStatus::kOk);
    EXPECT_NEAR(output.wrench.force.y(), kPlaneStiffness * 0.5e-3, 1e-9) << angle;
    EXPECT_EQ(output.wrench.force.x(), 0.0);
    EXPECT_EQ(output.wrench.torque.norm(), 0.0) << "three degrees of freedom";
    EXPECT_NEAR(output.deepest, 0.5e-3, 1e-12);
    EXPECT_EQ(output.active_count, 1) << "although four corners of a face penetrate";
  }
}

TEST(AdachiMethod, PointAndPlaneAreKeptUntilTheNextModel) {
  auto model = cube_on_floor();
  AdachiMethod adachi = adachi_method();
  RenderOutput output;
  // Turned one way the corner at +x is chosen; turned the other way it is out, though its neighbour is deep.
  const double angle = 0.01;
  adachi.render({*model, cube_pose(-angle, height_for(angle, 1e-4)), kTick}, output);
  EXPECT_NEAR(output.wrench.force.y(), kPlaneStiffness * 1e-4, 1e-9);
  adachi.render({*model, cube_pose(angle, height_for(angle, 1e-4)), kTick}, output);
  EXPECT_EQ(output.wrench.force.norm(), 0.0);
  EXPECT_NEAR(output.deepest, 1e-4, 1e-12);
  model->sequence = 2;
  adachi.render({*model, cube_pose(angle, height_for(angle, 1e-4)), kTick}, output);
  EXPECT_NEAR(output.wrench.force.y(), kPlaneStiffness * 1e-4, 1e-9);
}

TEST(AdachiMethod, OnlyTheNearestPlaneIsFelt) {
  const auto model = test::cube_in_a_corner();
  const Pose X_WT{{-2e-4, kHalfEdge - 1e-4, 0.0}, Quaternion::Identity()};
  RenderOutput output;
  for (const int nearest : {0, 1}) {
    model->planes[0].distance = nearest == 0 ? -2e-4 : -1e-4;
    model->planes[1].distance = nearest == 1 ? -2e-4 : -1e-4;
    AdachiMethod adachi = adachi_method();
    adachi.render({*model, X_WT, kTick}, output);
    EXPECT_NEAR(output.wrench.force.x(), nearest == 1 ? kPlaneStiffness * 2e-4 : 0.0, 1e-9);
    EXPECT_NEAR(output.wrench.force.y(), nearest == 0 ? kPlaneStiffness * 1e-4 : 0.0, 1e-9);
  }
}

TEST(AdachiMethod, TheForceIsContinuousWhileThePlaneIsHeld) {
  const auto model = cube_on_floor();
  AdachiMethod adachi = adachi_method();
  RenderOutput output;
  double last = 0.0, most = 0.0;
  for (int i = 0; i < 2000; ++i) {
    const double depth = 1e-6 * (i - 500);
    adachi.render({*model, cube_pose(0.001, height_for(0.001, depth)), kTick}, output);
    most = std::max(most, std::abs(output.wrench.force.y() - last));
    last = output.wrench.force.y();
  }
  EXPECT_GT(last, 10.0);
  EXPECT_LT(most, 1.001 * kPlaneStiffness * 1e-6);
}

TEST(AdachiMethod, TheDamperResistsTheWayInAndNeverPulls) {
  const auto model = cube_on_floor();
  AdachiMethod adachi = adachi_method(10.0);
  RenderOutput output;
  const auto force_at = [&](double depth) {
    adachi.render({*model, cube_pose(0.0, kHalfEdge - depth), kTick}, output);
    return output.wrench.force.y();
  };
  EXPECT_NEAR(force_at(1e-4), 0.9, 1e-9) << "no past";
  EXPECT_NEAR(force_at(2e-4), 1.8 + 10.0 * 0.1, 1e-9);
  EXPECT_EQ(force_at(1e-5), 0.0) << "the damper would pull: 0.09 N - 1.9 N";
  adachi.reset();
  EXPECT_NEAR(force_at(2e-4), 1.8, 1e-9);
}

TEST(AdachiMethod, AMovingBodyIsGivenTheOpposite) {
  const auto model = cube_on_floor();
  model->planes[0].moving_index = 2;
  model->planes[0].p_WC = Vector3(0.3, -0.1, 0.0);
  AdachiMethod adachi = adachi_method();
  RenderOutput output;
  const Pose X_WT = cube_pose(0.2, height_for(0.2, 1e-3));
  adachi.render({*model, X_WT, kTick}, output);
  ASSERT_EQ(output.bodies.moving().size(), 1u);
  const Wrench sum = test::sum_on_bodies(output, X_WT.p) + output.wrench;
  EXPECT_LT(sum.force.norm(), 1e-12);
  EXPECT_LT(sum.torque.norm(), 1e-12);
}

TEST(AdachiMethod, WithoutModelPlaneOrFiniteInputThereIsNoForce) {
  const auto empty = std::make_unique<IntermediateRepresentation>();
  const auto model = cube_on_floor();
  AdachiMethod adachi = adachi_method();
  RenderOutput output;
  adachi.render({*empty, cube_pose(0.0, 0.0), kTick}, output);
  EXPECT_EQ(output.status, RenderStatus::kNoModel);
  empty->sequence = 1;
  adachi.render({*empty, cube_pose(0.0, 0.0), kTick}, output);
  EXPECT_EQ(output.status, RenderStatus::kOk);
  EXPECT_EQ(output.wrench.force.norm(), 0.0);
  adachi.reset();
  adachi.render({*model, {{0.0, std::nan(""), 0.0}, Quaternion::Identity()}, kTick}, output);
  EXPECT_EQ(output.status, RenderStatus::kInvalidInput);
  EXPECT_EQ(output.wrench.force.norm(), 0.0);
  model->planes[0].n_W = Vector3(0.0, std::numeric_limits<double>::infinity(), 0.0);
  adachi.render({*model, cube_pose(0.0, 0.0), kTick}, output);
  EXPECT_EQ(output.status, RenderStatus::kInvalidInput);
  EXPECT_EQ(output.wrench.force.norm(), 0.0);
}

TEST(AdachiMethod, RenderingAllocatesNothing) {
  const auto model = cube_on_floor();
  AdachiMethod adachi = adachi_method(1.0);
  RenderOutput output;
  const test::AllocationCounter counter;
  for (int i = 0; i < 100; ++i) {
    model->sequence = 1 + static_cast<std::uint64_t>(i) / 10;
    adachi.render({*model, cube_pose(0.01 * i, 0.0995), kTick}, output);
  }
  EXPECT_EQ(counter.count(), 0u);
}

}  // namespace
}  // namespace tegotae
