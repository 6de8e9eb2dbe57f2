// SPDX-License-Identifier: Apache-2.0
#include <tegotae/contact/gjk_core.hpp>

#include <algorithm>
#include <cmath>

namespace tegotae::gjk {
namespace {

CoreKind kind_of(const Shape& shape) noexcept {
  switch (shape.kind) {
    case ShapeKind::kBox:
      return CoreKind::kBox;
    case ShapeKind::kCapsule:
      return CoreKind::kSegment;
    case ShapeKind::kCylinder:
      return CoreKind::kCylinder;
    case ShapeKind::kEllipsoid:
      return CoreKind::kEllipsoid;
    case ShapeKind::kHull:
      return CoreKind::kHull;
    case ShapeKind::kSphere:
    case ShapeKind::kPlane:
      break;
  }
  return CoreKind::kPoint;
}

// Vertices of a box are numbered by the signs of their coordinates: bit k set means +size[k].
Vector3 box_vertex(const Vector3& size, int index) noexcept {
  return {(index & 1) != 0 ? size.x() : -size.x(), (index & 2) != 0 ? size.y() : -size.y(),
          (index & 4) != 0 ? size.z() : -size.z()};
}

int box_support(const Vector3& direction) noexcept {
  return static_cast<int>(direction.x() > 0.0) | static_cast<int>(direction.y() > 0.0) << 1 |
         static_cast<int>(direction.z() > 0.0) << 2;
}

Vector3 segment_vertex(const Vector3& size, int index) noexcept {
  return {0.0, 0.0, index == 0 ? -size.y() : size.y()};
}

}  // namespace

Core::Core(const Shape& the_shape) noexcept : kind(kind_of(the_shape)), shape(&the_shape) {
  if (the_shape.kind == ShapeKind::kSphere || the_shape.kind == ShapeKind::kCapsule) radius = the_shape.size.x();
  if (the_shape.kind == ShapeKind::kEllipsoid) {
    radius = the_shape.size.minCoeff() * the_shape.size.minCoeff() / the_shape.size.maxCoeff();
  }
}

int Core::vertex_count() const noexcept {
  switch (kind) {
    case CoreKind::kPoint:
      return 1;
    case CoreKind::kSegment:
      return 2;
    case CoreKind::kBox:
      return 8;
    case CoreKind::kHull:
      return static_cast<int>(shape->polytope->vertices.size());
    case CoreKind::kCylinder:
    case CoreKind::kEllipsoid:
      break;
  }
  return 0;
}

Vector3 Core::vertex(int index) const noexcept {
  switch (kind) {
    case CoreKind::kBox:
      return box_vertex(shape->size, index);
    case CoreKind::kHull:
      return shape->polytope->vertices[static_cast<size_t>(index)];
    case CoreKind::kSegment:
      return segment_vertex(shape->size, index);
    case CoreKind::kPoint:
    case CoreKind::kCylinder:
    case CoreKind::kEllipsoid:
      break;
  }
  return Vector3::Zero();
}

SupportPoint Core::support(const Vector3& direction, int hint) const noexcept {
  switch (kind) {
    case CoreKind::kHull: {
      const int vertex = support_vertex(*shape->polytope, direction, hint);
      return {shape->polytope->vertices[static_cast<size_t>(vertex)], vertex};
    }
    case CoreKind::kBox: {
      const int vertex = box_support(direction);
      return {box_vertex(shape->size, vertex), vertex};
    }
    case CoreKind::kSegment: {
      const int vertex = direction.z() > 0.0 ? 1 : 0;
      return {segment_vertex(shape->size, vertex), vertex};
    }
    case CoreKind::kPoint:
      return {Vector3::Zero(), 0};
    case CoreKind::kCylinder:
    case CoreKind::kEllipsoid:
      break;
  }
  SupportPoint point = tegotae::support(*shape, direction);
  if (radius > 0.0) point.p -= radius * direction.normalized();
  return point;
}

double Core::extent() const noexcept {
  switch (kind) {
    case CoreKind::kHull:
      return shape->polytope->radius;
    case CoreKind::kBox:
      return shape->size.sum();
    case CoreKind::kSegment:
      return shape->size.y();
    case CoreKind::kCylinder:
      return shape->size.x() + shape->size.y();
    case CoreKind::kEllipsoid:
      return shape->size.maxCoeff();
    case CoreKind::kPoint:
      break;
  }
  return 0.0;
}

}  // namespace tegotae::gjk
