// SPDX-License-Identifier: Apache-2.0
#include <tegotae/contact/gjk.hpp>

#include <tegotae/contact/tolerances.hpp>

#include <algorithm>

namespace tegotae::gjk {
namespace {

// Polytopes need as many passes as they have vertices on the way, seldom more than twelve; curved shapes up to fifty
// to reach rounding.
constexpr int kMaxIterations = 128;

// Passes in a row that may leave both bounds as they are, but for rounding. Where faces are nearly parallel the origin
// projects onto an edge between two triangles, the distance falls by less than rounding, and yet the next vertex opens
// the right face.
constexpr int kMaxStalls = 4;

// Part of rounding: smaller gains are noise, with which a curved pair would go on until the bound.
constexpr double kLeastProgress = 1.0 / 16.0;

void take_witnesses(const Simplex& simplex, Result& result) noexcept {
  result.p_tool = simplex.tool_point();
  result.p_object = simplex.object_point();
}

}  // namespace

Pair::Pair(const PlacedShape& the_tool, const PlacedShape& the_object) noexcept
    : tool(*the_tool.shape),
      object(*the_object.shape),
      R_OT(the_object.R_WS.transpose() * the_tool.R_WS),
      p_OT(the_object.R_WS.transpose() * (the_tool.p_WS - the_object.p_WS)) {
  extent = p_OT.lpNorm<Eigen::Infinity>() + tool.extent() + object.extent() + radius();
}

MinkowskiPoint Pair::support(const Vector3& n) noexcept {
  const SupportPoint on_tool = tool.support(-(R_OT.transpose() * n), tool_hint);
  const SupportPoint on_object = object.support(n, object_hint);
  if (on_tool.vertex >= 0) tool_hint = on_tool.vertex;
  if (on_object.vertex >= 0) object_hint = on_object.vertex;
  MinkowskiPoint point;
  point.tool = R_OT * on_tool.p + p_OT;
  point.object = on_object.p;
  point.w = point.tool - point.object;
  point.tool_vertex = on_tool.vertex;
  point.object_vertex = on_object.vertex;
  return point;
}

MinkowskiPoint Pair::vertex(int tool_vertex, int object_vertex) const noexcept {
  MinkowskiPoint point;
  point.tool = R_OT * tool.vertex(tool_vertex) + p_OT;
  point.object = object.vertex(object_vertex);
  point.w = point.tool - point.object;
  point.tool_vertex = tool_vertex;
  point.object_vertex = object_vertex;
  return point;
}

Result run(Pair& pair, Simplex& simplex) noexcept {
  const double rounding = tolerances::kRounding * pair.extent;
  const double least_progress = kLeastProgress * rounding;
  Result result;
  result.upper = 1e300;
  double greatest_lower = result.lower;
  int stalls = 0;
  while (result.iterations < kMaxIterations) {
    ++result.iterations;
    const NearestPoint nearest = reduce_to_nearest(simplex);
    if (nearest.inside || nearest.distance <= rounding) {
      result.verdict = nearest.inside ? Verdict::kOverlap : Verdict::kTouching;
      take_witnesses(simplex, result);
      return result;
    }
    if (simplex.count == 0) break;
    result.verdict = Verdict::kApart;
    bool progress = nearest.distance < result.upper - least_progress;
    if (nearest.distance < result.upper + rounding) {
      result.upper = std::min(result.upper, nearest.distance);
      take_witnesses(simplex, result);
    }
    const MinkowskiPoint next = pair.support(nearest.n);
    const double lower = nearest.n.dot(next.w);
    progress = progress || lower > greatest_lower + least_progress;
    stalls = progress ? 0 : stalls + 1;
    // A later direction is the better one unless its bound is worse by more than rounding.
    greatest_lower = std::max(greatest_lower, lower);
    if (lower > greatest_lower - rounding) {
      result.lower = lower;
      result.n = nearest.n;
    }
    if (stalls > kMaxStalls || nearest.distance - lower <= rounding || simplex.contains(next)) break;
    simplex.add(next);
  }
  return result;
}

}  // namespace tegotae::gjk
