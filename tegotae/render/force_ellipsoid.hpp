// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/types.hpp>

namespace tegotae {

/// Force of a compliant element whose force is bounded by an ellipsoid, and its derivative.
struct EllipsoidForce {
  Vector3 force;      ///< lambda
  Matrix3 stiffness;  ///< d lambda / d s, symmetric positive semi-definite
  bool on_boundary;   ///< the bound is reached: slips
};

/// The maximiser of lambda^T s - 1/2 sum c_j lambda_j^2 over the ellipsoid sum (lambda_j / radius_j)^2 <= 1: s / c
/// projected in the metric of c. A zero radius gives no force along that component, an infinite one an unbounded
/// spring. c_j > 0 is needed where the radius is not 0. Solved by a bounded Newton iteration on the secular equation of
/// the boundary's multiplier. Units as the caller's: s in m or rad, c in m/N or rad/(N m), radius in N or N m.
EllipsoidForce ellipsoid_force(const Vector3& s, const Vector3& compliance, const Vector3& radius) noexcept;

}  // namespace tegotae
