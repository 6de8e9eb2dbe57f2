// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/constraint_residual.hpp>
#include <tegotae/render/constraint_solver.hpp>

#include <gtest/gtest.h>
#include <tests/render/constraint_problems.hpp>

#include <limits>

namespace tegotae {
namespace {

using test::contact_row;
using test::kCompliance;
using test::kStiffness;

/// Friction about the normal n at the point r, with the bristle stretched by b.
FrictionBlock<6> friction_at(const Vector3& n, const Vector3& r, const Vector3& b, double c, const Vector3& radius) {
  FrictionBlock<6> block;
  const Vector3 t = n.unitOrthogonal();
  block.J << contact_row(t, r).transpose(), contact_row(n.cross(t), r).transpose(),
      (Vector6() << Vector3::Zero(), n).finished().transpose();
  block.b = b;
  block.compliance = Vector3(c, c, c / (0.01 * 0.01));
  block.radius = radius;
  return block;
}

class ConstraintFriction : public ::testing::Test {
 protected:
  void solve() {
    workspace.reset();
    ConstraintSolver<6>().solve(problem, workspace, solution);
  }

  ConstraintProblem<6> problem;
  ConstraintWorkspace<6> workspace{problem};
  ConstraintSolution<6> solution{problem};
};

TEST_F(ConstraintFriction, ResidualOfRandomSets) {
  test::RandomProblems random(1);
  for (const double c : {0.0, 1e-9, 1e-7, 1e-5, 1e-3})
    for (const int rows : {0, 1, 4, 18, 230})
      for (int i = 0; i < 40; ++i) {
        random.fill_feasible(problem, rows, c / kStiffness);
        for (int f = 0; f < 1 + i % 5; ++f) {
          const double limit = i % 7 == 0 ? 0.0 : random.uniform(0.0, 8.0);
          const Vector3 stretch = 1e-3 * random.direction().cwiseProduct(Vector3(1.0, 1.0, 10.0));
          problem.add_friction(friction_at(random.direction(), random.point(), stretch, c / kStiffness,
                                           limit * Vector3(1.0, 1.0, 0.01)));
        }
        solve();
        const ConstraintResidual residual = constraint_residual(problem, solution);
        EXPECT_EQ(solution.status, ConstraintStatus::kConverged) << rows << " rows, c " << c << ", case " << i;
        EXPECT_LE(residual.stationarity, 1e-10) << rows << " rows, c " << c << ", case " << i;
        EXPECT_LE(residual.contact_law, 1e-10) << rows << " rows, c " << c << ", case " << i;
        EXPECT_LE(residual.friction_law, 1e-10) << rows << " rows, c " << c << ", case " << i;
        EXPECT_LE(solution.newton_iterations, 100) << rows << " rows, c " << c << ", case " << i;
      }
}

TEST_F(ConstraintFriction, SticksBelowTheLimitAndSlipsAtIt) {
  const Vector3 n = Vector3::UnitZ(), radius(2.0, 2.0, 0.02);
  for (const double pull : {1e-4, 1e-3}) {
    Vector6 x_free = Vector6::Zero();
    x_free.head<3>() = pull * n.unitOrthogonal();
    problem.set_objective(test::tool_metric(), x_free);
    problem.add_friction(friction_at(n, Vector3::Zero(), Vector3::Zero(), kCompliance, radius));
    solve();
    const double free_force = kStiffness * pull / (1.0 + 1e-5), force = std::min(free_force, 2.0);
    EXPECT_NEAR(solution.friction_forces[0][0], -force, 1e-9);
    EXPECT_NEAR(solution.force.head<3>().norm(), force, 1e-9);
    EXPECT_NEAR(solution.x.norm(), pull - force / kStiffness, 1e-12);
  }
}

TEST_F(ConstraintFriction, TwistAndDragShareTheEllipsoid) {
  Vector6 x_free = Vector6::Zero();
  x_free[0] = 1e-2;
  x_free[5] = 1.0;
  problem.set_objective(test::tool_metric(), x_free);
  const Vector3 radius(2.0, 2.0, 0.03);
  problem.add_friction(friction_at(Vector3::UnitZ(), Vector3::Zero(), Vector3::Zero(), kCompliance, radius));
  solve();
  EXPECT_NEAR(solution.friction_forces[0].cwiseQuotient(radius).norm(), 1.0, 1e-12);
  EXPECT_LT(solution.force[0], -0.01);
  EXPECT_LT(solution.force[5], -0.01);
}

TEST_F(ConstraintFriction, ZeroRadiusIsNoFriction) {
  test::RandomProblems random(2);
  random.fill_feasible(problem, 20, kCompliance);
  solve();
  const Vector6 without = solution.force;
  FrictionBlock<6> block = friction_at(Vector3::UnitZ(), Vector3::Zero(), Vector3::Ones(), 0.0, Vector3::Zero());
  problem.add_friction(block);
  solve();
  EXPECT_EQ(solution.status, ConstraintStatus::kConverged);
  EXPECT_LE((solution.force - without).norm(), 1e-10 * without.norm());
  EXPECT_EQ(solution.friction_forces[0], Vector3::Zero());
}

TEST_F(ConstraintFriction, SpringPullsFromBothSides) {
  for (const double target : {-1e-3, 1e-3}) {
    problem.set_objective(test::tool_metric(), Vector6::Zero());
    problem.add_spring(contact_row(Vector3::UnitX(), Vector3::Zero()), target, 3.0 / kStiffness);
    solve();
    EXPECT_NEAR(solution.x[0], 0.25 * target, 1e-15);
    EXPECT_NEAR(solution.friction_forces[0][0], 0.25 * kStiffness * target, 1e-11);
    EXPECT_LE(constraint_residual(problem, solution).greatest(), 1e-12);
  }
}

TEST_F(ConstraintFriction, ContinuousAcrossTheSlip) {
  double before = 0.0;
  for (int step = 0; step <= 1000; ++step) {
    Vector6 x_free = Vector6::Zero();
    x_free[0] = 1e-6 * step;
    problem.set_objective(test::tool_metric(), x_free);
    problem.add_friction(friction_at(Vector3::UnitZ(), Vector3(0.02, 0.01, -0.05), Vector3::Zero(), kCompliance,
                                     Vector3(3.0, 3.0, 0.03)));
    solve();
    const double force = solution.force.head<3>().norm();
    EXPECT_LE(std::abs(force - before), 1.1 * kStiffness * 1e-6);
    before = force;
  }
  EXPECT_GT(before, 0.5);
}

}  // namespace
}  // namespace tegotae
