// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/render/bristle.hpp>
#include <tegotae/render/facing.hpp>

#include <cstdint>

namespace tegotae {

/// A piece of the tool and a piece of a body so near that one linearisation may bring them into contact, and all that
/// is remembered of them from tick to tick.
struct NearContact {
  static constexpr double kNoRows = 1e300;  ///< m, predicted of a contact that has none

  std::int32_t tool_piece = 0;
  std::int32_t body = 0;
  std::int32_t body_piece = 0;
  std::int32_t moving_index = -1;
  std::int32_t pair = -1;          ///< its place among all near pairs
  Pose X_WB;                       ///< of the body, now
  Vector3 p_WC = Vector3::Zero();  ///< its centre of mass, m

  bool measured = false;  ///< `now` holds at the tool's present pose
  bool served = false;    ///< in this tick
  bool skipped = false;   ///< in this tick, for want of budget: its last plane stood in
  double room = -1e300;   ///< m: the distance is at least this; -1e300: unknown
  Facing now;
  Facing trial;                       ///< at the pose under examination
  bool tried = false;                 ///< `trial` was measured
  double deepened = 0.0;              ///< m that the object's own motion took from the gap since the last tick's end
  double turned = 0.0;                ///< rad that the normal turned in the last accepted step
  Vector3 n_row_W = Vector3::Zero();  ///< of its rows in this linearisation
  bool pushes = false;                ///< it carried in the last solve
  double predicted = kNoRows;         ///< least gap of its points after the step, by the linear model, m
  ClosestPointsCache cache;

  FrictionLaw friction;
  Bristle bristle;
};

}  // namespace tegotae
