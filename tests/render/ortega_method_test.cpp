// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/ortega_method.hpp>
#include <tegotae/render/paper_method.hpp>

#include <tests/allocation_counter.hpp>
#include <tests/render/contact_models.hpp>

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace tegotae {
namespace {

using test::cube_on_floor;
using test::cube_pose;
using test::height_for;
using test::kGyration;
using test::kHalfEdge;
using test::kTick;
using test::points_on_floor;

constexpr double kGodObjectStiffness = 9000.0;

OrtegaMethod ortega_method(double damping = 0.0) {
  return {{kGodObjectStiffness, damping, kGyration}, test::cube_mass()};
}

// The god-object starts above the floor, then the interface goes to `X_WT` and stays.
RenderOutput settled(OrtegaMethod& ortega, const IntermediateRepresentation& model, const Pose& X_WT) {
  RenderOutput output;
  const Pose above{X_WT.p + Vector3(0.0, 0.01, 0.0), X_WT.q};
  ortega.render({model, above, kTick}, output);
  for (int i = 0; i < 50; ++i) ortega.render({model, X_WT, kTick}, output);
  return output;
}

double deepest_at(const IntermediateRepresentation& model, const Pose& X_W) { return deepest_penetration(model, X_W); }

TEST(OrtegaMethod, AnEdgeIsFeltAsTheClosedFormSays) {
  const auto model = cube_on_floor();
  const double depth = 1e-4;
  for (int i = 1; i <= 15; ++i) {
    const double angle = 0.05 * i;
    OrtegaMethod ortega = ortega_method();
    const RenderOutput output = settled(ortega, *model, cube_pose(angle, height_for(angle, depth)));
    const double lever = kHalfEdge * (std::cos(angle) - std::sin(angle));
    const double force = kGodObjectStiffness * depth / (1.0 + lever * lever / (kGyration * kGyration));
    EXPECT_NEAR(output.wrench.force.y(), force, 2e-3 * force) << angle << ": to first order of the depth";
    EXPECT_NEAR(output.wrench.torque.z(), -lever * force, 2e-3 * force * kHalfEdge) << angle;
    EXPECT_NEAR(output.deepest, depth, 1e-12);
  }
}

TEST(OrtegaMethod, AtRestItIsTheLeastDisplacementInTheKineticMetric) {
  const auto expect_alike = [](const IntermediateRepresentation& model, const Pose& X_WT) {
    OrtegaMethod ortega = ortega_method();
    const RenderOutput output = settled(ortega, model, X_WT);
    PaperMethod paper({{kGodObjectStiffness, 0.0, kGyration}, ConstraintSet::kNearPoints}, Vector3::Zero());
    RenderOutput expected;
    paper.render({model, X_WT, kTick}, expected);
    // The paper is linear about the interface's pose, the god-object about its own.
    const double force = expected.wrench.force.norm();
    ASSERT_GT(force, 0.05);
    EXPECT_LT((output.wrench.force - expected.wrench.force).norm(), 2e-3 * force);
    EXPECT_LT((output.wrench.torque - expected.wrench.torque).norm(), 2e-3 * force * kHalfEdge);
  };
  for (const double angle : {0.0, 1e-4, 0.3, 0.7}) {
    expect_alike(*cube_on_floor(), cube_pose(angle, height_for(angle, 2e-5)));
  }
  for (const double angle : {0.0, 1e-4, 5e-4}) {
    const Pose X_WT{{-1e-5, height_for(angle, 2e-5), 0.0}, rotation_from_vector({0.0, 0.0, angle})};
    expect_alike(*test::cube_in_a_corner(), X_WT);
  }
}

TEST(OrtegaMethod, TheInertiaOfTheToolDecidesWhatALeverArmCosts) {
  // A stick along x turns about z much harder than about x.
  const MassProperties stick = mass_properties(make_box(Vector3(0.1, 0.01, 0.01)), 1000.0);
  const double length = stick.gyration_length();
  const double depth = 1e-5;
  const auto felt_at = [&](const Vector3& p_T) {
    const auto model = points_on_floor({p_T});
    OrtegaMethod ortega({kGodObjectStiffness, 0.0, length}, stick);
    return settled(ortega, *model, {{0.0, 0.01 - depth, 0.0}, Quaternion::Identity()}).wrench.force.y();
  };
  const auto closed_form = [&](double lever, double inertia) {
    return kGodObjectStiffness * depth / (1.0 + lever * lever * stick.mass / inertia);
  };
  const double about_z = closed_form(0.1, stick.inertia(2, 2)), about_x = closed_form(0.01, stick.inertia(0, 0));
  EXPECT_NEAR(felt_at({0.1, -0.01, 0.0}), about_z, 1e-3 * about_z);
  EXPECT_NEAR(felt_at({0.0, -0.01, 0.01}), about_x, 2e-3 * about_x);
}

TEST(OrtegaMethod, PressedFlatThereIsNoTorqueAndTheForceIsTheSpring) {
  const auto model = cube_on_floor();
  OrtegaMethod ortega = ortega_method();
  const RenderOutput output = settled(ortega, *model, cube_pose(0.0, kHalfEdge - 1e-3));
  EXPECT_NEAR(output.wrench.force.y(), 9.0, 9.0 * 1e-4);
  EXPECT_LT(output.wrench.torque.norm(), 1e-9);
  EXPECT_EQ(output.active_count, 4);
}

TEST(OrtegaMethod, TheGodObjectKeepsOutHoweverTheHandMoves) {
  const auto model = test::cube_in_a_corner();
  OrtegaMethod ortega = ortega_method();
  RenderOutput output;
  double deepest_hand = 0.0;
  for (int i = 0; i < 5000; ++i) {
    const double t = kTick * i;
    const Pose X_WT{{0.01 - 0.015 * std::sin(3.0 * t), kHalfEdge + 0.01 - 0.015 * std::sin(5.0 * t), 0.01 * t},
                    rotation_from_vector({0.1 * std::sin(2.0 * t), 0.05 * std::sin(t), 0.2 * std::sin(4.0 * t)})};
    ortega.render({*model, X_WT, kTick}, output);
    ASSERT_EQ(output.status, RenderStatus::kOk);
    deepest_hand = std::max(deepest_hand, output.deepest);
    // Rows give way by 1e-5 of the stretch; a tick turns the tool by up to 1 mrad, of second order in 0.17 m.
    EXPECT_LT(deepest_at(*model, output.X_WP), 0.5e-6) << t;
  }
  EXPECT_GT(deepest_hand, 0.02);
}

TEST(OrtegaMethod, ItSlidesWithoutFriction) {
  const auto model = cube_on_floor();
  OrtegaMethod ortega = ortega_method();
  RenderOutput output;
  for (int i = -1; i < 200; ++i) {
    const Vector3 p_W(i < 0 ? 0.0 : 1e-4 * i, kHalfEdge + (i < 0 ? 1e-3 : -1e-3), i < 0 ? 0.0 : -5e-5 * i);
    ortega.render({*model, {p_W, Quaternion::Identity()}, kTick}, output);
    EXPECT_NEAR(output.X_WP.p.x(), p_W.x(), 1e-12);
    EXPECT_NEAR(output.X_WP.p.z(), p_W.z(), 1e-12);
    EXPECT_LT(std::hypot(output.wrench.force.x(), output.wrench.force.z()), 1e-8);
  }
  EXPECT_NEAR(output.wrench.force.y(), 9.0, 1e-3);
}

TEST(OrtegaMethod, TheWrenchIsContinuousWhereTheNumberOfContactsChanges) {
  const auto model = cube_on_floor();
  OrtegaMethod ortega = ortega_method();
  RenderOutput output;
  double last = settled(ortega, *model, cube_pose(-2e-3, kHalfEdge - 3e-4)).wrench.force.y();
  for (int i = 1; i <= 2000; ++i) {
    ortega.render({*model, cube_pose(2e-6 * (i - 1000), kHalfEdge - 3e-4), kTick}, output);
    // 0.2 um at the edge is 1.8 mN; the force of one edge changes by at most about as much.
    EXPECT_LT(std::abs(output.wrench.force.y() - last), 2e-3) << i;
    last = output.wrench.force.y();
  }
}

TEST(OrtegaMethod, TheDamperActsOnTheChangeOfTheStretchOnly) {
  const auto model = cube_on_floor();
  OrtegaMethod ortega = ortega_method(10.0);
  RenderOutput output;
  ortega.render({*model, cube_pose(0.0, kHalfEdge), kTick}, output);
  ortega.render({*model, cube_pose(0.0, kHalfEdge - 1e-3), kTick}, output);
  EXPECT_NEAR(output.wrench.force.y(), 9.0 + 10.0 * 1.0, 2e-3);
  ortega.render({*model, cube_pose(0.0, kHalfEdge - 1e-3), kTick}, output);
  EXPECT_NEAR(output.wrench.force.y(), 9.0, 2e-3);
}

TEST(OrtegaMethod, MovingBodiesAreGivenTheOpposite) {
  const auto model = test::cube_in_a_corner();
  model->planes[0].moving_index = 0;
  model->planes[0].p_WC = Vector3(0.3, -0.1, 0.0);
  model->planes[1].moving_index = 1;
  model->planes[1].p_WC = Vector3(-0.2, 0.1, 0.1);
  OrtegaMethod ortega = ortega_method();
  const Pose X_WT{{-2e-4, kHalfEdge - 1e-4, 0.0}, rotation_from_vector({0.0, 0.0, 1e-3})};
  const RenderOutput output = settled(ortega, *model, X_WT);
  ASSERT_EQ(output.bodies.moving().size(), 2u);
  const Wrench sum = test::sum_on_bodies(output, output.X_WP.p) + output.wrench;
  EXPECT_GT(output.wrench.force.norm(), 1.0);
  EXPECT_LT(sum.force.norm(), 1e-8);
  EXPECT_LT(sum.torque.norm(), 1e-8);
}

TEST(OrtegaMethod, APlaneThatComesUpCarriesTheGodObject) {
  const auto model = cube_on_floor();
  OrtegaMethod ortega = ortega_method();
  RenderOutput output = settled(ortega, *model, cube_pose(0.0, kHalfEdge - 1e-3));
  for (int i = 1; i <= 10; ++i) {
    model->planes[0].p_W = Vector3(0.0, 1e-4 * i, 0.0);
    ortega.render({*model, cube_pose(0.0, kHalfEdge - 1e-3), kTick}, output);
    EXPECT_NEAR(output.wrench.force.y(), kGodObjectStiffness * (1e-3 + 1e-4 * i), 1e-3);
  }
}

TEST(OrtegaMethod, ResettingForgetsTheGodObject) {
  const auto model = cube_on_floor();
  OrtegaMethod ortega = ortega_method(), fresh = ortega_method();
  RenderOutput output, expected;
  settled(ortega, *model, cube_pose(0.3, height_for(0.3, 1e-3)));
  ortega.reset();
  ortega.render({*model, cube_pose(0.0, kHalfEdge - 1e-3), kTick}, output);
  fresh.render({*model, cube_pose(0.0, kHalfEdge - 1e-3), kTick}, expected);
  EXPECT_EQ(output.wrench.force, expected.wrench.force);
  EXPECT_EQ(output.X_WP.p, expected.X_WP.p);
}

TEST(OrtegaMethod, InvalidInputGivesNoForceAndIsForgotten) {
  const auto empty = std::make_unique<IntermediateRepresentation>();
  const auto model = cube_on_floor();
  OrtegaMethod ortega = ortega_method();
  RenderOutput output;
  ortega.render({*empty, cube_pose(0.0, 0.0), kTick}, output);
  EXPECT_EQ(output.status, RenderStatus::kNoModel);
  EXPECT_EQ(output.wrench.force.norm(), 0.0);
  settled(ortega, *model, cube_pose(0.0, kHalfEdge - 1e-3));
  ortega.render({*model, {{0.0, std::nan(""), 0.0}, Quaternion::Identity()}, kTick}, output);
  EXPECT_EQ(output.status, RenderStatus::kInvalidInput);
  EXPECT_EQ(output.wrench.force.norm(), 0.0);
  model->planes[0].n_W = Vector3(0.0, std::nan(""), 0.0);
  ortega.render({*model, cube_pose(0.0, kHalfEdge - 1e-3), kTick}, output);
  EXPECT_EQ(output.status, RenderStatus::kInvalidInput);
  EXPECT_EQ(output.wrench.force.norm(), 0.0);
  model->planes[0].n_W = Vector3(0.0, 1.0, 0.0);
  ortega.render({*model, cube_pose(0.0, kHalfEdge - 1e-3), kTick}, output);
  EXPECT_NEAR(output.wrench.force.y(), 9.0, 1e-3);
  EXPECT_THROW(OrtegaMethod({kGodObjectStiffness, 0.0, kGyration}, MassProperties{}), std::invalid_argument);
}

TEST(OrtegaMethod, RenderingAllocatesNothing) {
  const auto model = cube_on_floor();
  OrtegaMethod ortega = ortega_method(1.0);
  RenderOutput output;
  const test::AllocationCounter counter;
  for (int i = 0; i < 100; ++i) ortega.render({*model, cube_pose(0.01 * i, 0.0995), kTick}, output);
  EXPECT_EQ(counter.count(), 0u);
}

}  // namespace
}  // namespace tegotae
