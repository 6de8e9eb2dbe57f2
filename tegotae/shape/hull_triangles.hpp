// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/types.hpp>

#include <array>
#include <span>
#include <vector>

namespace tegotae {

/// A facet of a triangulated hull: indices into the given points, counter-clockwise seen from outside.
struct HullTriangle {
  std::array<int, 3> vertex{};
  Vector3 normal = Vector3::Zero();  ///< unit, outward
};

/// Triangulated convex hull of `points` by Qhull. Throws std::invalid_argument as `convex_hull` does. Allocates.
std::vector<HullTriangle> hull_triangles(std::span<const Vector3> points);

}  // namespace tegotae
