// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/shape/polytope.hpp>

#include <span>

namespace tegotae {

/// Neighbouring facets that deviate from one plane by less than this part of the hull's size (the diagonal of its
/// box) are one face. For coordinates in double precision.
inline constexpr double kExactCoplanarity = 1e-12;

/// The same for coordinates that passed through single precision, as those of mesh files and MuJoCo do, which puts
/// them off by up to 6e-8 of the size. On a body of 0.1 m the faces then deviate by 2e-8 m: at 9000 N/m a two-hundredth
/// of what a hand feels.
inline constexpr double kSinglePrecisionCoplanarity = 2e-7;

/// Convex hull of `points` (m), by Qhull. Points inside the hull or on a face or an edge are dropped, points that
/// coincide are merged, facets coplanar within `coplanarity` (part of the size) are merged into one face.
/// Throws std::invalid_argument if a coordinate is not finite, or if the points do not span a volume (fewer than
/// four, coplanar). Allocates.
Polytope convex_hull(std::span<const Vector3> points, double coplanarity = kExactCoplanarity);

}  // namespace tegotae
