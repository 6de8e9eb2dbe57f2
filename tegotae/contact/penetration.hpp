// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/contact/closest_points.hpp>

namespace tegotae {

/// How to part two shapes that are not separated.
struct Penetration {
  bool valid = false;              ///< false: clearly separated, NaN, or two planes
  double depth = 0.0;              ///< m, >= 0: translating the tool by depth * n_W parts the shapes
  Vector3 p_WA = Vector3::Zero();  ///< deepest tool point along -n_W, m
  Vector3 p_WB = Vector3::Zero();  ///< object point that it must come back to: p_WA + depth * n_W, m
  Vector3 n_W = Vector3::UnitZ();  ///< unit, out of the object
  int iterations = 0;
};

/// Least translation that parts the shapes, the global minimum over directions: expanding polytope (van den Bergen
/// 2001) on the Minkowski difference of the shapes' cores, then `penetration_from` its direction. Exact to rounding for
/// polytopes, spheres and capsules; about 1e-9 of the extent for cylinders and ellipsoids. Whatever limit is met, depth
/// and normal part the shapes. Works for separated shapes too close for `closest_points` (depth 0); if the shapes are
/// apart by more than `tolerances::kTouching` the answer is invalid. Does not allocate; bounded.
/// Of the cache only the hill-climbing hints are used, so the warm start of `closest_points` is left in peace.
Penetration penetration(const PlacedShape& tool, const PlacedShape& object, ClosestPointsCache& cache) noexcept;

/// The local minimum of the parting translation reached by descent from the direction `n_start_W` (out of the object,
/// any length): h(n), the depth along n, never rises on the way, and the descent ends where n is normal to the facing
/// surfaces. Started each step from the last step's n_W it stays with the same face of the pair, however deep, as long
/// as translation along that face's normal is a local minimum; so a tool pressed through a thin plate is pushed back
/// out of the side that it came in by, where the global minimum changes sides at half the plate's thickness. The local
/// minimum vanishes where the point of least translation runs over the edge of its Minkowski face (the tool slides off
/// the object's rim), or where the shapes part: the descent then goes on to the neighbouring minimum, and the normal
/// jumps.
/// Ask it only for a pair that is not separated: of one that is, from a start on the far side, it gives the minimum
/// there. Accuracy, validity, bounds and cache as `penetration`.
Penetration penetration_from(const PlacedShape& tool, const PlacedShape& object, const Vector3& n_start_W,
                             ClosestPointsCache& cache) noexcept;

}  // namespace tegotae
