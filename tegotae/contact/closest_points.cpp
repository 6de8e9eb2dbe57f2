// SPDX-License-Identifier: Apache-2.0
#include <tegotae/contact/closest_points.hpp>

#include <tegotae/contact/closest_points_plane.hpp>
#include <tegotae/contact/gjk.hpp>
#include <tegotae/contact/gjk_warm_start.hpp>
#include <tegotae/contact/tolerances.hpp>

#include <cmath>

namespace tegotae {
namespace {

ClosestPoints closest_to_plane(const PlaneGap& gap, bool plane_is_object) noexcept {
  ClosestPoints result;
  result.iterations = 1;
  if (!(std::abs(gap.gap) < 1e300)) return result;
  const double extent = gap.p_W_shape.lpNorm<Eigen::Infinity>();
  if (gap.gap > tolerances::kLeastDistance * extent) result.separation = Separation::kSeparated;
  result.distance = gap.gap;
  result.lower_bound = gap.gap;
  result.n_W = plane_is_object ? gap.normal_W : Vector3(-gap.normal_W);
  result.p_WA = plane_is_object ? gap.p_W_shape : gap.p_W_plane;
  result.p_WB = plane_is_object ? gap.p_W_plane : gap.p_W_shape;
  return result;
}

bool certified(const gjk::Pair& pair, const gjk::Result& found) noexcept {
  const double distance = found.upper - pair.radius();
  return found.verdict == gjk::Verdict::kApart && distance > tolerances::kLeastDistance * pair.extent &&
         found.lower - pair.radius() >= tolerances::kCertificate * distance;
}

// True when witness points nearer than any distance worth reporting were found: no other start can find a distance.
bool proven_close(const gjk::Pair& pair, const gjk::Result& found) noexcept {
  if (found.verdict == gjk::Verdict::kOverlap || found.verdict == gjk::Verdict::kTouching) return true;
  return found.verdict == gjk::Verdict::kApart &&
         found.upper - pair.radius() <= tolerances::kLeastDistance * pair.extent;
}

void retry_cold(gjk::Pair& pair, gjk::Simplex& simplex, gjk::Result& found) noexcept {
  for (int attempt = 0; attempt < gjk::kColdStarts; ++attempt) {
    if (certified(pair, found) || proven_close(pair, found)) return;
    const int iterations = found.iterations;
    gjk::start_cold(pair, attempt, simplex);
    found = gjk::run(pair, simplex);
    found.iterations += iterations;
  }
}

ClosestPoints in_world(const gjk::Pair& pair, const gjk::Result& found, const PlacedShape& object) noexcept {
  ClosestPoints result;
  result.iterations = found.iterations;
  if (!certified(pair, found)) return result;
  result.separation = Separation::kSeparated;
  result.distance = found.upper - pair.radius();
  result.lower_bound = found.lower - pair.radius();
  result.n_W = object.R_WS * found.n;
  result.p_WA = object.to_world(found.p_tool - pair.tool.radius * found.n);
  result.p_WB = object.to_world(found.p_object + pair.object.radius * found.n);
  return result;
}

}  // namespace

ClosestPoints closest_points(const PlacedShape& tool, const PlacedShape& object, ClosestPointsCache& cache) noexcept {
  if (is_plane(tool) && is_plane(object)) return {};
  if (is_plane(object)) return closest_to_plane(gap_to_plane(tool, object, cache.hint_tool), true);
  if (is_plane(tool)) return closest_to_plane(gap_to_plane(object, tool, cache.hint_object), false);

  gjk::Pair pair(tool, object);
  if (!(pair.extent < 1e100) || !pair.R_OT.allFinite() || !object.R_WS.allFinite()) return {};
  gjk::Simplex simplex;
  gjk::start_warm(pair, cache, simplex);
  gjk::Result found = gjk::run(pair, simplex);
  retry_cold(pair, simplex, found);
  gjk::store(pair, simplex, found, cache);
  return in_world(pair, found, object);
}

}  // namespace tegotae
