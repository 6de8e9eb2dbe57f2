// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/contact/placed_shape.hpp>

namespace tegotae {

/// A bounded shape against a half-space, in closed form.
struct PlaneGap {
  double gap = 0.0;                     ///< least height of the shape over the plane, m; negative: sunk in
  Vector3 p_W_shape = Vector3::Zero();  ///< the lowest point of the shape, m
  Vector3 p_W_plane = Vector3::Zero();  ///< its foot on the plane, m
  Vector3 normal_W = Vector3::UnitZ();  ///< of the plane, unit
};

/// `hint` is where hill climbing on a hull starts (any valid vertex); it is brought up to date.
PlaneGap gap_to_plane(const PlacedShape& shape, const PlacedShape& plane, int& hint) noexcept;

}  // namespace tegotae
