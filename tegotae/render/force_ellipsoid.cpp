// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/force_ellipsoid.hpp>

#include <algorithm>
#include <cmath>

namespace tegotae {
namespace {

// On the boundary lambda_j = s_j r_j^2 / (c_j r_j^2 + nu), nu >= 0 such that the sum of z_j^2 is 1 with
// z_j = lambda_j / r_j = p_j / (q_j + nu), p = s r, q = c r^2. 1/|z| is nearly linear in nu, so Newton's method
// on 1/|z| = 1 converges fast and, from a start at or below the root, without overshooting.
double boundary_multiplier(const Vector3& p, const Vector3& q) noexcept {
  double nu = std::max(0.0, (p.cwiseAbs() - q).maxCoeff());
  constexpr int kLimit = 60;  // a handful suffices; the bound guards against rounding
  for (int i = 0; i < kLimit; ++i) {
    const Vector3 z = p.cwiseQuotient(q + Vector3::Constant(nu));
    const double square = z.squaredNorm();
    const double slope = z.cwiseAbs2().cwiseQuotient(q + Vector3::Constant(nu)).sum();
    const double step = square * (std::sqrt(square) - 1.0) / slope;
    nu += step;
    if (!(step > 1e-15 * nu)) break;
  }
  return nu;
}

}  // namespace

EllipsoidForce ellipsoid_force(const Vector3& s, const Vector3& compliance, const Vector3& radius) noexcept {
  EllipsoidForce result{Vector3::Zero(), Matrix3::Zero(), false};
  Vector3 p = Vector3::Zero(), q = Vector3::Ones();
  double inside = 0.0;
  for (int j = 0; j < 3; ++j) {
    if (!(radius[j] > 0.0)) continue;
    result.force[j] = s[j] / compliance[j];
    result.stiffness(j, j) = 1.0 / compliance[j];
    if (!std::isfinite(radius[j])) continue;
    p[j] = s[j] * radius[j];
    q[j] = compliance[j] * radius[j] * radius[j];
    inside += (p[j] / q[j]) * (p[j] / q[j]);
  }
  if (!(inside > 1.0)) return result;

  result.on_boundary = true;
  const double nu = boundary_multiplier(p, q);
  Vector3 flexibility = Vector3::Zero(), normal = Vector3::Zero();
  for (int j = 0; j < 3; ++j) {
    if (!(radius[j] > 0.0) || !std::isfinite(radius[j])) continue;
    const double square = radius[j] * radius[j];
    flexibility[j] = square / (q[j] + nu);
    result.force[j] = s[j] * flexibility[j];
    normal[j] = result.force[j] / square;
    result.stiffness(j, j) = flexibility[j];
  }
  const Vector3 along = flexibility.cwiseProduct(normal);
  result.stiffness -= along * along.transpose() / normal.dot(along);
  return result;
}

}  // namespace tegotae
