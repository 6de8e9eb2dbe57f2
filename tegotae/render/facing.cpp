// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/facing.hpp>

#include <tegotae/contact/penetration.hpp>

namespace tegotae {
namespace {

bool is_direction(const Vector3& n_W) noexcept { return n_W.squaredNorm() > 0.5; }

// Out of the object's frame towards the tool's; a plane is supported along its own normal alone.
Vector3 direction_between(const PlacedShape& tool, const PlacedShape& object) noexcept {
  if (!object.shape->is_bounded()) return object.R_WS.col(2);
  const Vector3 way = tool.p_WS - object.p_WS;
  const double length = way.norm();
  return length > 0.0 ? Vector3(way / length) : Vector3::UnitZ();
}

Vector3 support_point(const PlacedShape& placed, const Vector3& d_W, int& hint) noexcept {
  if (!placed.shape->is_bounded()) return placed.p_WS;
  const SupportPoint found = support(*placed.shape, placed.R_WS.transpose() * d_W, hint);
  if (found.vertex >= 0) hint = found.vertex;
  return placed.to_world(found.p);
}

}  // namespace

Facing measured_facing(const PlacedShape& tool, const PlacedShape& object, const Vector3& n_last_W,
                       ClosestPointsCache& cache) noexcept {
  const ClosestPoints closest = closest_points(tool, object, cache);
  if (closest.separation == Separation::kSeparated) {
    return {true, false, closest.distance, closest.p_WA, closest.p_WB, closest.n_W};
  }
  const bool known = is_direction(n_last_W);
  const Penetration depth = known ? penetration_from(tool, object, n_last_W, cache) : penetration(tool, object, cache);
  if (depth.valid) return {false, false, -depth.depth, depth.p_WA, depth.p_WB, depth.n_W};
  Facing facing = facing_along(tool, object, known ? n_last_W : closest.n_W, cache);
  facing.by_plane = false;
  return facing;
}

Facing facing_along(const PlacedShape& tool, const PlacedShape& object, const Vector3& n_W,
                    ClosestPointsCache& cache) noexcept {
  Facing facing;
  facing.by_plane = true;
  facing.n_W = is_direction(n_W) ? n_W : direction_between(tool, object);
  facing.p_WA = support_point(tool, -facing.n_W, cache.hint_tool);
  facing.p_WB = support_point(object, facing.n_W, cache.hint_object);
  facing.gap = facing.n_W.dot(facing.p_WA - facing.p_WB);
  return facing;
}

}  // namespace tegotae
