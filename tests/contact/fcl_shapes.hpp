// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/shape/shape.hpp>

#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/narrowphase/distance.h>

#include <memory>
#include <vector>

namespace tegotae::test {

/// The FCL twin of a box or hull.
inline std::shared_ptr<fcl::CollisionGeometryd> fcl_geometry(const Shape& shape) {
  std::shared_ptr<fcl::CollisionGeometryd> geometry;
  if (shape.kind == ShapeKind::kBox) {
    geometry = std::make_shared<fcl::Boxd>(2.0 * shape.size.x(), 2.0 * shape.size.y(), 2.0 * shape.size.z());
  } else {
    auto vertices = std::make_shared<std::vector<fcl::Vector3d>>();
    for (const Vector3& p : shape.polytope->vertices) vertices->push_back(p);
    auto faces = std::make_shared<std::vector<int>>();
    for (const Polytope::Face& face : shape.polytope->faces) {
      faces->push_back(face.count);
      for (const int v : shape.polytope->vertices_of(face)) faces->push_back(v);
    }
    geometry = std::make_shared<fcl::Convexd>(vertices, static_cast<int>(shape.polytope->faces.size()), faces);
  }
  geometry->computeLocalAABB();
  return geometry;
}

inline fcl::Transform3d fcl_pose(const Pose& X_WB) {
  fcl::Transform3d transform = fcl::Transform3d::Identity();
  transform.linear() = X_WB.rotation();
  transform.translation() = X_WB.p;
  return transform;
}

/// FCL's distance by libccd, with nearest points; negative or zero where it finds an overlap.
inline double fcl_distance(const fcl::CollisionGeometryd& a, const fcl::Transform3d& X_WA,
                           const fcl::CollisionGeometryd& b, const fcl::Transform3d& X_WB, double tolerance = 1e-12) {
  fcl::DistanceRequestd request(true, false, 0.0, 0.0, tolerance, fcl::GST_LIBCCD);
  fcl::DistanceResultd result;
  fcl::distance(&a, X_WA, &b, X_WB, request, result);
  return result.min_distance;
}

}  // namespace tegotae::test
