// SPDX-License-Identifier: Apache-2.0
// Agreement with slow solvers that share nothing with the one under test.
#include <tegotae/render/constraint_solver.hpp>

#include <Eigen/Dense>

#include <gtest/gtest.h>
#include <tests/render/constraint_problems.hpp>

#include <cmath>
#include <optional>
#include <vector>

namespace tegotae {
namespace {

using test::contact_row;
using test::kStiffness;
using Real = long double;
using RealVector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
using RealMatrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;

// The dual: minimise over lambda 1/2 lambda^T (J K^-1 J^T + C) lambda - d^T lambda, lambda >= 0, d = b - J x_free.
struct Dual {
  explicit Dual(const ConstraintProblem<6>& problem) : J(problem.contact_count(), 6), d(problem.contact_count()) {
    const RealMatrix K_inverse = RealMatrix(problem.K().cast<Real>()).inverse();
    RealVector c(problem.contact_count());
    for (int i = 0; i < problem.contact_count(); ++i) {
      J.row(i) = problem.J(i).cast<Real>().transpose();
      d[i] = problem.b(i) - J.row(i).dot(problem.x_free().cast<Real>());
      c[i] = problem.c(i);
    }
    W = J * K_inverse * J.transpose();
    W.diagonal() += c;
  }
  RealMatrix J, W;
  RealVector d;
};

// All subsets of at most six rows as the active set: the one whose multipliers and gaps have the right signs.
std::optional<RealVector> enumerate(const Dual& dual) {
  const int rows = static_cast<int>(dual.d.size());
  for (unsigned set = 0; set < (1u << rows); ++set) {
    std::vector<int> active;
    for (int i = 0; i < rows; ++i)
      if ((set >> i) & 1u) active.push_back(i);
    const int n = static_cast<int>(active.size());
    RealMatrix W(n, n);
    RealVector d(n);
    for (int i = 0; i < n; ++i) {
      d[i] = dual.d[active[i]];
      for (int j = 0; j < n; ++j) W(i, j) = dual.W(active[i], active[j]);
    }
    if (n > 0 && std::abs(W.fullPivLu().determinant()) == 0) continue;
    RealVector solved = n > 0 ? RealVector(W.fullPivLu().solve(d)) : RealVector(0);
    RealVector lambda = RealVector::Zero(rows);
    for (int i = 0; i < n; ++i) lambda[active[i]] = solved[i];
    const RealVector gap = dual.W * lambda - dual.d;
    if (lambda.minCoeff() >= 0 && gap.minCoeff() >= -1e-15L) return lambda;
  }
  return std::nullopt;
}

// Projected Gauss-Seidel until the multipliers stand still.
RealVector gauss_seidel(const Dual& dual, int sweeps) {
  RealVector lambda = RealVector::Zero(dual.d.size());
  for (int sweep = 0; sweep < sweeps; ++sweep) {
    Real change = 0;
    for (Eigen::Index i = 0; i < dual.d.size(); ++i) {
      const Real next = std::max<Real>(0, lambda[i] + (dual.d[i] - dual.W.row(i).dot(lambda)) / dual.W(i, i));
      change = std::max(change, std::abs(next - lambda[i]));
      lambda[i] = next;
    }
    if (change <= 1e-18L * (1 + lambda.maxCoeff())) break;
  }
  return lambda;
}

class ConstraintReference : public ::testing::Test {
 protected:
  void expect_same(const Dual& dual, const RealVector& reference, double relative) {
    const RealVector force = dual.J.transpose() * reference;
    const double scale = static_cast<double>(force.norm()) + 1e-30;
    EXPECT_LE((solution.force - force.cast<double>()).norm(), relative * scale);
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
      expect_same(dual, *reference, c > 1e-6 ? 1e-9 : 1e-7);
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
      expect_same(dual, gauss_seidel(dual, 100000), 1e-9);
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
    Eigen::Matrix<double, 7, 7> W = J * problem.K().inverse() * J.transpose();
    W += compliance.asDiagonal();
    const double step = 1.0 / W.eigenvalues().real().maxCoeff();
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
