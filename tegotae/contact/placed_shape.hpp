// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/shape/shape.hpp>
#include <tegotae/shape/support.hpp>

namespace tegotae {

/// A shape where it stands in the world, its rotation worked out once for the many support queries of a tick.
/// Refers to the shape: does not own it.
struct PlacedShape {
  const Shape* shape = nullptr;
  Matrix3 R_WS = Matrix3::Identity();
  Vector3 p_WS = Vector3::Zero();  ///< m

  PlacedShape() = default;
  PlacedShape(const Shape& the_shape, const Pose& X_WB) noexcept : shape(&the_shape) {
    const Pose X_WS = X_WB * the_shape.X_BS;
    R_WS = X_WS.rotation();
    p_WS = X_WS.p;
  }

  Vector3 to_world(const Vector3& p_S) const noexcept { return R_WS * p_S + p_WS; }
  Vector3 to_shape(const Vector3& p_W) const noexcept { return R_WS.transpose() * (p_W - p_WS); }
};

inline bool is_plane(const PlacedShape& placed) noexcept { return placed.shape->kind == ShapeKind::kPlane; }

}  // namespace tegotae
