// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/convex_core.hpp>

namespace tegotae {

/// Unit normal of a plane between two cores with a gap along it that no small turn of the plane widens: the widest of
/// all where the cores are apart, else a locally least overlap. `below` may be a half-space, whose normal it then is.
/// Exact linear programs, no distance query. Allocates.
Vector3 widest_gap_normal(const ConvexCore& above, const ConvexCore& below);

/// Two unit vectors perpendicular to `n` and to each other.
Eigen::Matrix<double, 3, 2> tangents_of(const Vector3& n) noexcept;

}  // namespace tegotae
