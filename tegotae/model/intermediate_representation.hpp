// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/plain.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <type_traits>

namespace tegotae {

/// Capacities of one intermediate representation. A tick is linear in contact points up to these; beyond, the nearest
/// planes and the lowest points are kept and the rest is counted in `dropped_planes`, `dropped_points`.
inline constexpr int kMaxPlanes = 64;
inline constexpr int kMaxContactPoints = 1024;

/// Pairs of pieces and moving bodies that a model names for methods that find contacts themselves; beyond, the nearest
/// are kept and the rest is counted in `dropped_pairs`.
inline constexpr int kMaxNearPieces = 2048;
inline constexpr int kMaxNearBodies = 64;

/// A near object as the haptic rate sees it: the plane through the object's closest point, its normal the direction of
/// the closest pair (paper, section 4.2.3).
struct ContactPlane {
  PlainVector3 n_W;             ///< unit, out of the object
  PlainVector3 p_W;             ///< closest point on the object, m
  std::int32_t tool_piece = 0;  ///< pieces that the plane stands between
  std::int32_t body = 0;
  std::int32_t body_piece = 0;
  std::int32_t moving_index = -1;  ///< of the body, -1: static
  std::int32_t first_point = 0;    ///< its contact points: points[first_point .. first_point + point_count)
  std::int32_t point_count = 0;
  PlainVector3 p_WC;      ///< centre of mass of a moving body, m
  double distance = 0.0;  ///< of the pieces when the model was made, m; negative: penetration depth
};

/// A point of the tool that may touch the plane.
struct ContactPoint {
  PlainVector3 p_T;           ///< in the tool's frame, m
  std::uint64_t feature = 0;  ///< features of the two pieces that it comes from
  double radius = 0.0;        ///< m: a ball about p_T touches, not p_T itself (round pieces, which roll)
};

/// Two pieces that may touch before the next model has come.
struct NearPieces {
  std::int32_t tool_piece = 0;
  std::int32_t body = 0;
  std::int32_t body_piece = 0;
  std::int32_t near_body = -1;  ///< index in `bodies` of the moving body, -1: static
  double distance = 0.0;        ///< when the model was made, m; negative: penetration depth
  PlainVector3 n_B{};           ///< unit normal of the plane between them, out of the object, body's frame; 0: unknown
};

/// A moving body with a piece near the tool.
struct NearBody {
  std::int32_t moving_index = -1;
  PlainPose X_WB;
  PlainTwist V_WB;               ///< of the centre of mass, world axes
  PlainVector3 p_WC;             ///< centre of mass, m
  double mass = 0.0;             ///< kg; 0: unknown
  double gyration_length = 0.0;  ///< m
};

/// All that crosses from physics to haptics (paper, section 4.2; Adachi et al. 1995), extended to planes and points.
/// Trivially copyable, fixed size: the same between threads, processes and machines.
struct IntermediateRepresentation {
  std::uint64_t sequence = 0;  ///< 0: nothing yet; then 1, 2, ...
  double time = 0.0;           ///< of the world state that it was made from, s
  double period = 0.0;         ///< physics period that it is interpolated over, s
  std::int32_t near_object_count = 0;
  std::int32_t plane_count = 0;
  std::int32_t point_count = 0;
  std::int32_t dropped_planes = 0;
  std::int32_t dropped_points = 0;
  std::int32_t pair_count = 0;
  std::int32_t body_count = 0;
  std::int32_t dropped_pairs = 0;
  std::array<ContactPlane, kMaxPlanes> planes;
  std::array<ContactPoint, kMaxContactPoints> points;
  std::array<NearPieces, kMaxNearPieces> pairs;  ///< nearest first
  std::array<NearBody, kMaxNearBodies> bodies;   ///< those that `pairs` refers to, each once

  std::span<const NearPieces> used_pairs() const noexcept {
    return {pairs.data(), static_cast<std::size_t>(pair_count)};
  }
  std::span<const ContactPlane> used_planes() const noexcept {
    return {planes.data(), static_cast<std::size_t>(plane_count)};
  }
  std::span<const ContactPoint> points_of(const ContactPlane& plane) const noexcept {
    return {points.data() + plane.first_point, static_cast<std::size_t>(plane.point_count)};
  }
};
static_assert(std::is_trivially_copyable_v<IntermediateRepresentation>);

/// What a rendering method asks of the physics rate. The near pieces and bodies are always there.
struct ModelNeeds {
  bool planes_and_points = true;  ///< `planes` and `points` of the model
  bool about_proxy = false;       ///< near is what is near to where the world lets the tool be, not to where it is held
};

}  // namespace tegotae
