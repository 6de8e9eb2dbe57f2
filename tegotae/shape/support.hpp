// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/shape/shape.hpp>

namespace tegotae {

/// Vertex of `polytope` furthest along `direction` (any length, polytope's frame), by hill climbing over the edges
/// from vertex `start`. A linear function on a convex polytope has no local maximum that is not global, so the
/// answer does not depend on the start, which only saves time. Does not allocate.
int support_vertex(const Polytope& polytope, const Vector3& direction, int start) noexcept;

/// A point of the shape furthest along `direction` (nonzero, any length), both in the shape's frame, m.
struct SupportPoint {
  Vector3 p = Vector3::Zero();
  int vertex = -1;  ///< of the polytope for boxes and hulls, else -1
};

/// Support point of a bounded shape. `hint` is a vertex to start from (hulls); any valid index is right. A plane has
/// none: its answer is the origin. Does not allocate.
SupportPoint support(const Shape& shape, const Vector3& direction, int hint = 0) noexcept;

}  // namespace tegotae
