// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/types.hpp>

#include <array>

namespace tegotae::gjk {

/// A point of the Minkowski difference tool - object and the two points that it is the difference of, m, all in the
/// object's frame.
struct MinkowskiPoint {
  Vector3 w = Vector3::Zero();       ///< p_tool - p_object
  Vector3 tool = Vector3::Zero();    ///< p_tool
  Vector3 object = Vector3::Zero();  ///< p_object
  int tool_vertex = -1;              ///< of the tool's core, -1 where it is smooth
  int object_vertex = -1;
};

/// One to four points of the Minkowski difference.
struct Simplex {
  std::array<MinkowskiPoint, 4> point;
  std::array<double, 4> weight{};  ///< barycentric, of the simplex point nearest the origin
  int count = 0;

  void add(const MinkowskiPoint& p) noexcept { point[static_cast<size_t>(count++)] = p; }
  bool contains(const MinkowskiPoint& p) const noexcept;
  Vector3 tool_point() const noexcept;    ///< weighted sum of the tool's points
  Vector3 object_point() const noexcept;  ///< weighted sum of the object's points
};

/// The simplex point nearest the origin.
struct NearestPoint {
  Vector3 v = Vector3::Zero();  ///< m
  Vector3 n = Vector3::Zero();  ///< unit, along v; of a triangle its normal, which stays exact when v is tiny
  double distance = 0.0;        ///< |v|, m
  bool inside = false;          ///< the origin lies strictly inside a tetrahedron (then v and n are zero)
};

/// Finds the point of `simplex` nearest the origin, drops the vertices that do not carry it and sets the weights of
/// the others. Decided by signed areas and volumes, and where those have no sign (slivers, flat tetrahedra) by
/// comparing the distances of all lower features, so no degenerate simplex fails.
NearestPoint reduce_to_nearest(Simplex& simplex) noexcept;

}  // namespace tegotae::gjk
