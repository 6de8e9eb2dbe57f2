// SPDX-License-Identifier: Apache-2.0
#include <tegotae/shape/shape.hpp>

#include <tegotae/shape/convex_hull.hpp>
#include <tegotae/shape/stand_in.hpp>

#include <cmath>
#include <stdexcept>
#include <string>

namespace tegotae {
namespace {

void require_positive(double length, std::string_view what) {
  if (!(std::isfinite(length) && length > 0.0)) {
    throw std::invalid_argument("the " + std::string(what) + " of a shape must be a positive number of metres, not " +
                                std::to_string(length));
  }
}

Shape make(ShapeKind kind, const Vector3& size, const Pose& X_BS) {
  if (!X_BS.is_finite()) throw std::invalid_argument("the pose of a shape on its body is not finite");
  Shape shape;
  shape.kind = kind;
  shape.size = size;
  shape.X_BS = {X_BS.p, X_BS.q.normalized()};
  return shape;
}

void set_stand_in(Shape& shape, StandIn stand_in) {
  shape.polytope = std::make_shared<const Polytope>(std::move(stand_in.polytope));
  shape.polytope_error = stand_in.error;
}

// Vertices numbered by the signs of their coordinates, as `support` numbers them: bit 0 x, bit 1 y, bit 2 z.
std::vector<Vector3> box_vertices(const Vector3& half) {
  std::vector<Vector3> vertices;
  for (int i = 0; i < 8; ++i) {
    vertices.emplace_back((i & 1) != 0 ? half.x() : -half.x(), (i & 2) != 0 ? half.y() : -half.y(),
                          (i & 4) != 0 ? half.z() : -half.z());
  }
  return vertices;
}

}  // namespace

std::string_view name_of(ShapeKind kind) noexcept {
  switch (kind) {
    case ShapeKind::kBox:
      return "box";
    case ShapeKind::kSphere:
      return "sphere";
    case ShapeKind::kCapsule:
      return "capsule";
    case ShapeKind::kCylinder:
      return "cylinder";
    case ShapeKind::kEllipsoid:
      return "ellipsoid";
    case ShapeKind::kHull:
      return "hull";
    case ShapeKind::kPlane:
      return "plane";
  }
  return "unknown";
}

Shape make_box(const Vector3& half_edges, const Pose& X_BS) {
  for (const double half : half_edges) require_positive(half, "half edge");
  Shape shape = make(ShapeKind::kBox, half_edges, X_BS);
  shape.polytope = std::make_shared<const Polytope>(convex_hull(box_vertices(half_edges)));
  return shape;
}

Shape make_sphere(double radius, const Pose& X_BS) {
  require_positive(radius, "radius");
  Shape shape = make(ShapeKind::kSphere, {radius, 0.0, 0.0}, X_BS);
  set_stand_in(shape, sphere_stand_in(radius));
  return shape;
}

Shape make_capsule(double radius, double half_length, const Pose& X_BS) {
  require_positive(radius, "radius");
  require_positive(half_length, "half length");
  Shape shape = make(ShapeKind::kCapsule, {radius, half_length, 0.0}, X_BS);
  set_stand_in(shape, capsule_stand_in(radius, half_length));
  return shape;
}

Shape make_cylinder(double radius, double half_height, const Pose& X_BS) {
  require_positive(radius, "radius");
  require_positive(half_height, "half height");
  Shape shape = make(ShapeKind::kCylinder, {radius, half_height, 0.0}, X_BS);
  set_stand_in(shape, cylinder_stand_in(radius, half_height));
  return shape;
}

Shape make_ellipsoid(const Vector3& semi_axes, const Pose& X_BS) {
  for (const double axis : semi_axes) require_positive(axis, "semi-axis");
  Shape shape = make(ShapeKind::kEllipsoid, semi_axes, X_BS);
  set_stand_in(shape, ellipsoid_stand_in(semi_axes));
  return shape;
}

Shape make_hull(std::span<const Vector3> points, const Pose& X_BS, double coplanarity) {
  Shape shape = make(ShapeKind::kHull, Vector3::Zero(), X_BS);
  shape.polytope = std::make_shared<const Polytope>(convex_hull(points, coplanarity));
  return shape;
}

Shape make_plane(const Pose& X_BS) { return make(ShapeKind::kPlane, Vector3::Zero(), X_BS); }

}  // namespace tegotae
