// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tests/contact/support_plane.hpp>

namespace tegotae::test {

/// The least translation that parts two polytopes, m, by brute force: over the face normals of both and the cross
/// products of all their edge pairs, which hold all face normals of the Minkowski difference; negative when they are
/// apart (then only a lower bound of the distance).
inline double least_depth_over_faces(const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB) {
  const std::vector<Vector3> vertices_a = vertices_in_world(a, X_WA);
  const std::vector<Vector3> vertices_b = vertices_in_world(b, X_WB);
  double least = 1e300;
  const auto consider = [&](const Vector3& n) {
    double lowest_a = 1e300;
    double highest_b = -1e300;
    for (const Vector3& p : vertices_a) lowest_a = std::min(lowest_a, n.dot(p));
    for (const Vector3& p : vertices_b) highest_b = std::max(highest_b, n.dot(p));
    least = std::min(least, highest_b - lowest_a);
  };
  const Quaternion q_WA = (X_WA * a.X_BS).q;
  const Quaternion q_WB = (X_WB * b.X_BS).q;
  for (const Polytope::Face& face : a.polytope->faces) consider(q_WA * Vector3(-face.normal));
  for (const Polytope::Face& face : b.polytope->faces) consider(q_WB * face.normal);
  for (const Polytope::Edge& edge_a : a.polytope->edges) {
    const Vector3 along_a =
        vertices_a[static_cast<size_t>(edge_a.vertex[1])] - vertices_a[static_cast<size_t>(edge_a.vertex[0])];
    for (const Polytope::Edge& edge_b : b.polytope->edges) {
      const Vector3 along_b =
          vertices_b[static_cast<size_t>(edge_b.vertex[1])] - vertices_b[static_cast<size_t>(edge_b.vertex[0])];
      const Vector3 cross = along_a.cross(along_b);
      if (cross.norm() < 1e-9 * along_a.norm() * along_b.norm()) continue;
      consider(cross.normalized());
      consider(-cross.normalized());
    }
  }
  return least;
}

}  // namespace tegotae::test
