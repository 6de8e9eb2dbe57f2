// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/types.hpp>

namespace tegotae {

/// Position and orientation of a frame B in a frame A, named X_AB: p_A = R_AB p_B + p_AB.
struct Pose {
  Vector3 p = Vector3::Zero();            ///< origin of B in A, m
  Quaternion q = Quaternion::Identity();  ///< R_AB, unit

  Vector3 operator*(const Vector3& p_B) const noexcept { return q * p_B + p; }
  Pose operator*(const Pose& X_BC) const noexcept { return {q * X_BC.p + p, (q * X_BC.q).normalized()}; }
  Pose inverse() const noexcept {
    const Quaternion inverse_rotation = q.conjugate();
    return {-(inverse_rotation * p), inverse_rotation};
  }
  Matrix3 rotation() const noexcept { return q.toRotationMatrix(); }
  bool is_finite() const noexcept { return p.allFinite() && q.coeffs().allFinite(); }
};

/// Pose between `a` (at 0) and `b` (at 1): linear in position, slerp on the shorter arc in rotation.
Pose interpolate(const Pose& a, const Pose& b, double fraction) noexcept;

/// The pose after the small displacement (`dr`, `dtheta`) of the frame about the world point `centre_W`: the
/// rotation vector `dtheta` (rad) about `centre_W`, then the translation `dr` (m), both in world axes.
Pose displaced(const Pose& X_WB, const Vector3& centre_W, const Vector3& dr, const Vector3& dtheta) noexcept;

/// The displacement that takes `from` to `to`: linear part of the motion of the body point `centre_B` (m) and
/// rotation vector (rad), in world axes: [dr; dtheta]. Inverse of `displaced`.
Vector6 displacement(const Pose& from, const Pose& to, const Vector3& centre_B) noexcept;

}  // namespace tegotae
