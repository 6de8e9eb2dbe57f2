// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/render/constraint_problem.hpp>
#include <tegotae/render/row_lanes.hpp>

#include <type_traits>

namespace tegotae::internal {

/// Semi-smooth Newton iteration on z = x - x_free for fixed compliances: the inner part of ConstraintSolver.
/// `Scalar` is the precision of Newton's matrix and its factor: double, or long double where rows are nearly hard.
template <int N, class Scalar>
class ConstraintNewton {
 public:
  /// Works with the rows of `problem`, the compliances given (one entry a group), and those of the workspace's friction
  /// states.
  ConstraintNewton(const ConstraintProblem<N>& problem, const RowCompliance* compliances,
                   ConstraintWorkspace<N>& workspace) noexcept;

  /// One step from z as if exactly the rows active at the end of the last solve were active.
  void step_on_guess(Unknowns<N>& z) noexcept;

  /// Computes violations at z afresh, with the proximal shift of `previous` multipliers where `shifted`.
  void scan(const Unknowns<N>& z, bool shifted) noexcept;

  /// Iterates from z, at which `scan` was called last, to convergence. False at the iteration limit.
  bool minimise(Unknowns<N>& z) noexcept;

  int iterations() const noexcept { return iterations_; }
  int line_search_steps() const noexcept { return line_search_steps_; }

 private:
  using Matrix = Eigen::Matrix<Scalar, N, N, Eigen::DontAlign>;
  using MatrixSum = std::conditional_t<std::is_same_v<Scalar, double>, Pair, Scalar>;
  struct Slope {
    double first, second;
  };

  void scan_friction(const Unknowns<N>& x, bool shifted) noexcept;
  void add_group_to_matrix(int group, const Lanes& weight) noexcept;
  void begin_gradient() noexcept;
  void add_group_to_gradient(int group, const Lanes& violation) noexcept;
  void finish_gradient(const Unknowns<N>& z) noexcept;
  void evaluate_friction() noexcept;
  void update_active_set() noexcept;
  void find_direction() noexcept;
  void step(Unknowns<N>& z) noexcept;
  void step_back(Unknowns<N>& z, double back) noexcept;
  Slope slope_before(const Unknowns<N>& z, double back) const noexcept;
  double search_back(const Unknowns<N>& z, double initial_slope) noexcept;
  double stationarity() const noexcept;
  double stationarity_bound(const Unknowns<N>& z, double relative) const noexcept;

  const ConstraintProblem<N>& problem_;
  const RowCompliance* compliances_;
  ConstraintWorkspace<N>& workspace_;

  MatrixSum contact_matrix_[N][N];  ///< sum of J^T J / c over the active rows, lower triangle
  Pair push_[N], push_sum_;         ///< J^T lambda and the sum of all lambda
  Unknowns<N> gradient_;            ///< K z - J^T lambda
  Unknowns<N> direction_;
  double start_residual_ = 0.0;  ///< stationarity before the step on the guess
  double force_sum_ = 0.0;       ///< bound of the sum of |J_i^T lambda_i| in the norm of K^-1
  double reach_ = 0.0;           ///< movement |change of z|_K that the near groups still cover
  bool shifted_ = false;
  int iterations_ = 0;
  int line_search_steps_ = 0;
};

}  // namespace tegotae::internal
