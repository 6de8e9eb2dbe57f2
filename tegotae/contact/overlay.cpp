// SPDX-License-Identifier: Apache-2.0
#include <tegotae/contact/overlay.hpp>

#include <tegotae/contact/tolerances.hpp>

#include <algorithm>
#include <cmath>

namespace tegotae {
namespace {

enum class PointKind : std::uint8_t { kToolVertex, kObjectVertex, kCrossing, kClosestPair };

std::uint64_t packed(PointKind kind, int tool, int object) noexcept {
  return static_cast<std::uint64_t>(kind) << 62 | static_cast<std::uint64_t>(tool) << 31 |
         static_cast<std::uint64_t>(object);
}

/// Collects points and keeps them apart.
class Collector {
 public:
  Collector(const OverlayQuery& query, const OverlayFrame& frame, std::span<OverlayPoint> points) noexcept
      : frame_(frame), limit_(query.distance + query.margin), points_(points) {}

  double limit() const noexcept { return limit_; }
  int count() const noexcept { return count_; }
  double least_gap() const noexcept { return least_gap_; }

  /// At (x, y), the tool's surface `h_tool` and the object's `h_object` high, each towards the other.
  void add(double x, double y, double h_tool, double h_object, std::uint64_t feature) noexcept {
    const double gap = -h_tool - h_object;
    if (!(gap < limit_)) return;
    add({frame_.origin_W + x * frame_.x_W + y * frame_.y_W - h_tool * frame_.n_W, gap, feature});
  }

  void add(const OverlayPoint& point) noexcept {
    least_gap_ = std::min(least_gap_, point.gap);
    if (count_ < static_cast<int>(points_.size())) points_[static_cast<size_t>(count_)] = point;
    ++count_;
  }

  /// Whether a tool vertex already stands at (x, y).
  bool has_point_at(double x, double y) const noexcept {
    const Vector3 p = frame_.origin_W + x * frame_.x_W + y * frame_.y_W;
    for (int i = 0; i < std::min(count_, static_cast<int>(points_.size())); ++i) {
      const Vector3 d = points_[static_cast<size_t>(i)].p_WA - p;
      if (std::max(std::abs(frame_.x_W.dot(d)), std::abs(frame_.y_W.dot(d))) < tolerances::kOutline) return true;
    }
    return false;
  }

 private:
  const OverlayFrame& frame_;
  double limit_;
  std::span<OverlayPoint> points_;
  int count_ = 0;
  double least_gap_ = 1e300;
};

void add_tool_vertices(const OverlayWorkspace& workspace, Collector& collector) noexcept {
  for (const FacingSurface::Vertex& v : workspace.tool.vertices()) {
    double h = 0.0;
    if (!v.faces || !workspace.object.height_at(v.x, v.y, h)) continue;
    collector.add(v.x, v.y, v.h, h, packed(PointKind::kToolVertex, v.feature, 0));
  }
}

void add_object_vertices(const OverlayWorkspace& workspace, Collector& collector) noexcept {
  for (const FacingSurface::Vertex& v : workspace.object.vertices()) {
    double h = 0.0;
    if (!v.faces || !workspace.tool.height_at(v.x, v.y, h) || !(-h - v.h < collector.limit())) continue;
    if (!collector.has_point_at(v.x, v.y)) {
      collector.add(v.x, v.y, h, v.h, packed(PointKind::kObjectVertex, 0, v.feature));
    }
  }
}

// Crossings at an end of either edge are left to the vertices.
void add_crossing(const FacingSurface::Edge& a, const FacingSurface::Edge& b, Collector& collector) noexcept {
  constexpr double kParallel = 1e-9;  // sine; such edges lie within 1e-9 of their length over each other: ends suffice
  const double x = b.x - a.x, y = b.y - a.y;
  const double cross = a.dx * b.dy - a.dy * b.dx;
  // Both ends of b on one side of a: most pairs end here.
  const double side = a.dx * y - a.dy * x;
  if (side * (side + cross) >= 0.0) return;
  if (cross * cross <= kParallel * kParallel * a.length2 * b.length2) return;
  const double s = (x * b.dy - y * b.dx) / cross;
  const double t = -side / cross;
  if (!(s > 0.0 && s < 1.0)) return;
  constexpr double kEnd = 0.5 * tolerances::kOutline;
  const double from_a = std::min(s, 1.0 - s), from_b = std::min(t, 1.0 - t);
  if (from_a * from_a * a.length2 <= kEnd * kEnd || from_b * from_b * b.length2 <= kEnd * kEnd) return;
  collector.add(a.x + s * a.dx, a.y + s * a.dy, a.h + s * a.dh, b.h + t * b.dh,
                packed(PointKind::kCrossing, a.feature, b.feature));
}

void add_crossings(const OverlayWorkspace& workspace, Collector& collector) noexcept {
  for (const FacingSurface::Edge& a : workspace.tool.edges()) {
    for (const FacingSurface::Edge& b : workspace.object.edges()) add_crossing(a, b, collector);
  }
}

// Where an end of something lies over a line that has no area: two capsules side by side, a capsule along an edge.
// Beside the line, at a distance e, the gap is that of the balls swept along it: hypot(D, e) - R, with D the distance
// of their centres along the direction of projection and R the sum of their radii.
template <class Add>
void add_over_ridges(const FacingSurface& ends, const FacingSurface& lines, const Add& add) noexcept {
  if (!lines.has_ridge()) return;
  for (const FacingSurface::Edge& line : lines.edges()) {
    if (!(line.radius > 0.0) || !(line.length2 > tolerances::kOutline * tolerances::kOutline)) continue;
    for (const FacingSurface::Vertex& v : ends.vertices()) {
      if (!v.faces) continue;
      const double x = v.x - line.x, y = v.y - line.y;
      const double s = (x * line.dx + y * line.dy) / line.length2;
      if (!(s >= 0.0 && s <= 1.0)) continue;
      const double h = line.h + s * line.dh, radii = v.radius + line.radius;
      const double between = radii - v.h - h;
      const double beside = std::hypot(x - s * line.dx, y - s * line.dy);
      if (between > 0.0) add(v, line, h - (std::hypot(between, beside) - between));
    }
  }
}

void add_ends_over_ridges(const OverlayWorkspace& workspace, Collector& collector) noexcept {
  using Vertex = FacingSurface::Vertex;
  using Edge = FacingSurface::Edge;
  add_over_ridges(workspace.tool, workspace.object, [&](const Vertex& v, const Edge& line, double h_line) {
    if (collector.has_point_at(v.x, v.y)) return;
    collector.add(v.x, v.y, v.h, h_line, packed(PointKind::kToolVertex, v.feature, 1 + line.feature));
  });
  add_over_ridges(workspace.object, workspace.tool, [&](const Vertex& v, const Edge& line, double h_line) {
    if (collector.has_point_at(v.x, v.y)) return;
    collector.add(v.x, v.y, h_line, v.h, packed(PointKind::kObjectVertex, 1 + line.feature, v.feature));
  });
}

bool is_valid(const OverlayQuery& query) noexcept {
  return query.tool->shape->is_bounded() && query.p_WA.allFinite() && query.p_WB.allFinite() &&
         std::abs(query.n_W.squaredNorm() - 1.0) < 1e-6 && std::isfinite(query.distance) &&
         std::isfinite(query.margin) && query.tool->R_WS.allFinite() && query.object->R_WS.allFinite();
}

}  // namespace

int overlay(const OverlayQuery& query, OverlayWorkspace& workspace, std::span<OverlayPoint> points) noexcept {
  if (!is_valid(query)) return 0;
  // The middle of the pair as origin: heights near it keep all their digits.
  const OverlayFrame frame(0.5 * (query.p_WA + query.p_WB), query.n_W);
  workspace.object.fill(*query.object, frame, GapSide::kObject, query.p_WB, query.margin, query.hint_object);
  workspace.tool.fill(*query.tool, frame, GapSide::kTool, query.p_WA, query.margin, query.hint_tool, &workspace.object);
  Collector collector(query, frame, points);
  add_tool_vertices(workspace, collector);
  add_object_vertices(workspace, collector);
  add_crossings(workspace, collector);
  add_ends_over_ridges(workspace, collector);
  if (query.closest_pair && collector.least_gap() > query.distance + tolerances::kTouching) {
    collector.add({query.p_WA, query.distance, packed(PointKind::kClosestPair, 0, 0)});
  }
  return collector.count();
}

}  // namespace tegotae
