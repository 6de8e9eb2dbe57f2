// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <vector>

namespace tegotae {

/// Rows A y(columns) >= b of a quadratic program, over a few of its unknowns.
struct InequalityGroup {
  Eigen::MatrixXd A;
  Eigen::VectorXd b;
  std::vector<int> columns;
};

/// minimise 1/2 y^T H y + g^T y subject to the rows of all groups. Dimensionless and well scaled: rows and unknowns of
/// the order of 1. H need not be positive definite, but the rows must bound y where it is not.
struct QuadraticProgram {
  Eigen::MatrixXd H;
  Eigen::VectorXd g;
  std::vector<InequalityGroup> groups;
};

/// A point where the conditions of Karush, Kuhn and Tucker hold: a minimum where H is positive definite.
struct QuadraticSolution {
  Eigen::VectorXd y;
  std::vector<Eigen::VectorXd> multipliers;  ///< >= 0, of each row of each group
  bool converged = false;
  int iterations = 0;
};

/// Solves `program` by a primal-dual interior-point method with Mehrotra's predictor and corrector (S. Mehrotra, SIAM
/// J. Optim. 2(4), 1992; Nocedal and Wright, Numerical Optimization, section 16.6). Where H is indefinite, Newton's
/// matrix is shifted until it is positive definite. Allocates.
QuadraticSolution solve(const QuadraticProgram& program);

}  // namespace tegotae
