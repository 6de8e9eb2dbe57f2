// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/constraint_residual.hpp>
#include <tegotae/render/constraint_solver.hpp>

#include <gtest/gtest.h>
#include <tests/render/constraint_problems.hpp>

namespace tegotae {
namespace {

using test::contact_row;
using test::kCompliance;
using test::kStiffness;

TEST(ConstraintSolver, ResidualOfRandomSets) {
  ConstraintProblem<6> problem;
  ConstraintWorkspace<6> workspace(problem);
  ConstraintSolution<6> solution(problem);
  test::RandomProblems random(1);
  for (const double c : {0.0, 1e-12, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-3})
    for (const int rows : {1, 2, 3, 5, 8, 18, 60, 230, 1000, 5000}) {
      const int cases = rows <= 230 ? 50 : 5;
      for (int i = 0; i < cases; ++i) {
        if (i % 2 == 0)
          random.fill_feasible(problem, rows, c / kStiffness);
        else
          random.fill_planes(problem, rows, c / kStiffness);
        workspace.reset();
        ConstraintSolver<6>().solve(problem, workspace, solution);
        const ConstraintResidual residual = constraint_residual(problem, solution);
        EXPECT_EQ(solution.status, ConstraintStatus::kConverged) << rows << " rows, c " << c;
        EXPECT_LE(residual.greatest(), 1e-10)
            << rows << " rows, c " << c << " " << residual.stationarity << " " << residual.contact_law;
      }
    }
}

}  // namespace
}  // namespace tegotae
