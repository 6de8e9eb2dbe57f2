// SPDX-License-Identifier: Apache-2.0
#include <tegotae/shape/support.hpp>

#include <cmath>

namespace tegotae {
namespace {

// The vertices of make_box are numbered by the signs of their coordinates: bit 0 x, bit 1 y, bit 2 z set where
// positive.
SupportPoint box_support(const Vector3& half, const Vector3& direction) noexcept {
  const int vertex = (direction.x() > 0.0 ? 1 : 0) | (direction.y() > 0.0 ? 2 : 0) | (direction.z() > 0.0 ? 4 : 0);
  return {{(vertex & 1) != 0 ? half.x() : -half.x(), (vertex & 2) != 0 ? half.y() : -half.y(),
           (vertex & 4) != 0 ? half.z() : -half.z()},
          vertex};
}

Vector3 capsule_support(double radius, double half_length, const Vector3& direction) noexcept {
  const Vector3 end(0.0, 0.0, direction.z() > 0.0 ? half_length : -half_length);
  return end + radius * direction.normalized();
}

Vector3 cylinder_support(double radius, double half_height, const Vector3& direction) noexcept {
  const double across = std::hypot(direction.x(), direction.y());
  const double scale = across > 0.0 ? radius / across : 0.0;
  return {scale * direction.x(), scale * direction.y(), direction.z() > 0.0 ? half_height : -half_height};
}

Vector3 ellipsoid_support(const Vector3& semi_axes, const Vector3& direction) noexcept {
  const Vector3 scaled = semi_axes.cwiseProduct(direction);
  return semi_axes.cwiseProduct(scaled) / scaled.norm();
}

}  // namespace

int support_vertex(const Polytope& polytope, const Vector3& direction, int start) noexcept {
  int best = start;
  double best_value = direction.dot(polytope.vertices[static_cast<size_t>(best)]);
  for (bool improved = true; improved;) {
    improved = false;
    for (const int neighbor : polytope.neighbors_of(best)) {
      const double value = direction.dot(polytope.vertices[static_cast<size_t>(neighbor)]);
      if (value > best_value) {
        best_value = value;
        best = neighbor;
        improved = true;
        break;
      }
    }
  }
  return best;
}

SupportPoint support(const Shape& shape, const Vector3& direction, int hint) noexcept {
  switch (shape.kind) {
    case ShapeKind::kBox:
      return box_support(shape.size, direction);
    case ShapeKind::kSphere:
      return {shape.size.x() * direction.normalized(), -1};
    case ShapeKind::kCapsule:
      return {capsule_support(shape.size.x(), shape.size.y(), direction), -1};
    case ShapeKind::kCylinder:
      return {cylinder_support(shape.size.x(), shape.size.y(), direction), -1};
    case ShapeKind::kEllipsoid:
      return {ellipsoid_support(shape.size, direction), -1};
    case ShapeKind::kHull: {
      const int vertex = support_vertex(*shape.polytope, direction, hint);
      return {shape.polytope->vertices[static_cast<size_t>(vertex)], vertex};
    }
    case ShapeKind::kPlane:
      break;
  }
  return {};
}

}  // namespace tegotae
