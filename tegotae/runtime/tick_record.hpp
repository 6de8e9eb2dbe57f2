// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/plain.hpp>

#include <cstdint>
#include <type_traits>

namespace tegotae {

/// What one haptic tick saw and did. Trivially copyable, so that it leaves the haptic thread through a ring.
struct TickRecord {
  double time = 0.0;       ///< s
  PlainPose X_WT;          ///< the tool's frame, where the hand holds it
  PlainWrench wrench;      ///< the method's, on the interface, about the tool's centre of mass, world axes
  PlainWrench displayed;   ///< after the safety stage, same point and axes
  PlainPose X_WP;          ///< where the world lets the tool be
  double deepest = 0.0;    ///< greatest penetration of a contact point at the interface's pose, m
  double model_age = 0.0;  ///< s since the world state that the model was made from
  std::uint64_t model_sequence = 0;
  std::int32_t near_objects = 0;
  std::int32_t planes = 0;
  std::int32_t contact_points = 0;
  std::int32_t constraints = 0;
  std::int32_t active = 0;
  std::int32_t solver_iterations = 0;
  std::int32_t dropped = 0;  ///< planes, points and pairs beyond a capacity or the tick's budget
  std::uint8_t status = 0;   ///< RenderStatus
  std::uint32_t safety_events = 0;

  // Of a simulated interface in closed loop (lab/session.hpp); else as they stand here.
  PlainWrench interface_wrench;  ///< what its motors really display, same point and axes
  PlainPose X_WH;                ///< where the hand means the tool's frame to be
  bool falls_short = false;      ///< the motors cannot give what was commanded

  double tick_us = 0.0;  ///< wall-clock time of the tick, microseconds; the one value that does not repeat
};
static_assert(std::is_trivially_copyable_v<TickRecord>);

}  // namespace tegotae
