// SPDX-License-Identifier: Apache-2.0
#include <tegotae/contact/gjk_warm_start.hpp>

#include <algorithm>
#include <array>

namespace tegotae::gjk {
namespace {

bool in_range(int index, int count) noexcept { return index >= 0 && index < count; }

int valid_hint(int hint, const Core& core) noexcept { return in_range(hint, core.vertex_count()) ? hint : 0; }

bool is_direction(const Vector3& n) noexcept {
  const double length2 = n.squaredNorm();
  return length2 > 1e-12 && length2 < 1e12;
}

void restore_simplex(const Pair& pair, const ClosestPointsCache& cache, Simplex& simplex) noexcept {
  const int count = std::clamp(cache.vertex_count, 0, 4);
  const int tool_count = pair.tool.vertex_count();
  const int object_count = pair.object.vertex_count();
  for (size_t k = 0; k < static_cast<size_t>(count); ++k) {
    if (!in_range(cache.vertex_tool[k], tool_count) || !in_range(cache.vertex_object[k], object_count)) continue;
    simplex.add(pair.vertex(cache.vertex_tool[k], cache.vertex_object[k]));
  }
}

// The second and later starts: three axes both ways, turned off the coordinate axes, along which boxes tie.
constexpr double kLong = 0.9284766908852593;
constexpr double kMiddle = 0.30151134457776363;
constexpr double kShort = 0.21693045781865616;

Vector3 start_direction(int attempt) noexcept {
  const double sign = attempt % 2 == 0 ? 1.0 : -1.0;
  switch (attempt / 2 % 3) {
    case 0:
      return {sign * kLong, sign * kMiddle, sign * kShort};
    case 1:
      return {-sign * kShort, sign * kLong, sign * kMiddle};
    default:
      return {-sign * kMiddle, -sign * kShort, sign * kLong};
  }
}

}  // namespace

void take_hints(Pair& pair, const ClosestPointsCache& cache) noexcept {
  pair.tool_hint = valid_hint(cache.hint_tool, pair.tool);
  pair.object_hint = valid_hint(cache.hint_object, pair.object);
}

void start_along(Pair& pair, const Vector3& n, Simplex& simplex) noexcept {
  simplex.count = 0;
  simplex.add(pair.support(n));
}

void start_cold(Pair& pair, int attempt, Simplex& simplex) noexcept {
  const bool between = attempt == 0 && is_direction(pair.p_OT.normalized());
  start_along(pair, between ? Vector3(pair.p_OT.normalized()) : start_direction(attempt), simplex);
}

void start_warm(Pair& pair, const ClosestPointsCache& cache, Simplex& simplex) noexcept {
  take_hints(pair, cache);
  simplex.count = 0;
  if (pair.has_vertices()) restore_simplex(pair, cache, simplex);
  if (simplex.count > 0) return;
  if (is_direction(cache.direction)) {
    start_along(pair, cache.direction, simplex);
  } else {
    start_cold(pair, 0, simplex);
  }
}

void store(const Pair& pair, const Simplex& simplex, const Result& found, ClosestPointsCache& cache) noexcept {
  cache.direction = found.n;
  cache.hint_tool = pair.tool_hint;
  cache.hint_object = pair.object_hint;
  cache.vertex_count = pair.has_vertices() ? simplex.count : 0;
  for (size_t k = 0; k < static_cast<size_t>(cache.vertex_count); ++k) {
    cache.vertex_tool[k] = simplex.point[k].tool_vertex;
    cache.vertex_object[k] = simplex.point[k].object_vertex;
  }
}

}  // namespace tegotae::gjk
