// SPDX-License-Identifier: Apache-2.0
#include <tegotae/contact/penetration.hpp>

#include <tegotae/contact/closest_points_plane.hpp>
#include <tegotae/contact/gjk.hpp>
#include <tegotae/contact/gjk_warm_start.hpp>
#include <tegotae/contact/penetration_descent.hpp>
#include <tegotae/contact/penetration_expansion.hpp>
#include <tegotae/contact/tolerances.hpp>

#include <algorithm>
#include <cmath>

namespace tegotae {
namespace {

Penetration into_plane(const PlaneGap& gap, bool plane_is_object) noexcept {
  Penetration result;
  result.iterations = 1;
  result.n_W = plane_is_object ? gap.normal_W : Vector3(-gap.normal_W);
  result.valid = std::abs(gap.gap) < 1e300 && gap.gap <= tolerances::kTouching;
  result.depth = std::max(-gap.gap, 0.0);
  result.p_WA = plane_is_object ? gap.p_W_shape : gap.p_W_plane;
  result.p_WB = result.p_WA + result.depth * result.n_W;
  return result;
}

// Closed form where one of the shapes is a plane; two planes have no answer.
bool plane_answers(const PlacedShape& tool, const PlacedShape& object, ClosestPointsCache& cache,
                   Penetration& result) noexcept {
  if (is_plane(object)) {
    if (!is_plane(tool)) result = into_plane(gap_to_plane(tool, object, cache.hint_tool), true);
    return true;
  }
  if (is_plane(tool)) result = into_plane(gap_to_plane(object, tool, cache.hint_object), false);
  return is_plane(tool);
}

bool is_finite(const gjk::Pair& pair, const PlacedShape& object) noexcept {
  return pair.extent < 1e100 && pair.R_OT.allFinite() && object.R_WS.allFinite();
}

Penetration in_world(const gjk::Pair& pair, const gjk::Descent& found, const PlacedShape& object) noexcept {
  Penetration result;
  result.iterations = found.iterations;
  const double depth = found.depth + pair.radius();
  result.valid = depth >= -tolerances::kTouching;
  if (!result.valid) return result;
  result.depth = std::max(depth, 0.0);
  result.n_W = object.R_WS * found.n;
  result.p_WA = object.to_world(found.p_tool - pair.tool.radius * found.n);
  result.p_WB = result.p_WA + result.depth * result.n_W;
  return result;
}

Penetration descend_and_report(gjk::Pair& pair, const Vector3& n, int iterations, const PlacedShape& object,
                               ClosestPointsCache& cache) noexcept {
  gjk::Descent found = gjk::descend(pair, n);
  found.iterations += iterations;
  cache.hint_tool = pair.tool_hint;
  cache.hint_object = pair.object_hint;
  return in_world(pair, found, object);
}

}  // namespace

Penetration penetration(const PlacedShape& tool, const PlacedShape& object, ClosestPointsCache& cache) noexcept {
  Penetration result;
  if (plane_answers(tool, object, cache, result)) return result;
  gjk::Pair pair(tool, object);
  if (!is_finite(pair, object)) return result;
  gjk::take_hints(pair, cache);
  gjk::Simplex simplex;
  gjk::start_cold(pair, 0, simplex);
  const gjk::Result cores = gjk::run(pair, simplex);
  if (cores.verdict == gjk::Verdict::kApart && cores.lower > 0.0) {
    return descend_and_report(pair, cores.n, cores.iterations, object, cache);
  }
  const gjk::CoreDepth least = gjk::least_depth(pair);
  return descend_and_report(pair, least.n, cores.iterations + least.iterations, object, cache);
}

Penetration penetration_from(const PlacedShape& tool, const PlacedShape& object, const Vector3& n_start_W,
                             ClosestPointsCache& cache) noexcept {
  Penetration result;
  if (plane_answers(tool, object, cache, result)) return result;
  gjk::Pair pair(tool, object);
  const double length = n_start_W.norm();
  if (!is_finite(pair, object) || !(length > 0.0 && length < 1e100)) return result;
  gjk::take_hints(pair, cache);
  return descend_and_report(pair, object.R_WS.transpose() * n_start_W / length, 0, object, cache);
}

}  // namespace tegotae
