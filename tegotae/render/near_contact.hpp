// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/contact/closest_points.hpp>
#include <tegotae/render/bristle.hpp>

#include <cstdint>

namespace tegotae {

/// How two pieces face each other at one pose of the tool.
struct Facing {
  bool separated = false;          ///< by a certified distance; else `gap` is minus the penetration depth
  double gap = 0.0;                ///< m
  Vector3 p_WA = Vector3::Zero();  ///< closest or deepest point of the tool, m
  Vector3 p_WB = Vector3::Zero();  ///< of the object, m
  Vector3 n_W = Vector3::Zero();   ///< unit, out of the object; zero before the first measurement
};

/// A piece of the tool and a piece of a body that may touch, and all that is remembered of them from tick to tick.
struct NearContact {
  std::int32_t tool_piece = 0;
  std::int32_t body = 0;
  std::int32_t body_piece = 0;
  std::int32_t moving_index = -1;
  Pose X_WB;                       ///< of the body, now
  Vector3 p_WC = Vector3::Zero();  ///< its centre of mass, m

  bool measured = false;  ///< `now` holds at the tool's present pose
  double room = -1e300;   ///< m: the distance is at least this; -1e300: unknown
  Facing now;
  Facing trial;              ///< at the pose under examination
  bool tried = false;        ///< `trial` was measured
  double deepened = 0.0;     ///< m that the object's own motion took from the gap since the last tick's end
  double turned = 0.0;       ///< rad that the normal turned in the last accepted step
  double predicted = 1e300;  ///< least gap of its points after the step, by the linear model, m
  ClosestPointsCache cache;

  FrictionLaw friction;
  Bristle bristle;

  bool is_same_pair(const NearContact& other) const noexcept {
    return tool_piece == other.tool_piece && body == other.body && body_piece == other.body_piece;
  }
};

}  // namespace tegotae
