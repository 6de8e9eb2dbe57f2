// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/quadratic_program.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <vector>

namespace tegotae {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

std::vector<int> all_columns(Eigen::Index size) {
  std::vector<int> columns(static_cast<size_t>(size));
  for (size_t i = 0; i < columns.size(); ++i) columns[i] = static_cast<int>(i);
  return columns;
}

// lower <= y <= upper
InequalityGroup bounds(double lower, double upper, Eigen::Index size) {
  InequalityGroup rows{MatrixXd(2 * size, size), VectorXd(2 * size), all_columns(size)};
  rows.A << MatrixXd::Identity(size, size), -MatrixXd::Identity(size, size);
  rows.b << VectorXd::Constant(size, lower), VectorXd::Constant(size, -upper);
  return rows;
}

// The greatest violation of the conditions of Karush, Kuhn and Tucker.
double residual(const QuadraticProgram& program, const QuadraticSolution& solution) {
  VectorXd gradient = program.H * solution.y + program.g;
  double worst = 0.0;
  for (size_t i = 0; i < program.groups.size(); ++i) {
    const InequalityGroup& group = program.groups[i];
    const VectorXd& z = solution.multipliers[i];
    const VectorXd part = group.A.transpose() * z;
    gradient(group.columns) -= part;
    const VectorXd y = solution.y(group.columns);
    const VectorXd slack = group.A * y - group.b;
    worst = std::max({worst, -slack.minCoeff(), -z.minCoeff(), slack.cwiseProduct(z).lpNorm<Eigen::Infinity>()});
  }
  return std::max(worst, gradient.lpNorm<Eigen::Infinity>());
}

TEST(QuadraticProgram, WithoutRowsIsNewtonsStep) {
  QuadraticProgram program{MatrixXd::Identity(2, 2) * 4.0, Eigen::Vector2d(8.0, -2.0), {}};
  const QuadraticSolution solution = solve(program);
  EXPECT_TRUE(solution.converged);
  EXPECT_NEAR(solution.y[0], -2.0, 1e-12);
  EXPECT_NEAR(solution.y[1], 0.5, 1e-12);
}

TEST(QuadraticProgram, BoundsHoldAndPushWithTheGradient) {
  QuadraticProgram program{MatrixXd::Identity(3, 3), Eigen::Vector3d(-3.0, 0.25, 7.0), {bounds(-1.0, 1.0, 3)}};
  const QuadraticSolution solution = solve(program);
  ASSERT_TRUE(solution.converged);
  EXPECT_LT((solution.y - Eigen::Vector3d(1.0, -0.25, -1.0)).norm(), 1e-9);
  EXPECT_NEAR(solution.multipliers[0][2], 6.0, 1e-8);  // lower bound of the third
  EXPECT_NEAR(solution.multipliers[0][3], 2.0, 1e-8);  // upper bound of the first
  EXPECT_NEAR(solution.multipliers[0][1], 0.0, 1e-8);
}

TEST(QuadraticProgram, LinearProgramEndsInACorner) {
  QuadraticProgram program{MatrixXd::Zero(2, 2), Eigen::Vector2d(-1.0, -2.0), {bounds(0.0, 3.0, 2)}};
  InequalityGroup sum{MatrixXd::Constant(1, 2, -1.0), VectorXd::Constant(1, -4.0), {0, 1}};  // y0 + y1 <= 4
  program.groups.push_back(sum);
  const QuadraticSolution solution = solve(program);
  ASSERT_TRUE(solution.converged);
  EXPECT_LT((solution.y - Eigen::Vector2d(1.0, 3.0)).norm(), 1e-8);
}

TEST(QuadraticProgram, RandomProgramsMeetTheirConditions) {
  std::mt19937 engine(3);
  std::normal_distribution<double> normal;
  const auto random = [&](Eigen::Index rows, Eigen::Index columns) {
    return MatrixXd::NullaryExpr(rows, columns, [&] { return normal(engine); });
  };
  for (int trial = 0; trial < 300; ++trial) {
    const Eigen::Index size = 3 + trial % 8, rows = 1 + trial % 60;
    const MatrixXd root = random(size, size);
    QuadraticProgram program{root.transpose() * root, random(size, 1), {}};
    // Feasible at a random point; every third row is there twice, every fifth nearly.
    InequalityGroup group{random(rows, size), VectorXd(), all_columns(size)};
    for (Eigen::Index i = 2; i < rows; i += 3) group.A.row(i) = group.A.row(i - 1);
    for (Eigen::Index i = 4; i < rows; i += 5) group.A.row(i) = group.A.row(i - 1) + 1e-7 * random(1, size);
    group.b = group.A * random(size, 1) - random(rows, 1).cwiseAbs();
    program.groups = {group, bounds(-50.0, 50.0, size)};
    const QuadraticSolution solution = solve(program);
    ASSERT_TRUE(solution.converged) << "trial " << trial;
    EXPECT_LT(residual(program, solution), 1e-6) << "trial " << trial;
  }
}

TEST(QuadraticProgram, IndefiniteProgramGoesDownToABound) {
  MatrixXd H = MatrixXd::Identity(2, 2);
  H(1, 1) = -1.0;
  QuadraticProgram program{H, Eigen::Vector2d(-0.5, -0.1), {bounds(-2.0, 2.0, 2)}};
  const QuadraticSolution solution = solve(program);
  ASSERT_TRUE(solution.converged);
  EXPECT_NEAR(solution.y[0], 0.5, 1e-8);
  EXPECT_NEAR(solution.y[1], 2.0, 1e-8);
}

TEST(QuadraticProgram, StiffOpposedRowsMeetMidway) {
  // y + s0 >= 1, -y + s1 >= 1, each slack a million times dearer than y.
  QuadraticProgram program{
      Eigen::Vector3d(1.0, 1e6, 1e6).asDiagonal().toDenseMatrix(), Eigen::Vector3d(-5.0, 0.0, 0.0), {}};
  InequalityGroup rows{MatrixXd(2, 3), VectorXd::Ones(2), {0, 1, 2}};
  rows.A << 1.0, 1.0, 0.0, -1.0, 0.0, 1.0;
  program.groups = {rows};
  const QuadraticSolution solution = solve(program);
  ASSERT_TRUE(solution.converged);
  EXPECT_NEAR(solution.y[0], 5.0 / (1.0 + 2e6), 1e-9);
  EXPECT_NEAR(solution.y[1], 1.0, 1e-5);
}

}  // namespace
}  // namespace tegotae
