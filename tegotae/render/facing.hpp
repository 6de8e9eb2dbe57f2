// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/contact/closest_points.hpp>

namespace tegotae {

/// How two pieces face each other at one pose of the tool.
struct Facing {
  bool separated = false;          ///< by a certified distance; else `gap` is minus the penetration depth
  bool by_plane = false;           ///< not measured, see `facing_along`: `gap` is a lower bound of the distance
  double gap = 0.0;                ///< m
  Vector3 p_WA = Vector3::Zero();  ///< closest or deepest point of the tool, m
  Vector3 p_WB = Vector3::Zero();  ///< of the object, m
  Vector3 n_W = Vector3::Zero();   ///< unit, out of the object; zero before the first measurement
};

/// Measures how the pieces face each other. A pair that is not separated has the plane of the least way out, followed
/// from the last normal `n_last_W` (zero: none): a tool in a thin plate is put back to the side that it came from.
/// Does not allocate; bounded.
Facing measured_facing(const PlacedShape& tool, const PlacedShape& object, const Vector3& n_last_W,
                       ClosestPointsCache& cache) noexcept;

/// The facing without a measurement: the object's supporting plane normal to `n_W` (unit, or zero: a direction between
/// the pieces' frames is taken) and the tool's lowest point above it. As the object lies below its plane, `gap` is a
/// lower bound of the distance whatever the direction; a negative one says nothing. Costs two support queries. Does
/// not allocate.
Facing facing_along(const PlacedShape& tool, const PlacedShape& object, const Vector3& n_W,
                    ClosestPointsCache& cache) noexcept;

}  // namespace tegotae
