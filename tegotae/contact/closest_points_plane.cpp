// SPDX-License-Identifier: Apache-2.0
#include <tegotae/contact/closest_points_plane.hpp>

#include <tegotae/contact/gjk_core.hpp>

#include <algorithm>

namespace tegotae {

PlaneGap gap_to_plane(const PlacedShape& shape, const PlacedShape& plane, int& hint) noexcept {
  const gjk::Core core(*shape.shape);
  PlaneGap result;
  result.normal_W = plane.R_WS.col(2);
  const Vector3 down_S = -(shape.R_WS.transpose() * result.normal_W);
  const SupportPoint lowest = core.support(down_S, std::clamp(hint, 0, std::max(core.vertex_count() - 1, 0)));
  if (lowest.vertex >= 0) hint = lowest.vertex;
  result.p_W_shape = shape.to_world(lowest.p) - core.radius * result.normal_W;
  result.gap = result.normal_W.dot(result.p_W_shape - plane.p_WS);
  result.p_W_plane = result.p_W_shape - result.gap * result.normal_W;
  return result;
}

}  // namespace tegotae
