// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/contact/placed_shape.hpp>

#include <algorithm>
#include <optional>

namespace tegotae::test {

struct LineInterval {
  double from, to;  ///< m along the line's direction
};

/// Where the line p_W + t d_W runs inside a polytope, by all its faces; shares nothing with the overlay.
inline std::optional<LineInterval> cast_line(const PlacedShape& placed, const Vector3& p_W, const Vector3& d_W) {
  const Vector3 p = placed.to_shape(p_W), d = placed.R_WS.transpose() * d_W;
  LineInterval inside{-1e300, 1e300};
  for (const auto& face : placed.shape->polytope->faces) {
    const double rise = face.normal.dot(d), room = face.offset - face.normal.dot(p);
    if (std::abs(rise) < 1e-14) {
      if (room < 0.0) return std::nullopt;
    } else if (rise > 0.0) {
      inside.to = std::min(inside.to, room / rise);
    } else {
      inside.from = std::max(inside.from, room / rise);
    }
  }
  if (inside.from > inside.to) return std::nullopt;
  return inside;
}

/// The gap between the facing surfaces of two polytopes along n over the place p_W.
inline std::optional<double> gap_over(const PlacedShape& tool, const PlacedShape& object, const Vector3& p_W,
                                      const Vector3& n_W) {
  const auto above = cast_line(tool, p_W, n_W), below = cast_line(object, p_W, n_W);
  if (!above || !below) return std::nullopt;
  return above->from - below->to;
}

}  // namespace tegotae::test
