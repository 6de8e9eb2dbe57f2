// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/contact/gjk_core.hpp>
#include <tegotae/contact/gjk_simplex.hpp>

namespace tegotae::gjk {

/// Two cores in the object's frame. There, and not in the world, the points near a contact keep all their digits.
struct Pair {
  Core tool;
  Core object;
  Matrix3 R_OT = Matrix3::Identity();  ///< tool's shape frame in the object's
  Vector3 p_OT = Vector3::Zero();      ///< m
  double extent = 0.0;                 ///< greatest coordinate of a Minkowski point (a bound), m
  int tool_hint = 0;                   ///< where hill climbing starts; kept up to date by `support`
  int object_hint = 0;

  Pair(const PlacedShape& the_tool, const PlacedShape& the_object) noexcept;

  bool has_vertices() const noexcept { return tool.has_vertices() && object.has_vertices(); }
  double radius() const noexcept { return tool.radius + object.radius; }  ///< of both roundings together, m
  /// The Minkowski point least far along `n` (object's frame): n.w of it is what the support planes normal to n prove.
  MinkowskiPoint support(const Vector3& n) noexcept;
  MinkowskiPoint vertex(int tool_vertex, int object_vertex) const noexcept;
};

enum class Verdict {
  kApart,      ///< the cores are apart: upper, lower and n hold
  kTouching,   ///< a point of the Minkowski difference within rounding of the origin was found
  kOverlap,    ///< a tetrahedron in the Minkowski difference holds the origin
  kUndecided,  ///< stopped by NaN or the bound on iterations without one of these
};

struct Result {
  Verdict verdict = Verdict::kUndecided;
  double upper = 0.0;            ///< distance of the cores' points found, m
  double lower = -1e300;         ///< distance of the support planes normal to n, m: a true lower bound
  Vector3 n = Vector3::UnitZ();  ///< unit, from object to tool
  Vector3 p_tool = Vector3::Zero();
  Vector3 p_object = Vector3::Zero();  ///< the cores' points nearest each other, m
  int iterations = 0;
};

/// Gilbert, Johnson and Keerthi (1988) on the Minkowski difference of the cores, from `simplex` (at least one point),
/// in which the last simplex is left. Each pass finds the simplex point nearest the origin and the support point
/// against it; both bounds are kept, and the loop ends when they meet within rounding, when the support point is known
/// already, or when no progress is made. Does not allocate; bounded iterations.
Result run(Pair& pair, Simplex& simplex) noexcept;

}  // namespace tegotae::gjk
