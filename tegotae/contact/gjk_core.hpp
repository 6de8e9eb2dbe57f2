// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/contact/placed_shape.hpp>

#include <cstdint>

namespace tegotae::gjk {

/// What is left of a bounded shape when its rounding is taken off: a shape is its core swept with a ball. A sphere is a
/// point and a radius, a capsule a segment and a radius. An ellipsoid is the inner body at its least radius of
/// curvature, a_min^2 / a_max: a ball that small rolls freely inside it (Blaschke), so is a summand of it. All others
/// are their own core with radius 0. Closest points of the cores give those of the shapes exactly, a point or a segment
/// costs GJK next to nothing, and cores stay apart by their radii where the shapes all but touch, which keeps the
/// normal of curved contacts exact.
enum class CoreKind : std::uint8_t { kPoint, kSegment, kBox, kHull, kCylinder, kEllipsoid };

struct Core {
  CoreKind kind = CoreKind::kPoint;
  const Shape* shape = nullptr;
  double radius = 0.0;  ///< m, of the ball that the core is swept with

  Core() = default;
  explicit Core(const Shape& shape) noexcept;

  /// The core has vertices, numbered from 0; else (cylinder, ellipsoid) it is smooth somewhere.
  bool has_vertices() const noexcept { return kind < CoreKind::kCylinder; }
  int vertex_count() const noexcept;
  /// Vertex `index` in the shape's frame, m.
  Vector3 vertex(int index) const noexcept;
  /// A core point furthest along `direction` (shape's frame, any length); hill climbing starts at vertex `hint`.
  SupportPoint support(const Vector3& direction, int hint) const noexcept;
  /// Greatest distance of a core point from the shape frame's origin, m (a bound, not always attained).
  double extent() const noexcept;
};

}  // namespace tegotae::gjk
