// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/convex_core.hpp>

#include <algorithm>
#include <limits>

namespace tegotae {
namespace {

std::vector<Vector3> vertices_of(const Shape& shape) {
  switch (shape.kind) {
    case ShapeKind::kSphere:
    case ShapeKind::kPlane:
      return {Vector3::Zero()};
    case ShapeKind::kCapsule:
      return {{0.0, 0.0, -shape.size.y()}, {0.0, 0.0, shape.size.y()}};
    default:
      return shape.polytope->vertices;
  }
}

std::vector<Vector3> face_normals_of(const Shape& shape) {
  if (shape.kind == ShapeKind::kPlane) return {Vector3::UnitZ()};
  if (shape.kind == ShapeKind::kSphere || shape.kind == ShapeKind::kCapsule) return {};
  std::vector<Vector3> normals;
  for (const Polytope::Face& face : shape.polytope->faces) normals.push_back(face.normal);
  return normals;
}

void update_box(ConvexCore& core) {
  core.box = {};
  if (core.is_half_space) {
    core.box = {Vector3::Constant(-1e300), Vector3::Constant(1e300)};
    return;
  }
  for (const Vector3& v : core.vertices) core.box = {core.box.lower.cwiseMin(v), core.box.upper.cwiseMax(v)};
  core.box = core.box.enlarged(core.radius);
}

}  // namespace

ConvexCore core_of(const Shape& shape) {
  ConvexCore local, core;
  local.vertices = vertices_of(shape);
  local.face_normals = face_normals_of(shape);
  local.is_half_space = shape.kind == ShapeKind::kPlane;
  local.radius = shape.kind == ShapeKind::kSphere || shape.kind == ShapeKind::kCapsule ? shape.size.x() : 0.0;
  place(local, shape.X_BS, core);
  return core;
}

void place(const ConvexCore& core, const Pose& X_WB, ConvexCore& placed) {
  const Matrix3 R_WB = X_WB.rotation();
  placed.radius = core.radius;
  placed.is_half_space = core.is_half_space;
  placed.vertices.resize(core.vertices.size());
  placed.face_normals.resize(core.face_normals.size());
  for (size_t i = 0; i < core.vertices.size(); ++i) placed.vertices[i] = R_WB * core.vertices[i] + X_WB.p;
  for (size_t i = 0; i < core.face_normals.size(); ++i) placed.face_normals[i] = R_WB * core.face_normals[i];
  update_box(placed);
}

double greatest_along(const ConvexCore& core, const Vector3& n) noexcept {
  double greatest = -std::numeric_limits<double>::infinity();
  for (const Vector3& v : core.vertices) greatest = std::max(greatest, n.dot(v));
  return greatest;
}

double gap_along(const ConvexCore& above, const ConvexCore& below, const Vector3& n) noexcept {
  return -greatest_along(above, -n) - greatest_along(below, n) - above.radius - below.radius;
}

}  // namespace tegotae
