// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/tool_inertia.hpp>

#include <Eigen/Cholesky>

#include <stdexcept>

namespace tegotae {

Matrix3 unit_mean_inertia(const MassProperties& tool) {
  const Matrix3& I = tool.inertia;
  const double mean = I.trace() / 3.0;
  constexpr double kAsymmetry = 1e-9;  // relative; rounding of what was composed of parts stays far below
  const bool symmetric = I.allFinite() && (I - I.transpose()).cwiseAbs().maxCoeff() <= kAsymmetry * mean;
  if (!symmetric || !(mean > 0.0) || Eigen::LLT<Matrix3>(I).info() != Eigen::Success) {
    throw std::invalid_argument("the tool's inertia is not symmetric and positive definite");
  }
  return 0.5 * (I + I.transpose()) / mean;
}

Matrix6 rigid_body_matrix(double linear, double angular, const Matrix3& shape_T, const Matrix3& R_WT) noexcept {
  Matrix6 result = Matrix6::Zero();
  result.topLeftCorner<3, 3>().diagonal().setConstant(linear);
  const Matrix3 shape_W = R_WT * shape_T * R_WT.transpose();
  result.bottomRightCorner<3, 3>() = (0.5 * angular) * (shape_W + shape_W.transpose());
  return result;
}

}  // namespace tegotae
