// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/constraint_residual.hpp>
#include <tegotae/render/constraint_solver.hpp>

#include <gtest/gtest.h>
#include <tests/allocation_counter.hpp>
#include <tests/render/constraint_problems.hpp>

#include <limits>
#include <memory>

namespace tegotae {
namespace {

using test::contact_row;
using test::kCompliance;
using test::kMetricLength;
using test::kStiffness;

class ConstraintSolverTest : public ::testing::Test {
 protected:
  void solve_cold() {
    workspace.reset();
    ConstraintSolver<6>().solve(problem, workspace, solution);
  }

  ConstraintProblem<6> problem;
  ConstraintWorkspace<6> workspace{problem};
  ConstraintSolution<6> solution{problem};
};

TEST_F(ConstraintSolverTest, ResidualOfRandomSets) {
  test::RandomProblems random(1);
  for (const double c : {0.0, 1e-12, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-3})
    for (const int rows : {1, 2, 3, 5, 8, 18, 60, 230, 1000, 5000})
      for (int i = 0; i < (rows <= 230 ? 50 : 4); ++i) {
        if (i % 2 == 0) {
          random.fill_feasible(problem, rows, c / kStiffness);
        } else {
          random.fill_planes(problem, rows, c / kStiffness);
        }
        solve_cold();
        const ConstraintResidual residual = constraint_residual(problem, solution);
        EXPECT_EQ(solution.status, ConstraintStatus::kConverged) << rows << " rows, c " << c;
        EXPECT_LE(residual.greatest(), 1e-10) << rows << " rows, c " << c;
        EXPECT_LE(solution.newton_iterations, 100) << rows << " rows, c " << c;
      }
}

TEST_F(ConstraintSolverTest, NoRowsLeaveTheToolFree) {
  Vector6 x_free;
  x_free << 1e-3, 2e-3, 3e-3, 0.01, 0.02, 0.03;
  problem.set_objective(test::tool_metric(), x_free);
  solve_cold();
  EXPECT_EQ(solution.status, ConstraintStatus::kConverged);
  EXPECT_EQ(solution.x, x_free);
  EXPECT_EQ(solution.force, Vector6::Zero());
  problem.add_contact(contact_row(Vector3::UnitZ(), Vector3::Zero()), -1e-3, 0.0);
  solve_cold();
  EXPECT_EQ(solution.x, x_free);
  EXPECT_TRUE(solution.active_rows.empty());
}

TEST_F(ConstraintSolverTest, OneRowAtALeverArmFeelsTheClosedForm) {
  const double depth = 1e-3, lever = 0.1;
  for (const double c : {0.0, 1e-9 / kStiffness, 1e-5 / kStiffness, 0.5 / kStiffness}) {
    problem.set_objective(test::tool_metric(), Vector6::Zero());
    problem.add_contact(contact_row(Vector3::UnitZ(), Vector3(lever, 0.0, 0.0)), depth, c);
    solve_cold();
    const double own = (1.0 + lever * lever / (kMetricLength * kMetricLength)) / kStiffness;
    const double force = depth / (own + c);
    EXPECT_NEAR(solution.multipliers[0], force, 1e-11 * force);
    EXPECT_NEAR(solution.force[2], force, 1e-11 * force);
    EXPECT_NEAR(solution.force[4], -lever * force, 1e-11 * force);
    EXPECT_EQ(solution.active_rows, std::vector<int>{0});
  }
}

TEST_F(ConstraintSolverTest, RowsAreRelativeToTheFreeDisplacement) {
  Vector6 x_free;
  x_free << 1e-3, 0.0, -2e-3, 0.0, 0.0, 0.0;
  problem.set_objective(test::tool_metric(), x_free);
  problem.add_contact(contact_row(Vector3::UnitZ(), Vector3::Zero()), -5e-4, 0.0);
  solve_cold();
  EXPECT_NEAR(solution.x[2], -5e-4, 1e-15);
  EXPECT_NEAR(solution.x[0], 1e-3, 1e-18);
  EXPECT_NEAR(solution.multipliers[0], kStiffness * 1.5e-3, 1e-10);
}

TEST_F(ConstraintSolverTest, TheAnswerDoesNotDependOnTheStartOrThePast) {
  test::RandomProblems random(2);
  ConstraintSolution<6> warm(problem);
  for (int i = 0; i < 200; ++i) {
    // The guess comes from an unrelated set of another size; the start is anywhere.
    random.fill_feasible(problem, 1 + i % 100, kCompliance);
    Vector6 x_start;
    for (int j = 0; j < 6; ++j) x_start[j] = random.uniform(-0.01, 0.01);
    ConstraintSolver<6>().solve(problem, x_start, workspace, warm);
    ConstraintWorkspace<6> fresh(problem);
    ConstraintSolver<6>().solve(problem, fresh, solution);
    ASSERT_EQ(warm.status, ConstraintStatus::kConverged);
    EXPECT_LE(constraint_residual(problem, warm).greatest(), 1e-10);
    const double scale = 1e-30 + solution.force.norm();
    EXPECT_LE((warm.force - solution.force).norm(), 1e-8 * scale);
    for (int row = 0; row < problem.contact_count(); ++row)
      EXPECT_NEAR(warm.multipliers[row], solution.multipliers[row], 1e-8 * scale);
  }
}

TEST_F(ConstraintSolverTest, WarmStartNeedsFewIterations) {
  int iterations = 0;
  for (int tick = 0; tick < 50; ++tick) {
    test::RandomProblems random(3);
    random.fill_planes(problem, 230, kCompliance);
    const Vector6 x_free = 1e-6 * tick * Vector6::Ones();
    ConstraintProblem<6> moved;
    moved.set_objective(problem.K(), x_free);
    for (int i = 0; i < problem.contact_count(); ++i) moved.add_contact(problem.J(i), problem.b(i), problem.c(i));
    ConstraintSolver<6>().solve(moved, solution.x, workspace, solution);
    if (tick > 0) iterations += solution.newton_iterations;
  }
  EXPECT_LE(iterations, 2 * 49);
}

TEST_F(ConstraintSolverTest, AllocatesNothing) {
  test::RandomProblems random(4);
  for (const double c : {0.0, kCompliance}) {
    const test::AllocationCounter counter;
    random.fill_feasible(problem, 500, c);
    for (int f = 0; f < 20; ++f) {
      FrictionBlock<6> block;
      block.J.setConstant(0.5);
      block.b = Vector3(1e-4, 0.0, 1e-3);
      block.compliance.setConstant(c);
      block.radius = Vector3(1.0, 1.0, 0.01);
      problem.add_friction(block);
    }
    ConstraintSolver<6>().solve(problem, workspace, solution);
    EXPECT_GT(solution.newton_iterations, 0);
    EXPECT_EQ(counter.count(), 0u);
  }
  const test::AllocationCounter counter;
  const auto one = std::make_unique<double>(1.0);
  EXPECT_GE(counter.count(), *one) << "the counter counts";
}

TEST_F(ConstraintSolverTest, InvalidInputLeavesTheFreeDisplacement) {
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInf = std::numeric_limits<double>::infinity();
  const Vector6 x_free = 1e-3 * Vector6::Ones(), good = contact_row(Vector3::UnitZ(), Vector3::Zero());
  const auto expect_invalid = [&] {
    solve_cold();
    EXPECT_EQ(solution.status, ConstraintStatus::kInvalidInput);
    EXPECT_EQ(solution.force, Vector6::Zero());
    EXPECT_EQ(solution.multipliers[0], 0.0);
  };
  for (const double bad : {kNan, kInf, -kInf}) {
    for (int place = 0; place < 4; ++place) {
      Vector6 J = good;
      if (place < 2) J[place] = bad;
      problem.set_objective(test::tool_metric(), x_free);
      problem.add_contact(good, 1.0, 1.0);
      problem.add_contact(J, place == 2 ? bad : 1.0, place == 3 ? bad : 1.0);
      expect_invalid();
      EXPECT_EQ(solution.x, x_free);
    }
    FrictionBlock<6> block;
    block.J.setZero();
    block.b[2] = bad;
    problem.set_objective(test::tool_metric(), x_free);
    problem.add_friction(block);
    expect_invalid();
    problem.set_objective(bad * test::tool_metric(), x_free);
    expect_invalid();
    problem.set_objective(test::tool_metric(), bad * x_free);
    expect_invalid();
  }
  problem.set_objective(test::tool_metric(), x_free);
  problem.add_contact(good, 1.0, -1.0);
  expect_invalid();
  problem.set_objective(-test::tool_metric(), x_free);
  expect_invalid();
  problem.set_objective(test::tool_metric(), x_free);
  problem.add_contact(good, 1.0, 1.0);
  solve_cold();
  EXPECT_EQ(solution.status, ConstraintStatus::kConverged) << "a new objective starts afresh";
}

TEST_F(ConstraintSolverTest, AStartThatIsNotFiniteCounts) {
  test::RandomProblems random(5);
  random.fill_feasible(problem, 30, kCompliance);
  const Vector6 bad = Vector6::Constant(std::numeric_limits<double>::quiet_NaN());
  ConstraintSolver<6>().solve(problem, bad, workspace, solution);
  EXPECT_EQ(solution.status, ConstraintStatus::kConverged);
  EXPECT_LE(constraint_residual(problem, solution).greatest(), 1e-10);
}

TEST(ConstraintSolverTwoBlocks, CoupledMetricAndRowsOnBoth) {
  ConstraintProblem<12> problem(256);
  ConstraintWorkspace<12> workspace(problem);
  ConstraintSolution<12> solution(problem);
  test::RandomProblems random(6);
  for (const double c : {0.0, 1e-9, 1e-5})
    for (int i = 0; i < 100; ++i) {
      UnknownsMatrix<12> K = UnknownsMatrix<12>::Zero();
      K.topLeftCorner<6, 6>() = test::tool_metric();
      K.bottomRightCorner<6, 6>() = test::tool_metric(500.0, 0.3);
      for (int s = 0; s < 5; ++s) {
        Unknowns<12> spring;
        spring << contact_row(random.direction(), random.point()), contact_row(random.direction(), random.point());
        K += 2000.0 * spring * spring.transpose();
      }
      problem.set_objective(K, Unknowns<12>::Zero());
      Unknowns<12> inside;
      for (int j = 0; j < 12; ++j) inside[j] = random.uniform(-2e-3, 2e-3);
      for (int row = 0; row < 100; ++row) {
        Unknowns<12> J;
        const Vector3 n = random.direction();
        J << contact_row(n, random.point()), contact_row(-n, random.point());
        problem.add_contact(J, J.dot(inside) - random.uniform(0.0, 1e-3), c / kStiffness);
      }
      workspace.reset();
      ConstraintSolver<12>().solve(problem, workspace, solution);
      EXPECT_EQ(solution.status, ConstraintStatus::kConverged);
      EXPECT_LE(constraint_residual(problem, solution).greatest(), 1e-10);
    }
}

}  // namespace
}  // namespace tegotae
