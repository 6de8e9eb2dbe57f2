// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/shape/polytope.hpp>

#include <span>

namespace tegotae {

/// Convex hull of `points` (m), by Qhull. Points inside the hull or on a face or an edge are dropped, points that
/// coincide are merged, coplanar facets are merged into one face.
/// Throws std::invalid_argument if a coordinate is not finite, or if the points do not span a volume (fewer than
/// four, coplanar). Allocates.
Polytope convex_hull(std::span<const Vector3> points);

}  // namespace tegotae
