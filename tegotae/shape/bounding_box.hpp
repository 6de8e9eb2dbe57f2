// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/shape/shape.hpp>

namespace tegotae {

/// Axis-aligned box. The default is empty.
struct BoundingBox {
  Vector3 lower = Vector3::Constant(1e300);   ///< m
  Vector3 upper = Vector3::Constant(-1e300);  ///< m

  bool overlaps(const BoundingBox& other) const noexcept {
    return (lower.array() <= other.upper.array()).all() && (other.lower.array() <= upper.array()).all();
  }
  BoundingBox enlarged(double margin) const noexcept { return {lower.array() - margin, upper.array() + margin}; }
  BoundingBox united(const BoundingBox& other) const noexcept {
    return {lower.cwiseMin(other.lower), upper.cwiseMax(other.upper)};
  }
};

/// The tightest world box of `shape` on a body at `X_WB`; a plane's is unbounded on all sides but the one that an
/// axis-aligned normal closes. Does not allocate.
BoundingBox bounding_box(const Shape& shape, const Pose& X_WB) noexcept;

}  // namespace tegotae
