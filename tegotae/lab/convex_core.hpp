// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/shape/bounding_box.hpp>
#include <tegotae/shape/shape.hpp>

#include <vector>

namespace tegotae {

/// A convex shape as all points within `radius` of the hull of a few points: a sphere is its centre, a capsule its
/// axis, a box or hull its vertices, a curved shape else those of its inscribed polytope. Where `normal` is set the
/// core is the half-space below the first vertex.
struct ConvexCore {
  std::vector<Vector3> vertices;      ///< m, in the body's frame, or in the world
  double radius = 0.0;                ///< m
  std::vector<Vector3> face_normals;  ///< unit, outward
  bool is_half_space = false;         ///< then face_normals holds its normal alone
  BoundingBox box;                    ///< of the vertices, enlarged by the radius
};

/// The core of `shape` in its body's frame.
ConvexCore core_of(const Shape& shape);

/// `core`, on a body at `X_WB`, in the world. `placed` keeps its storage.
void place(const ConvexCore& core, const Pose& X_WB, ConvexCore& placed);

/// The side that the plane with unit normal `n` gives to both cores: how far, along n, all of `above` lies beyond all
/// of `below`; negative where they overlap in that direction, m.
double gap_along(const ConvexCore& above, const ConvexCore& below, const Vector3& n) noexcept;

/// The greatest n . v over the vertices of `core`, m.
double greatest_along(const ConvexCore& core, const Vector3& n) noexcept;

}  // namespace tegotae
