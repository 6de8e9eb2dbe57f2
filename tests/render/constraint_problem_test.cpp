// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/constraint_problem.hpp>

#include <gtest/gtest.h>
#include <tests/render/constraint_problems.hpp>

namespace tegotae {
namespace {

TEST(ConstraintProblem, KeepsRowsAsGiven) {
  ConstraintProblem<6> problem(100, 4);
  problem.set_objective(test::tool_metric(), Vector6::Zero());
  test::RandomProblems random(1);
  std::vector<Vector6> rows;
  double greatest = 0.0;
  for (int i = 0; i < 21; ++i) {
    rows.push_back(test::contact_row(random.direction(), random.point()));
    EXPECT_TRUE(problem.add_contact(rows.back(), 0.1 * i, 0.2 * i));
    greatest = std::max(greatest, std::sqrt(rows.back().dot(problem.K_inverse() * rows.back())));
  }
  ASSERT_EQ(problem.contact_count(), 21);
  ASSERT_EQ(problem.group_count(), 3);
  for (int i = 0; i < 21; ++i) {
    EXPECT_EQ(problem.J(i), rows[i]);
    EXPECT_EQ(problem.b(i), 0.1 * i);
    EXPECT_EQ(problem.c(i), 0.2 * i);
  }
  for (int lane = 5; lane < 8; ++lane) {
    EXPECT_EQ(problem.groups()[2].b[lane], -1.0);
    EXPECT_TRUE((problem.groups()[2].J.row(lane) == 0.0).all());
  }
  EXPECT_NEAR(problem.row_norm(), greatest, 1e-14);
}

TEST(ConstraintProblem, RowsBeyondTheCapacityAreCounted) {
  ConstraintProblem<6> problem(10, 2);
  problem.set_objective(test::tool_metric(), Vector6::Zero());
  for (int i = 0; i < 15; ++i) EXPECT_EQ(problem.add_contact(Vector6::Ones(), 0.0, 0.0), i < 10);
  for (int i = 0; i < 5; ++i) EXPECT_EQ(problem.add_spring(Vector6::Ones(), 0.0, 1.0), i < 2);
  EXPECT_EQ(problem.dropped_count(), 8);
  EXPECT_EQ(problem.contact_count(), 10);
  EXPECT_EQ(problem.friction_count(), 2);
  problem.set_objective(test::tool_metric(), Vector6::Zero());
  EXPECT_EQ(problem.dropped_count(), 0);
  EXPECT_EQ(problem.contact_count(), 0);
  EXPECT_EQ(problem.group_count(), 0);
}

TEST(ConstraintProblem, RowNormBoundsEveryRowInACoupledMetric) {
  ConstraintProblem<12> problem(64);
  UnknownsMatrix<12> A = UnknownsMatrix<12>::Random();
  problem.set_objective(A * A.transpose() + 0.01 * UnknownsMatrix<12>::Identity(), Unknowns<12>::Zero());
  ASSERT_TRUE(problem.is_valid());
  for (int i = 0; i < 64; ++i) {
    const Unknowns<12> J = Unknowns<12>::Random();
    problem.add_contact(J, 0.0, 1.0);
    EXPECT_GE(problem.row_norm(), (1.0 - 1e-12) * std::sqrt(J.dot(problem.K_inverse() * J)));
  }
}

TEST(ConstraintProblem, RefusesAMetricThatIsNotSymmetric) {
  ConstraintProblem<6> problem(8);
  Matrix6 K = test::tool_metric();
  K(0, 1) = 1.0;
  problem.set_objective(K, Vector6::Zero());
  EXPECT_FALSE(problem.is_valid());
}

}  // namespace
}  // namespace tegotae
