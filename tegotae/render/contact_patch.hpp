// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>

#include <span>

namespace tegotae {

using Vector2 = Eigen::Matrix<double, 2, 1, Eigen::DontAlign>;

/// The greatest number of corners that `mean_distance` looks at; further points are left out.
inline constexpr int kMaxPatchCorners = 128;

/// Mean distance (m) from `centre` of the places of a contact patch, the convex hull of `points` (m, in the contact's
/// plane): the integral of |r| over its area divided by its area, in closed form. A patch that is a line has the
/// integral over its length, a single point its own distance. Under uniform pressure the greatest torque of Coulomb
/// friction about `centre` is mu N times this length. Does not allocate.
double mean_distance(std::span<const Vector2> points, const Vector2& centre) noexcept;

}  // namespace tegotae
