// SPDX-License-Identifier: Apache-2.0
#include <tegotae/math/pose.hpp>

#include <tegotae/math/rotation.hpp>

namespace tegotae {

Pose interpolate(const Pose& a, const Pose& b, double fraction) noexcept {
  return {a.p + fraction * (b.p - a.p), a.q.slerp(fraction, b.q).normalized()};
}

Pose displaced(const Pose& X_WB, const Vector3& centre_W, const Vector3& dr, const Vector3& dtheta) noexcept {
  const Quaternion turn = rotation_from_vector(dtheta);
  return {centre_W + dr + turn * (X_WB.p - centre_W), (turn * X_WB.q).normalized()};
}

Vector6 displacement(const Pose& from, const Pose& to, const Vector3& centre_B) noexcept {
  Vector6 d;
  d.head<3>() = (to * centre_B) - (from * centre_B);
  d.tail<3>() = rotation_vector(to.q * from.q.conjugate());
  return d;
}

}  // namespace tegotae
