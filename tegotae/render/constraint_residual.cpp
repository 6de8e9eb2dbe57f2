// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/constraint_residual.hpp>

#include <Eigen/Cholesky>

#include <algorithm>
#include <cmath>

namespace tegotae {
namespace {

using Real = long double;

template <int N>
class Residual {
 public:
  using VectorN = Eigen::Matrix<Real, N, 1>;
  using MatrixN = Eigen::Matrix<Real, N, N>;

  Residual(const ConstraintProblem<N>& problem, const ConstraintSolution<N>& solution) noexcept
      : problem_(problem),
        solution_(solution),
        K_(problem.K().template cast<Real>()),
        factor_(K_),
        x_free_(problem.x_free().template cast<Real>()),
        z_(solution.displacement.template cast<Real>()),
        imbalance_(K_ * z_),
        force_scale_(std::sqrt(z_.dot(K_ * z_))) {}

  ConstraintResidual compute() noexcept {
    for (int i = 0; i < problem_.contact_count(); ++i) add_contact(i);
    for (int f = 0; f < problem_.friction_count(); ++f) add_friction(f);
    ConstraintResidual residual;
    residual.stationarity = ratio(dual_norm(imbalance_), force_scale_);
    residual.contact_law = ratio(contact_error_, length_scale_);
    residual.friction_law = static_cast<double>(friction_error_);
    return residual;
  }

 private:
  static double ratio(Real error, Real scale) noexcept { return error > 0 ? static_cast<double>(error / scale) : 0.0; }
  Real dual_norm(const VectorN& force) const noexcept { return std::sqrt(force.dot(factor_.solve(force))); }

  void balance(const VectorN& force) noexcept {
    imbalance_ -= force;
    force_scale_ = std::max(force_scale_, dual_norm(force));
  }

  void add_contact(int i) noexcept {
    const VectorN J = problem_.J(i).template cast<Real>();
    const Real lambda = solution_.multipliers[i], c = problem_.c(i);
    const Real violation_at_free = static_cast<Real>(problem_.b(i)) - J.dot(x_free_);
    const Real gap = J.dot(z_) + c * lambda - violation_at_free;
    const Real own = J.dot(factor_.solve(J));
    if (lambda != 0) balance(J * lambda);
    contact_error_ = std::max(contact_error_, std::abs(std::min((c + own) * lambda, gap)));
    length_scale_ = std::max({length_scale_, violation_at_free, std::abs(J.dot(z_))});
  }

  // In components scaled by the radii, p_j = lambda_j / r_j and e_j = (s_j - c_j lambda_j) r_j, the law is: |p| <= 1,
  // and e is zero inside and a non-negative multiple of p on the boundary.
  void add_friction(int f) noexcept {
    const FrictionBlock<N>& block = problem_.friction(f);
    Eigen::Matrix<Real, 3, 1> p = Eigen::Matrix<Real, 3, 1>::Zero(), e = p, scale = p;
    Real free_error = 0;
    for (int j = 0; j < 3; ++j) {
      const VectorN J = block.J.row(j).transpose().template cast<Real>();
      const Real lambda = solution_.friction_forces[f][j], c = block.compliance[j], r = block.radius[j];
      const Real at_free = static_cast<Real>(block.b[j]) - J.dot(x_free_);
      const Real slip = at_free - J.dot(z_) - c * lambda;
      const Real slip_scale = std::max({std::abs(at_free), std::abs(J.dot(z_)), c * std::abs(lambda)});
      if (lambda != 0) balance(J * lambda);
      if (r == 0) {
        friction_error_ = std::max(friction_error_, std::abs(lambda));
      } else if (std::isinf(r)) {
        free_error = std::max(free_error, slip_scale > 0 ? std::abs(slip) / slip_scale : 0);
      } else {
        p[j] = lambda / r;
        e[j] = slip * r;
        scale[j] = slip_scale * r;
      }
    }
    const Real size = p.norm(), normal = size > 0 ? std::max<Real>(0, e.dot(p) / (size * size)) : 0;
    const Real complementarity = std::min(normal * size, std::max<Real>(0, 1 - size) * scale.maxCoeff());
    const Real astray = std::max((e - normal * p).norm(), complementarity);
    friction_error_ = std::max({friction_error_, free_error, std::max<Real>(0, size - 1)});
    if (astray > 0) friction_error_ = std::max(friction_error_, astray / scale.maxCoeff());
  }

  const ConstraintProblem<N>& problem_;
  const ConstraintSolution<N>& solution_;
  MatrixN K_;
  Eigen::LLT<MatrixN> factor_;
  VectorN x_free_, z_, imbalance_;
  Real force_scale_ = 0, length_scale_ = 0, contact_error_ = 0, friction_error_ = 0;
};

}  // namespace

template <int N>
ConstraintResidual constraint_residual(const ConstraintProblem<N>& problem,
                                       const ConstraintSolution<N>& solution) noexcept {
  return Residual<N>(problem, solution).compute();
}

template ConstraintResidual constraint_residual<6>(const ConstraintProblem<6>&, const ConstraintSolution<6>&) noexcept;
template ConstraintResidual constraint_residual<12>(const ConstraintProblem<12>&,
                                                    const ConstraintSolution<12>&) noexcept;

}  // namespace tegotae
