// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/shape/shape.hpp>

#include <algorithm>
#include <cmath>
#include <vector>

namespace tegotae::test {

/// Vertices of a box or hull in the world, m.
inline std::vector<Vector3> vertices_in_world(const Shape& shape, const Pose& X_WB) {
  std::vector<Vector3> vertices;
  for (const Vector3& p : shape.polytope->vertices) vertices.push_back(X_WB * (shape.X_BS * p));
  return vertices;
}

/// By brute force over vertices: the gap that the planes normal to `n` (unit, from b to a) prove between two
/// polytopes, m; negative: how far they overlap along n.
inline double support_plane_gap(const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB, const Vector3& n) {
  double lowest_a = 1e300;
  double highest_b = -1e300;
  for (const Vector3& p : vertices_in_world(a, X_WA)) lowest_a = std::min(lowest_a, n.dot(p));
  for (const Vector3& p : vertices_in_world(b, X_WB)) highest_b = std::max(highest_b, n.dot(p));
  return lowest_a - highest_b;
}

/// How far the point is from the surface of a box or hull, judged by its face planes, m (0 on the surface; exact
/// inside and within a face's width outside of it).
inline double height_over_surface(const Shape& shape, const Pose& X_WB, const Vector3& p_W) {
  const Vector3 p_S = (X_WB * shape.X_BS).inverse() * p_W;
  double height = -1e300;
  for (const Polytope::Face& face : shape.polytope->faces) {
    height = std::max(height, face.normal.dot(p_S) - face.offset);
  }
  return std::abs(height);
}

}  // namespace tegotae::test
