// SPDX-License-Identifier: Apache-2.0
#include <tegotae/math/rotation.hpp>

#include <algorithm>
#include <cmath>

namespace tegotae {

Matrix3 skew(const Vector3& a) noexcept {
  Matrix3 m;
  m << 0.0, -a.z(), a.y(), a.z(), 0.0, -a.x(), -a.y(), a.x(), 0.0;
  return m;
}

Quaternion rotation_from_vector(const Vector3& theta) noexcept {
  const double angle_squared = theta.squaredNorm();
  const double angle = std::sqrt(angle_squared);
  // Below 1e-4 rad the two-term series of sin(a/2)/a is exact to double precision.
  const double scale = angle < 1e-4 ? 0.5 - angle_squared / 48.0 : std::sin(0.5 * angle) / angle;
  Quaternion q(std::cos(0.5 * angle), scale * theta.x(), scale * theta.y(), scale * theta.z());
  q.normalize();
  return q;
}

Vector3 rotation_vector(const Quaternion& q) noexcept {
  const double sign = q.w() < 0.0 ? -1.0 : 1.0;
  const Vector3 v = sign * q.vec();
  const double w = sign * q.w();
  const double sine = v.norm();
  if (sine < 1e-9) return 2.0 * v;
  return (2.0 * std::atan2(sine, w) / sine) * v;
}

Vector3 any_perpendicular(const Vector3& n) noexcept {
  Eigen::Index smallest = 0;
  n.cwiseAbs().minCoeff(&smallest);
  return n.cross(Vector3::Unit(smallest)).normalized();
}

}  // namespace tegotae
