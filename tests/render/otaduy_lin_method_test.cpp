// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/otaduy_lin_method.hpp>

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

constexpr double kCouplingStiffness = 9000.0;
constexpr double kRatio = 10.0;

OtaduyLinMethod otaduy_lin_method(double damping = 0.0, double contact_damping = 0.0,
                                  double stiffness = kCouplingStiffness) {
  return {{{stiffness, damping, kGyration}, 0.01, kRatio, contact_damping}, test::cube_mass()};
}

// The wrench after the tool has settled under a held interface.
RenderOutput settled(OtaduyLinMethod& tool, const IntermediateRepresentation& model, const Pose& X_WT) {
  RenderOutput output;
  for (int i = 0; i < 2000; ++i) tool.render({model, X_WT, kTick}, output);
  return output;
}

TEST(OtaduyLinMethod, AtRestCouplingAndContactAreSpringsInSeries) {
  const double depth = 1e-3;
  const double contact = kRatio * kCouplingStiffness;
  OtaduyLinMethod tool = otaduy_lin_method();
  const auto one = points_on_floor({{0.0, -kHalfEdge, 0.0}});
  RenderOutput output = settled(tool, *one, cube_pose(0.0, kHalfEdge - depth));
  EXPECT_NEAR(output.wrench.force.y(), depth * kCouplingStiffness * contact / (kCouplingStiffness + contact), 1e-8);
  EXPECT_LT(output.wrench.torque.norm(), 1e-10);
  EXPECT_NEAR(output.X_WP.p.y(), kHalfEdge - depth * kCouplingStiffness / (kCouplingStiffness + contact), 1e-12);
  EXPECT_NEAR(output.deepest, depth, 1e-12) << "of the interface's pose, not the tool's";

  tool.reset();
  output = settled(tool, *cube_on_floor(), cube_pose(0.0, kHalfEdge - depth));
  EXPECT_NEAR(output.wrench.force.y(),
              depth * kCouplingStiffness * 4.0 * contact / (kCouplingStiffness + 4.0 * contact), 1e-8);
  EXPECT_EQ(output.active_count, 4);
}

TEST(OtaduyLinMethod, AnOffsetPointIsFeltThroughTranslationAndRotation) {
  // Compliances add: of the coupling at lever arm x, (1 + x^2 / l^2) / k, and of the contact.
  const double lever = 0.06, depth = 2e-5;
  const auto one = points_on_floor({{lever, -kHalfEdge, 0.0}});
  OtaduyLinMethod tool = otaduy_lin_method();
  const RenderOutput output = settled(tool, *one, cube_pose(0.0, kHalfEdge - depth));
  const double compliance =
      (1.0 + lever * lever / (kGyration * kGyration)) / kCouplingStiffness + 1.0 / (kRatio * kCouplingStiffness);
  const double force = depth / compliance;
  EXPECT_NEAR(output.wrench.force.y(), force, 2e-4 * force) << "to first order of the rotation";
  EXPECT_NEAR(output.wrench.torque.z(), lever * force, 1e-3 * lever * force);
}

TEST(OtaduyLinMethod, AFreeToolComesToTheHandAndNoEnergyIsMade) {
  const auto model = cube_on_floor();
  const MassProperties cube = test::cube_mass();
  for (const double damping : {0.0, 2.0, 20.0}) {
    OtaduyLinMethod tool = otaduy_lin_method(damping);
    RenderOutput output;
    tool.render({*model, cube_pose(0.0, 1.0), kTick}, output);
    const Pose X_WT{{0.01, 1.0, -0.02}, rotation_from_vector({0.1, 0.05, -0.1})};
    Pose before = output.X_WP;
    double energy = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3000; ++i) {
      tool.render({*model, X_WT, kTick}, output);
      const Vector6 velocity = displacement(before, output.X_WP, Vector3::Zero()) / kTick;
      const Vector6 stretch = displacement(X_WT, output.X_WP, Vector3::Zero());
      before = output.X_WP;
      const double inertia = cube.inertia(0, 0) * 0.01 / cube.mass;
      const double now = 0.5 * (0.01 * velocity.head<3>().squaredNorm() + inertia * velocity.tail<3>().squaredNorm()) +
                         0.5 * stretch.dot(Coupling{kCouplingStiffness, 0.0, kGyration}.stiffness_matrix() * stretch);
      // The first tick jerks the interface: its work comes in there.
      if (i > 0) {
        EXPECT_LE(now, energy * (1.0 + 1e-9) + 1e-15) << i << " with " << damping;
      }
      energy = now;
    }
    EXPECT_LT(energy, 1e-12);
    EXPECT_LT(output.wrench.force.norm(), 1e-6);
  }
}

TEST(OtaduyLinMethod, ImpactsDieOutAtAnyStiffness) {
  const auto model = cube_on_floor();
  for (const double stiffness : {1000.0, 9000.0, 1e6}) {
    OtaduyLinMethod tool = otaduy_lin_method(0.0, 0.0, stiffness);
    RenderOutput output;
    tool.render({*model, cube_pose(0.0, kHalfEdge + 1e-3), kTick}, output);
    const double rest = 1e-3 * stiffness * 4.0 * kRatio / (1.0 + 4.0 * kRatio);
    // The interface is struck 1 mm into the floor at once, slightly tilted, and held.
    double strongest = 0.0;
    for (int i = 0; i < 1000; ++i) {
      tool.render({*model, cube_pose(0.0, kHalfEdge - 1e-3), kTick}, output);
      ASSERT_EQ(output.status, RenderStatus::kOk);
      strongest = std::max(strongest, output.wrench.force.norm());
    }
    EXPECT_NEAR(output.wrench.force.y(), rest, 1e-5 * rest) << stiffness;
    EXPECT_LT(strongest, 2.0 * 2e-3 * stiffness) << "never above twice the spring of the whole way";
  }
}

TEST(OtaduyLinMethod, ContactsPushAndNeverHold) {
  const auto model = cube_on_floor();
  OtaduyLinMethod tool = otaduy_lin_method(5.0, 50.0);
  RenderOutput output = settled(tool, *model, cube_pose(0.0, kHalfEdge - 1e-3));
  EXPECT_GT(output.wrench.force.y(), 8.0);
  for (int i = 0; i < 300; ++i) {
    tool.render({*model, cube_pose(0.0, kHalfEdge + 1e-2), kTick}, output);
    EXPECT_GE(output.X_WP.p.y(), kHalfEdge - 1e-3);
  }
  EXPECT_EQ(output.active_count, 0);
  EXPECT_LT(output.wrench.force.norm(), 1e-4);
}

TEST(OtaduyLinMethod, AContactDamperSlowsTheWayInAndIsNotFeltAtRest) {
  const auto one = points_on_floor({{0.0, -kHalfEdge, 0.0}});
  OtaduyLinMethod undamped = otaduy_lin_method(), damped = otaduy_lin_method(0.0, 200.0);
  RenderOutput output;
  const auto after_two_ticks = [&](OtaduyLinMethod& tool) {
    for (int i = 0; i < 3; ++i) tool.render({*one, cube_pose(0.0, kHalfEdge - (i > 0 ? 1e-3 : 0.0)), kTick}, output);
    return output.X_WP.p.y();
  };
  EXPECT_GT(after_two_ticks(damped), after_two_ticks(undamped) + 1e-6);
  const double rest = 1e-3 * kCouplingStiffness * kRatio / (1.0 + kRatio);
  EXPECT_NEAR(settled(damped, *one, cube_pose(0.0, kHalfEdge - 1e-3)).wrench.force.y(), rest, 1e-7);
}

TEST(OtaduyLinMethod, TheWrenchIsContinuousWhereTheNumberOfContactsChanges) {
  // Per tick the interface moves every corner by 0.1 um at most: no step of the force above that of all springs.
  const auto model = cube_on_floor();
  OtaduyLinMethod tool = otaduy_lin_method();
  RenderOutput output = settled(tool, *model, cube_pose(-2e-3, kHalfEdge - 1e-4));
  Wrench last = output.wrench;
  for (int i = 1; i <= 4000; ++i) {
    tool.render({*model, cube_pose(1e-6 * (i - 2000), kHalfEdge - 1e-4), kTick}, output);
    EXPECT_LT((output.wrench.force - last.force).norm(), 2e-3) << i;
    EXPECT_LT((output.wrench.torque - last.torque).norm(), 2e-4) << i;
    last = output.wrench;
  }
}

TEST(OtaduyLinMethod, AtRestMovingBodiesAreGivenTheOpposite) {
  const auto model = test::cube_in_a_corner();
  model->planes[0].moving_index = 0;
  model->planes[0].p_WC = Vector3(0.3, -0.1, 0.0);
  model->planes[1].moving_index = 1;
  model->planes[1].p_WC = Vector3(-0.2, 0.1, 0.1);
  OtaduyLinMethod tool = otaduy_lin_method();
  const Pose X_WT{{-2e-4, kHalfEdge - 1e-4, 0.0}, rotation_from_vector({0.0, 0.0, 1e-3})};
  const RenderOutput output = settled(tool, *model, X_WT);
  ASSERT_EQ(output.bodies.moving().size(), 2u);
  const Wrench sum = test::sum_on_bodies(output, output.X_WP.p) + output.wrench;
  EXPECT_GT(output.wrench.force.norm(), 1.0);
  EXPECT_LT(sum.force.norm(), 1e-9);
  EXPECT_LT(sum.torque.norm(), 1e-9);
}

TEST(OtaduyLinMethod, ResettingForgetsTheTool) {
  const auto model = cube_on_floor();
  OtaduyLinMethod tool = otaduy_lin_method(), fresh = otaduy_lin_method();
  RenderOutput output, expected;
  settled(tool, *model, cube_pose(0.3, height_for(0.3, 1e-3)));
  tool.reset();
  for (int i = 0; i < 5; ++i) {
    tool.render({*model, cube_pose(0.0, kHalfEdge - 1e-3), kTick}, output);
    fresh.render({*model, cube_pose(0.0, kHalfEdge - 1e-3), kTick}, expected);
    EXPECT_EQ(output.wrench.force, expected.wrench.force);
    EXPECT_EQ(output.wrench.torque, expected.wrench.torque);
  }
}

TEST(OtaduyLinMethod, InvalidInputGivesNoForceAndIsForgotten) {
  const auto empty = std::make_unique<IntermediateRepresentation>();
  const auto model = cube_on_floor();
  OtaduyLinMethod tool = otaduy_lin_method();
  RenderOutput output;
  tool.render({*empty, cube_pose(0.0, 0.0), kTick}, output);
  EXPECT_EQ(output.status, RenderStatus::kNoModel);
  EXPECT_EQ(output.wrench.force.norm(), 0.0);
  const double rest = settled(tool, *model, cube_pose(0.0, kHalfEdge - 1e-3)).wrench.force.y();
  tool.render({*model, {{0.0, std::nan(""), 0.0}, Quaternion::Identity()}, kTick}, output);
  EXPECT_EQ(output.status, RenderStatus::kInvalidInput);
  EXPECT_EQ(output.wrench.force.norm(), 0.0);
  model->planes[0].n_W = Vector3(0.0, std::nan(""), 0.0);
  tool.render({*model, cube_pose(0.0, kHalfEdge - 1e-3), kTick}, output);
  EXPECT_EQ(output.status, RenderStatus::kInvalidInput);
  EXPECT_EQ(output.wrench.force.norm(), 0.0);
  model->planes[0].n_W = Vector3(0.0, 1.0, 0.0);
  tool.render({*model, cube_pose(0.0, kHalfEdge - 1e-3), kTick}, output);
  EXPECT_NEAR(output.wrench.force.y(), rest, 1e-8);
}

TEST(OtaduyLinMethod, ParametersOutOfRangeAreRefused) {
  const Coupling coupling{kCouplingStiffness, 0.0, kGyration};
  const MassProperties cube = test::cube_mass();
  EXPECT_THROW(OtaduyLinMethod({coupling, 0.0, kRatio, 0.0}, cube), std::invalid_argument);
  EXPECT_THROW(OtaduyLinMethod({coupling, 0.01, 0.0, 0.0}, cube), std::invalid_argument);
  EXPECT_THROW(OtaduyLinMethod({coupling, 0.01, kRatio, -1.0}, cube), std::invalid_argument);
  EXPECT_THROW(OtaduyLinMethod({coupling, 0.01, kRatio, 0.0}, MassProperties{}), std::invalid_argument);
}

TEST(OtaduyLinMethod, RenderingAllocatesNothing) {
  const auto model = cube_on_floor();
  OtaduyLinMethod tool = otaduy_lin_method(1.0, 1.0);
  RenderOutput output;
  const test::AllocationCounter counter;
  for (int i = 0; i < 100; ++i) tool.render({*model, cube_pose(0.01 * i, 0.0995), kTick}, output);
  EXPECT_EQ(counter.count(), 0u);
}

}  // namespace
}  // namespace tegotae
