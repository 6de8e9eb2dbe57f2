// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/types.hpp>

namespace tegotae {

/// Cross-product matrix: skew(a) * b == a.cross(b).
Matrix3 skew(const Vector3& a) noexcept;

/// Rotation by the rotation vector `theta` (rad, axis times angle). Does not allocate.
Quaternion rotation_from_vector(const Vector3& theta) noexcept;

/// Rotation vector (rad, angle in [0, pi]) of `q`, a unit quaternion of either sign.
Vector3 rotation_vector(const Quaternion& q) noexcept;

/// A unit vector perpendicular to `n` (unit), a continuous function of `n` almost everywhere.
Vector3 any_perpendicular(const Vector3& n) noexcept;

}  // namespace tegotae
