// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/render/constraint_problem.hpp>

namespace tegotae {

/// Solves a ConstraintProblem (see there for the mathematics).
///
/// Method. The N unknowns are found by a semi-smooth Newton method with a line search on the primal objective, which is
/// convex, once differentiable and (without sliding friction) piecewise quadratic: as soon as the set of active rows is
/// right, one step is exact. Violations are carried along rather than recomputed, so that forces stay consistent to
/// rounding although a row's stiffness may be 1e7 times the coupling's. Cost: linear in the rows, and only the rows
/// that the steps can reach are visited more than once.
/// Rows harder than `tolerance::kDirectCompliance` go through the proximal method of multipliers, which adds
/// sigma/2 |lambda - lambda_before|^2 to the dual, sigma falling from stage to stage; each stage is again the problem
/// above, with compliance c + sigma and right-hand side b + sigma lambda_before. For contradicting hard rows its
/// primal iterates tend to the least-squares compromise, at which the forces' resultant is still defined.
///
/// Convergence. |K (x - x_free) - J^T lambda| in the norm of K^-1 is at most tolerance::kStationarity times
/// |x - x_free| in that of K, plus tolerance::kStationarityRounding times the sum of all pushing forces; lambda obeys
/// its law to rounding, for nearly hard rows within tolerance::kHardRowViolation of the greatest violation at x_free.
///
/// Sources: Hintermüller, Ito and Kunisch, "The primal-dual active set strategy as a semismooth Newton method", SIAM J.
/// Optim. 13 (2002); Rockafellar, "Augmented Lagrangians and applications of the proximal point algorithm", Math. Oper.
/// Res. 1 (1976); Chiche and Gilbert, "How the augmented Lagrangian algorithm can deal with an infeasible convex
/// quadratic optimization problem", J. Convex Anal. 23 (2016); Castro et al., "An unconstrained convex formulation of
/// compliant contact", IEEE Trans. Robotics 39 (2023), for the line search in contact problems.
///
/// Allocates nothing, throws nothing; every loop is bounded. The answer does not depend on the start or on the
/// workspace's past beyond rounding, except for the multipliers of redundant hard rows, which are not unique.
template <int N>
class ConstraintSolver {
 public:
  /// Solves from `x_start` (for instance the last tick's x): near the answer it saves iterations. The workspace and the
  /// solution must have been made for a problem of at least this capacity.
  void solve(const ConstraintProblem<N>& problem, const Unknowns<N>& x_start, ConstraintWorkspace<N>& workspace,
             ConstraintSolution<N>& solution) const noexcept;

  /// Solves from x_free.
  void solve(const ConstraintProblem<N>& problem, ConstraintWorkspace<N>& workspace,
             ConstraintSolution<N>& solution) const noexcept {
    solve(problem, problem.x_free(), workspace, solution);
  }
};

extern template class ConstraintSolver<6>;
extern template class ConstraintSolver<12>;

}  // namespace tegotae
