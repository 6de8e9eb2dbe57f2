// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/render/constraint_problem.hpp>

namespace tegotae {

/// How far an answer is from the optimality (Karush-Kuhn-Tucker) conditions of its ConstraintProblem. All relative.
struct ConstraintResidual {
  /// |K (x - x_free) - J^T lambda| in the norm of K^-1, relative to the greater of |x - x_free| in the norm of K and
  /// the greatest |J_i^T lambda_i| of one row in the norm of K^-1.
  double stationarity = 0.0;
  /// Greatest of |min(lambda_i c', J_i x + c_i lambda_i - b_i)| over the contact rows, c' = c_i + the coupling's own
  /// compliance at the row, relative to the greatest violation at x_free or displacement of a row.
  double contact_law = 0.0;
  /// The same for friction: excess over the ellipsoid, and slip s - C lambda that does not point along its normal.
  double friction_law = 0.0;

  double greatest() const noexcept { return std::max({stationarity, contact_law, friction_law}); }
};

/// Evaluates the conditions as written in ConstraintProblem, in extended precision, from `x_free + displacement`,
/// `multipliers` and `friction_forces`. Linear in rows; for tests and diagnosis, not for the tick. Allocates nothing.
template <int N>
ConstraintResidual constraint_residual(const ConstraintProblem<N>& problem,
                                       const ConstraintSolution<N>& solution) noexcept;

extern template ConstraintResidual constraint_residual<6>(const ConstraintProblem<6>&,
                                                          const ConstraintSolution<6>&) noexcept;
extern template ConstraintResidual constraint_residual<12>(const ConstraintProblem<12>&,
                                                           const ConstraintSolution<12>&) noexcept;

}  // namespace tegotae
