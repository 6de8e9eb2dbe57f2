// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/spidar_kinematics.hpp>

#include <tegotae/device/tolerances.hpp>

#include <Eigen/Cholesky>

#include <cmath>
#include <limits>

namespace tegotae {
namespace {

using NormalFactors = Eigen::LDLT<Eigen::Matrix<double, 6, 6>>;

/// Rows of the wrench matrix, torque over the knots' radius: all of the order of 1.
SpidarWrenchMatrix scaled(const SpidarWrenchMatrix& W, double radius) noexcept {
  SpidarWrenchMatrix result = W;
  result.bottomRows<3>() /= radius;
  return result;
}

bool is_regular(const NormalFactors& factors) noexcept {
  const auto& pivots = factors.vectorD();
  return factors.info() == Eigen::Success && pivots.minCoeff() > tolerance::kSpidarNormalPivot * pivots.maxCoeff();
}

double rms(const SpidarVector& error) noexcept { return error.norm() / std::sqrt(double{kSpidarStrings}); }

Pose moved(const Pose& X_SG, const Vector6& step, double radius, double share) noexcept {
  return displaced(X_SG, X_SG.p, share * step.head<3>(), share / radius * step.tail<3>());
}

}  // namespace

SpidarPose spidar_pose(const SpidarGeometry& geometry, const SpidarVector& lengths, const Pose& guess) noexcept {
  SpidarPose result;
  result.X_SG = guess;
  if (!lengths.allFinite() || !guess.is_finite()) return result;
  const double radius = knot_radius(geometry);
  Pose X_SG = guess;
  SpidarStrings strings = spidar_strings(geometry, X_SG);
  SpidarVector error = strings.lengths - lengths;
  for (; result.steps < tolerance::kSpidarSteps; ++result.steps) {
    const SpidarWrenchMatrix W = scaled(strings.wrenches, radius);
    const NormalFactors factors(W * W.transpose());
    result.misfit = rms(error);
    if (!is_regular(factors)) {
      result.fit = SpidarFit::kSingular;
      return result;
    }
    const Vector6 step = factors.solve(W * error);
    const bool is_last = step.norm() <= tolerance::kSpidarStep;
    double share = 1.0;
    for (int halving = 0;; ++halving, share *= 0.5) {
      const Pose trial = moved(X_SG, step, radius, share);
      strings = spidar_strings(geometry, trial);
      const SpidarVector trial_error = strings.lengths - lengths;
      if (!is_last && halving < tolerance::kSpidarHalvings && !(trial_error.norm() < error.norm())) continue;
      X_SG = trial;
      error = trial_error;
      break;
    }
    if (is_last) {
      result.X_SG = X_SG;
      result.misfit = rms(error);
      result.fit = SpidarFit::kConverged;
      ++result.steps;
      return result;
    }
  }
  result.fit = SpidarFit::kNotConverged;
  return result;
}

Matrix6 spidar_quantisation(const SpidarGeometry& geometry, const Pose& X_SG) noexcept {
  const double radius = knot_radius(geometry);
  SpidarWrenchMatrix W = scaled(spidar_strings(geometry, X_SG).wrenches, radius);
  for (int i = 0; i < kSpidarStrings; ++i) {
    W.col(i) *= std::sqrt(12.0) / std::abs(geometry.strings[static_cast<std::size_t>(i)].metres_per_pulse);
  }
  const NormalFactors factors(W * W.transpose());
  if (!is_regular(factors)) return Matrix6::Constant(std::numeric_limits<double>::quiet_NaN());
  Matrix6 covariance = factors.solve(Eigen::Matrix<double, 6, 6>::Identity());
  covariance.bottomRows<3>() /= radius;
  covariance.rightCols<3>() /= radius;
  return covariance;
}

}  // namespace tegotae
