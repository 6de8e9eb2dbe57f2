// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/constraint_problem.hpp>

#include <Eigen/Cholesky>

namespace tegotae {

template <int N>
ConstraintProblem<N>::ConstraintProblem(int row_capacity, int friction_capacity)
    : contact_capacity_(std::max(row_capacity, 0)),
      groups_((contact_capacity_ + kRowLanes - 1) / kRowLanes),
      compliances_(groups_.size()) {
  friction_.reserve(std::max(friction_capacity, 0));
}

template <int N>
void ConstraintProblem<N>::set_objective(const UnknownsMatrix<N>& K, const Unknowns<N>& x_free) noexcept {
  contact_count_ = 0;
  dropped_count_ = 0;
  friction_.clear();
  row_norm_squared_ = 0.0;
  least_compliance_ = std::numeric_limits<double>::infinity();
  least_friction_compliance_ = std::numeric_limits<double>::infinity();
  K_ = K;
  x_free_ = x_free;
  const Eigen::LLT<Eigen::Matrix<double, N, N>> factor(K);
  constexpr double kSymmetry = 1e-9;  // relative: what assembling K in floating point may leave
  valid_ = K.allFinite() && x_free.allFinite() && factor.info() == Eigen::Success &&
           (K - K.transpose()).cwiseAbs().maxCoeff() <= kSymmetry * K.cwiseAbs().maxCoeff();
  if (!valid_) return;
  K_inverse_ = factor.solve(Eigen::Matrix<double, N, N>::Identity());
  // A symmetric positive definite matrix is at most N times its diagonal.
  const bool diagonal = K.isDiagonal(0.0);
  norm_weights_ = K_inverse_.diagonal() * (diagonal ? 1.0 : static_cast<double>(N));
}

template <int N>
bool ConstraintProblem<N>::add_friction(const FrictionBlock<N>& block) noexcept {
  if (friction_.size() == friction_.capacity()) {
    ++dropped_count_;
    return false;
  }
  friction_.push_back(block);
  valid_ = valid_ && block.J.allFinite() && block.b.allFinite() && block.compliance.allFinite() &&
           (block.compliance.array() >= 0.0).all() && (block.radius.array() >= 0.0).all();
  for (int j = 0; j < 3; ++j)
    if (block.radius[j] > 0.0) {
      const double norm_squared = norm_weights_.dot(block.J.row(j).transpose().cwiseAbs2());
      if (norm_squared > 0.0)
        least_friction_compliance_ = std::min(least_friction_compliance_, block.compliance[j] / norm_squared);
    }
  return true;
}

template <int N>
bool ConstraintProblem<N>::add_spring(const Unknowns<N>& J, double target, double c) noexcept {
  FrictionBlock<N> block;
  block.J.setZero();
  block.J.row(0) = J.transpose();
  block.b[0] = target;
  block.compliance[0] = c;
  block.radius[0] = std::numeric_limits<double>::infinity();
  return add_friction(block);
}

template <int N>
ConstraintWorkspace<N>::ConstraintWorkspace(const ConstraintProblem<N>& problem) {
  const std::size_t groups = (problem.contact_capacity() + kRowLanes - 1) / kRowLanes;
  violation.resize(groups);
  change.resize(groups);
  previous.resize(groups);
  regularised.resize(groups);
  violated.resize(groups);
  active.resize(groups);
  near_groups.reserve(groups);
  guess_groups.reserve(groups);
  guess_active.reserve(groups);
  friction.resize(problem.friction_capacity());
}

template <int N>
void ConstraintWorkspace<N>::reset() noexcept {
  guess_groups.clear();
  guess_active.clear();
  guess_friction_count = 0;
}

template class ConstraintProblem<6>;
template class ConstraintProblem<12>;
template struct ConstraintWorkspace<6>;
template struct ConstraintWorkspace<12>;

}  // namespace tegotae
