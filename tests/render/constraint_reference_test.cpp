// SPDX-License-Identifier: Apache-2.0
// Agreement with slow solvers that share nothing with the one under test.
#include <tegotae/render/constraint_solver.hpp>

#include <gtest/gtest.h>
#include <tests/render/constraint_problems.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

namespace tegotae {
namespace {

using test::contact_row;
using test::kStiffness;
// Plain loops on long double rather than Eigen's decompositions, which cost minutes to compile under sanitizers.
using Real = long double;
using RealVector = std::vector<Real>;

Real dot(const RealVector& a, const RealVector& b) {
  Real sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

// Gaussian elimination with row pivoting; nothing where A is singular.
std::optional<RealVector> solve_linear(std::vector<RealVector> A, RealVector b) {
  const std::size_t n = b.size();
  for (std::size_t k = 0; k < n; ++k) {
    std::size_t best = k;
    for (std::size_t i = k + 1; i < n; ++i)
      if (std::abs(A[i][k]) > std::abs(A[best][k])) best = i;
    if (A[best][k] == 0) return std::nullopt;
    std::swap(A[k], A[best]);
    std::swap(b[k], b[best]);
    for (std::size_t i = k + 1; i < n; ++i) {
      const Real factor = A[i][k] / A[k][k];
      for (std::size_t j = k; j < n; ++j) A[i][j] -= factor * A[k][j];
      b[i] -= factor * b[k];
    }
  }
  for (std::size_t k = n; k-- > 0;) {
    for (std::size_t j = k + 1; j < n; ++j) b[k] -= A[k][j] * b[j];
    b[k] /= A[k][k];
  }
  return b;
}

// The dual: minimise over lambda 1/2 lambda^T (J K^-1 J^T + C) lambda - d^T lambda, lambda >= 0, d = b, for x_free = 0
// and diagonal K.
struct Dual {
  explicit Dual(const ConstraintProblem<6>& problem) {
    const int rows = problem.contact_count();
    for (int i = 0; i < rows; ++i) {
      W.emplace_back();
      d.push_back(problem.b(i));
      for (int j = 0; j < rows; ++j) {
        Real sum = i == j ? problem.c(i) : 0.0;
        for (int k = 0; k < 6; ++k)
          sum += static_cast<Real>(problem.J(i)[k]) * problem.J(j)[k] / static_cast<Real>(problem.K()(k, k));
        W.back().push_back(sum);
      }
    }
  }
  std::vector<RealVector> W;
  RealVector d;
};

// All subsets of the rows as the active set: the one whose multipliers and gaps have the right signs.
std::optional<RealVector> enumerate(const Dual& dual) {
  const std::size_t rows = dual.d.size();
  for (unsigned set = 0; set < (1u << rows); ++set) {
    std::vector<RealVector> W;
    RealVector d;
    for (std::size_t i = 0; i < rows; ++i) {
      if (((set >> i) & 1u) == 0) continue;
      W.emplace_back();
      d.push_back(dual.d[i]);
      for (std::size_t j = 0; j < rows; ++j)
        if (((set >> j) & 1u) != 0) W.back().push_back(dual.W[i][j]);
    }
    const std::optional<RealVector> solved = solve_linear(W, d);
    if (!solved) continue;
    RealVector lambda(rows, 0);
    for (std::size_t i = 0, next = 0; i < rows; ++i)
      if (((set >> i) & 1u) != 0) lambda[i] = (*solved)[next++];
    bool right = true;
    for (std::size_t i = 0; i < rows; ++i)
      right = right && lambda[i] >= 0 && dot(dual.W[i], lambda) - dual.d[i] >= -1e-15L;
    if (right) return lambda;
  }
  return std::nullopt;
}

// Projected Gauss-Seidel until the multipliers stand still.
RealVector gauss_seidel(const Dual& dual, int sweeps) {
  RealVector lambda(dual.d.size(), 0);
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    Real change = 0, greatest = 0;
    for (std::size_t i = 0; i < lambda.size(); ++i) {
      const Real next = std::max<Real>(0, lambda[i] + (dual.d[i] - dot(dual.W[i], lambda)) / dual.W[i][i]);
      change = std::max(change, std::abs(next - lambda[i]));
      greatest = std::max(greatest, next);
      lambda[i] = next;
    }
    if (change <= 1e-17L * greatest) break;
  }
  return lambda;
}

class ConstraintReference : public ::testing::Test {
 protected:
  void expect_same(const RealVector& reference, double relative) {
    Vector6 force = Vector6::Zero();
    for (int i = 0; i < problem.contact_count(); ++i) force += static_cast<double>(reference[i]) * problem.J(i);
    const double scale = force.norm() + 1e-30;
    EXPECT_LE((solution.force - force).norm(), relative * scale);
    if (problem.least_relative_compliance() > 0.0) {
      for (int i = 0; i < problem.contact_count(); ++i)
        EXPECT_NEAR(solution.multipliers[i], static_cast<double>(reference[i]), relative * scale);
    }
  }
  void solve() {
    workspace.reset();
    ConstraintSolver<6>().solve(problem, workspace, solution);
    ASSERT_EQ(solution.status, ConstraintStatus::kConverged);
  }

  ConstraintProblem<6> problem;
  ConstraintWorkspace<6> workspace{problem};
  ConstraintSolution<6> solution{problem};
};

TEST_F(ConstraintReference, EnumerationOfActiveSets) {
  test::RandomProblems random(1);
  int contacts = 0;
  for (const double c : {0.0, 1e-9, 1e-5, 1e-1})
    for (int i = 0; i < 40; ++i) {
      random.fill_feasible(problem, 7, c / kStiffness);
      solve();
      const Dual dual(problem);
      const std::optional<RealVector> reference = enumerate(dual);
      ASSERT_TRUE(reference.has_value());
      expect_same(*reference, c > 1e-6 ? 1e-9 : 1e-7);
      contacts += static_cast<int>(solution.active_rows.size());
    }
  EXPECT_GT(contacts, 160);
}

TEST_F(ConstraintReference, ProjectedGaussSeidelToConvergence) {
  test::RandomProblems random(2);
  for (const double c : {1e-1, 1.0})
    for (int i = 0; i < 6; ++i) {
      if (i % 2 == 0) {
        random.fill_feasible(problem, 60, c / kStiffness);
      } else {
        random.fill_planes(problem, 60, c / kStiffness);
      }
      solve();
      const Dual dual(problem);
      expect_same(gauss_seidel(dual, 100000), 1e-9);
    }
}

// Friction by projected gradient with momentum on the dual, its projection by bisection.
Vector3 project(const Vector3& lambda, const Vector3& radius) {
  if (lambda.cwiseQuotient(radius).norm() <= 1.0) return lambda;
  double low = 0.0, high = 1e12;
  const auto at = [&](double nu) { return Vector3(lambda.array() / (1.0 + nu / radius.array().square())); };
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (at(middle).cwiseQuotient(radius).norm() > 1.0 ? low : high) = middle;
  }
  return at(high);
}

TEST_F(ConstraintReference, ContactAndFrictionByProjectedGradient) {
  test::RandomProblems random(3);
  int slipping = 0, sticking = 0;
  for (int i = 0; i < 40; ++i) {
    const double c = 1e-1 / kStiffness;
    random.fill_feasible(problem, 4, c);
    FrictionBlock<6> block;
    const Vector3 n = random.direction(), t = n.unitOrthogonal(), r = random.point();
    block.J << contact_row(t, r).transpose(), contact_row(n.cross(t), r).transpose(),
        (Vector6() << Vector3::Zero(), n).finished().transpose();
    block.b = Vector3(random.uniform(-1e-3, 1e-3), random.uniform(-1e-3, 1e-3), random.uniform(-1e-2, 1e-2));
    // Radii in the ratio of the components' units keep the gradient well conditioned.
    const double limit = random.uniform(0.1, 10.0);
    block.compliance = Vector3(c, c, c * 150.0);
    block.radius = Vector3(limit, limit, limit * 0.08);
    problem.add_friction(block);
    solve();

    Eigen::Matrix<double, 7, 6> J;
    Eigen::Matrix<double, 7, 1> d, compliance, lambda = Eigen::Matrix<double, 7, 1>::Zero(), y = lambda;
    for (int row = 0; row < 4; ++row) {
      J.row(row) = problem.J(row).transpose();
      d[row] = problem.b(row);
      compliance[row] = c;
    }
    J.bottomRows<3>() = block.J;
    d.tail<3>() = block.b;
    compliance.tail<3>() = block.compliance;
    Eigen::Matrix<double, 7, 7> W = J * problem.K_inverse() * J.transpose();
    W += compliance.asDiagonal();
    const double step = 1.0 / W.trace();
    for (int iteration = 0; iteration < 200000; ++iteration) {
      Eigen::Matrix<double, 7, 1> next = y - step * (W * y - d);
      next.head<4>() = next.head<4>().cwiseMax(0.0);
      next.tail<3>() = project(next.tail<3>(), block.radius);
      const double change = (next - lambda).norm();
      // Momentum, restarted where it points uphill.
      y = (W * y - d).dot(next - lambda) > 0.0 ? next : Eigen::Matrix<double, 7, 1>(next + 0.95 * (next - lambda));
      lambda = next;
      if (iteration > 100 && change < 1e-14) break;
    }
    const Vector6 force = J.transpose() * lambda;
    EXPECT_LE((solution.force - force).norm(), 1e-8 * force.norm());
    EXPECT_LE((solution.friction_forces[0] - lambda.tail<3>()).norm(), 1e-7 * force.norm());
    (solution.friction_forces[0].cwiseQuotient(block.radius).norm() > 1.0 - 1e-9 ? slipping : sticking) += 1;
  }
  EXPECT_GT(slipping, 5);
  EXPECT_GT(sticking, 5);
}

}  // namespace
}  // namespace tegotae
