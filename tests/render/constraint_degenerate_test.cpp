// SPDX-License-Identifier: Apache-2.0
// Sets of rows on which constraint solvers fail: duplicated, nearly parallel, contradicting, redundant.
#include <tegotae/render/constraint_residual.hpp>
#include <tegotae/render/constraint_solver.hpp>

#include <gtest/gtest.h>
#include <tests/render/constraint_problems.hpp>

#include <cmath>
#include <vector>

namespace tegotae {
namespace {

using test::contact_row;
using test::kCompliance;
using test::kStiffness;

constexpr double kCompliances[] = {0.0, 1e-11 / kStiffness, 1e-9 / kStiffness, 1e-7 / kStiffness, kCompliance};

class ConstraintDegenerate : public ::testing::Test {
 protected:
  void begin() { problem.set_objective(test::tool_metric(), Vector6::Zero()); }
  void solve() {
    workspace.reset();
    ConstraintSolver<6>().solve(problem, workspace, solution);
  }
  void expect_solved(const char* what, double c) {
    solve();
    EXPECT_EQ(solution.status, ConstraintStatus::kConverged) << what << ", c " << c;
    const ConstraintResidual residual = constraint_residual(problem, solution);
    EXPECT_LE(residual.stationarity, 1e-10) << what << ", c " << c;
    EXPECT_LE(residual.contact_law, 1e-10) << what << ", c " << c;
  }

  ConstraintProblem<6> problem;
  ConstraintWorkspace<6> workspace{problem};
  ConstraintSolution<6> solution{problem};
};

TEST_F(ConstraintDegenerate, DuplicatedRows) {
  test::RandomProblems random(1);
  for (const double c : kCompliances)
    for (int i = 0; i < 50; ++i) {
      ConstraintProblem<6> once;
      random.fill_feasible(once, 40, c);
      begin();
      for (int copy = 0; copy < 5; ++copy)
        for (int row = 0; row < 40; ++row) problem.add_contact(once.J(row), once.b(row), c);
      expect_solved("duplicates", c);
    }
}

TEST_F(ConstraintDegenerate, NearlyParallelRows) {
  test::RandomProblems random(2);
  for (const double c : kCompliances)
    for (int i = 0; i < 50; ++i) {
      ConstraintProblem<6> once;
      random.fill_feasible(once, 30, c);
      begin();
      for (int copy = 0; copy < 6; ++copy)
        for (int row = 0; row < 30; ++row) {
          Vector6 J = once.J(row);
          const Vector3 turn = 1e-9 * random.direction(), n = J.head<3>(), torque = J.tail<3>();
          J.head<3>() = n + turn.cross(n);
          J.tail<3>() = torque + turn.cross(torque);
          problem.add_contact(J, once.b(row) - (copy % 2 == 0 ? 0.0 : 1e-12), c);
        }
      expect_solved("parallel", c);
    }
}

// Two walls facing each other, `overlap` closer than the tool is wide.
void add_opposed_walls(ConstraintProblem<6>& problem, double overlap, double c) {
  for (const double sign : {-1.0, 1.0})
    for (const double y : {-0.03, 0.03})
      for (const double z : {-0.03, 0.03})
        problem.add_contact(contact_row(Vector3(-sign, 0.0, 0.0), Vector3(0.05 * sign, y, z)), 0.5 * overlap, c);
}

TEST_F(ConstraintDegenerate, OpposedCompliantWallsCentreTheTool) {
  for (const double c : {1e-9 / kStiffness, 1e-7 / kStiffness, kCompliance}) {
    Vector6 x_free = Vector6::Zero();
    x_free[0] = 3e-4;
    problem.set_objective(test::tool_metric(), x_free);
    add_opposed_walls(problem, 1e-4, c);
    expect_solved("opposed", c);
    // Eight springs 1/c around the centre against k from x_free.
    const double walls = 8.0 / c;
    EXPECT_NEAR(solution.force[0], -kStiffness * x_free[0] * walls / (walls + kStiffness), 1e-9);
    EXPECT_LE(solution.force.tail<3>().norm(), 1e-9);
  }
}

TEST_F(ConstraintDegenerate, ContradictingHardRowsGetTheLeastSquaresCompromise) {
  Vector6 x_free = Vector6::Zero();
  x_free[0] = 3e-4;
  problem.set_objective(test::tool_metric(), x_free);
  add_opposed_walls(problem, 1e-4, 0.0);
  problem.add_contact(contact_row(Vector3::UnitZ(), Vector3(0.02, 0.0, -0.05)), 2e-4, 0.0);
  solve();
  EXPECT_EQ(solution.status, ConstraintStatus::kInfeasible);
  EXPECT_NEAR(solution.x[0], 0.0, 1e-10);
  EXPECT_NEAR(solution.x[2] - 0.02 * solution.x[4], 2e-4, 1e-10) << "the rows that can be kept are kept";
  EXPECT_NEAR(solution.force[0], -kStiffness * x_free[0], 1e-4);
}

TEST_F(ConstraintDegenerate, LeastSquaresCompromiseOfRandomContradictions) {
  // Gradient of the sum of squared violations vanishes at the answer.
  test::RandomProblems random(3);
  int infeasible = 0;
  for (int i = 0; i < 100; ++i) {
    begin();
    for (int row = 0; row < 60; ++row)
      problem.add_contact(contact_row(random.direction(), random.point()), random.uniform(0.0, 1e-3), 0.0);
    solve();
    infeasible += solution.status == ConstraintStatus::kInfeasible ? 1 : 0;
    Vector6 gradient = Vector6::Zero();
    double scale = 0.0;
    for (int row = 0; row < 60; ++row) {
      const Vector6 J = problem.J(row);
      const double violation = std::max(0.0, problem.b(row) - J.dot(solution.x));
      gradient += violation * J;
      scale += violation * J.norm();
    }
    EXPECT_LE(gradient.norm(), 1e-6 * scale);
    EXPECT_TRUE(solution.force.allFinite());
    EXPECT_LE(solution.force.norm(), 10.0 * kStiffness * 1e-2);
  }
  EXPECT_EQ(infeasible, 100);
}

TEST_F(ConstraintDegenerate, FromPlayToTightSlotWithoutAJump) {
  // Hard walls close in from 10 um of play to 10 um too narrow; the hand holds the tool aside.
  for (const double c : {0.0, kCompliance}) {
    Vector6 before;
    for (int step = 0; step <= 400; ++step) {
      Vector6 x_free = Vector6::Zero();
      x_free[0] = 2e-5;
      x_free[5] = 1e-4;
      problem.set_objective(test::tool_metric(), x_free);
      add_opposed_walls(problem, 1e-5 * (step / 200.0 - 1.0), c);
      solve();
      ASSERT_NE(solution.status, ConstraintStatus::kIterationLimit);
      if (step > 0) {
        EXPECT_LE((solution.x - before).norm(), 4e-6) << "c " << c << ", step " << step;
      }
      before = solution.x;
    }
  }
}

std::vector<Vector3> face_points(int count) {
  std::vector<Vector3> points;
  for (int i = 0; i < count; ++i) {
    const double radius = 0.05 * std::sqrt((i + 0.5) / count), angle = 2.399963 * i;
    points.emplace_back(radius * std::cos(angle), radius * std::sin(angle), -0.05);
  }
  return points;
}

TEST_F(ConstraintDegenerate, MultipliersOnAFlatFaceAreUnique) {
  const std::vector<Vector3> corners = {
      {0.05, 0.05, -0.05}, {-0.05, 0.05, -0.05}, {-0.05, -0.05, -0.05}, {0.05, -0.05, -0.05}};
  for (const std::vector<Vector3>& points : {corners, face_points(115)}) {
    test::RandomProblems random(4);
    std::vector<double> reference;
    for (int repeat = 0; repeat < 100; ++repeat) {
      begin();
      const Vector3 tilt = repeat == 0 ? Vector3::Zero() : Vector3(1e-9 * random.direction());
      for (const Vector3& r : points)
        problem.add_contact(contact_row((Vector3::UnitZ() + tilt.cross(Vector3::UnitZ())).eval(), r),
                            1e-3 + tilt.cross(r).z(), kCompliance);
      expect_solved("face", kCompliance);
      ASSERT_EQ(solution.active_rows.size(), points.size());
      const double mean = kStiffness * 1e-3 / static_cast<double>(points.size());
      if (repeat == 0) reference = solution.multipliers;
      for (std::size_t i = 0; i < points.size(); ++i) {
        // A tilt shifts the load by about k l^2 tilt / lever.
        EXPECT_NEAR(solution.multipliers[i], reference[i], 1e-6 * mean);
        EXPECT_NEAR(reference[i], mean, 0.3 * mean);
      }
    }
  }
}

TEST_F(ConstraintDegenerate, ContinuousAsRowsEnter) {
  // The tool leans on five rows; a sixth crosses from satisfied to violated. Halving the step halves the change.
  test::RandomProblems random(5);
  std::vector<Vector6> rows;
  rows.reserve(6);
  for (int i = 0; i < 6; ++i)
    rows.push_back(contact_row((Vector3::UnitZ() + 0.3 * random.direction()).normalized(), random.point()));
  for (const double c : {0.0, kCompliance}) {
    Vector6 before;
    const int steps = 2000;
    for (int step = 0; step <= steps; ++step) {
      begin();
      for (int i = 0; i < 5; ++i) problem.add_contact(rows[i], 1e-3 * (i + 1), c);
      problem.add_contact(rows[5], 2e-2 * step / steps - 5e-3, c);
      expect_solved("entering", c);
      const double change = kStiffness * 2e-2 / steps;
      if (step > 0) {
        EXPECT_LE((solution.force - before).head<3>().norm(), 10.0 * change);
      }
      before = solution.force;
    }
  }
}

}  // namespace
}  // namespace tegotae
