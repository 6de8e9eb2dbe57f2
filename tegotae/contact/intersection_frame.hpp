// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/contact/placed_shape.hpp>

#include <algorithm>

namespace tegotae {

/// The frames in which the intersection of a tool and a dilated object is computed: T, the tool shape's, and O, the
/// object shape's. Only differences of positions enter, so the precision does not depend on where in the world the
/// pair stands.
struct IntersectionFrame {
  Matrix3 R_WO, R_OT;
  Vector3 p_WO, p_OT;  ///< m
  Vector3 dilation_O;  ///< m

  IntersectionFrame(const PlacedShape& tool, const PlacedShape& object, const Vector3& dilation_W) noexcept
      : R_WO(object.R_WS),
        R_OT(object.R_WS.transpose() * tool.R_WS),
        p_WO(object.p_WS),
        p_OT(object.R_WS.transpose() * (tool.p_WS - object.p_WS)),
        dilation_O(object.R_WS.transpose() * dilation_W) {}

  bool is_finite() const noexcept {
    return R_WO.allFinite() && R_OT.allFinite() && p_WO.allFinite() && p_OT.allFinite() && dilation_O.allFinite();
  }
  /// How far dilation moves the object's face plane of outward normal `n_O`, m.
  double shift(const Vector3& n_O) const noexcept { return std::max(0.0, n_O.dot(dilation_O)); }

  Vector3 object_from_tool(const Vector3& p_T) const noexcept { return R_OT * p_T + p_OT; }
  Vector3 tool_from_object(const Vector3& p_O) const noexcept { return R_OT.transpose() * (p_O - p_OT); }
  Vector3 world(const Vector3& p_O) const noexcept { return R_WO * p_O + p_WO; }
  Vector3 object_from_world(const Vector3& p_W) const noexcept { return R_WO.transpose() * (p_W - p_WO); }
};

}  // namespace tegotae
