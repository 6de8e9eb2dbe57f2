// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/contact/clip_edge.hpp>
#include <tegotae/contact/clip_locator.hpp>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace tegotae {

/// The vertices and edges of one polytope, and how they lie to the other body: none of this allocates but the
/// constructor.
class ClipSide {
 public:
  static constexpr size_t kMaskBits = 64;

  explicit ClipSide(int max_vertices);

  /// Vertices in the other body's frame, m: to be filled before the rest is asked for.
  std::vector<Vector3>& points() noexcept { return points_; }
  const Vector3& point(size_t vertex) const noexcept { return points_[vertex]; }
  bool is_inside(size_t vertex) const noexcept { return outside_[vertex] == 0; }

  /// Finds which of at most kMaskBits planes exclude each of `count` vertices. False if one excludes all.
  bool classify(std::span<const ClipPlane> planes, size_t count) noexcept;
  /// Finds a plane that excludes each vertex of `polytope`, going from neighbour to neighbour.
  template <class Locator>
  void classify(const Locator& body, const Polytope& polytope) noexcept;
  /// Calls add(edge, from vertex, to vertex, entry) where edges of `polytope` enter `body`.
  template <class Locator, class Add>
  void clip_edges(const Locator& body, const Polytope& polytope, const Add& add) const noexcept;

 private:
  template <class Locator>
  void place(const Locator& body, size_t vertex, int hint) noexcept;

  std::vector<Vector3> points_;
  std::vector<std::uint64_t> outside_;  ///< 0 inside; else a bit for each excluding plane, or, if not masked, 1
  std::vector<int> plane_;              ///< outside: one that excludes; inside, if not masked: where the search ended
  std::vector<int> stack_;
  bool masked_ = false;
};

template <class Locator>
void ClipSide::place(const Locator& body, size_t vertex, int hint) noexcept {
  // What excludes a vertex mostly excludes its neighbours.
  if (body.slack(hint, points_[vertex]) > tolerances::kOnPlane) {
    plane_[vertex] = hint;
    outside_[vertex] = 1;
    return;
  }
  const Located worst = body.locate(points_[vertex], hint);
  plane_[vertex] = worst.plane;
  outside_[vertex] = worst.slack > tolerances::kOnPlane ? 1 : 0;
}

template <class Locator>
void ClipSide::classify(const Locator& body, const Polytope& polytope) noexcept {
  masked_ = false;
  std::fill_n(plane_.begin(), polytope.vertices.size(), -1);
  size_t depth = 0;
  place(body, 0, body.locate(points_[0], 0).plane);
  stack_[depth++] = 0;
  while (depth > 0) {
    const int vertex = stack_[--depth];
    for (const int neighbor : polytope.neighbors_of(vertex)) {
      if (plane_[static_cast<size_t>(neighbor)] >= 0) continue;
      place(body, static_cast<size_t>(neighbor), plane_[static_cast<size_t>(vertex)]);
      stack_[depth++] = neighbor;
    }
  }
}

template <class Locator, class Add>
void ClipSide::clip_edges(const Locator& body, const Polytope& polytope, const Add& add) const noexcept {
  const int edge_count = static_cast<int>(polytope.edges.size());
  for (int e = 0; e < edge_count; ++e) {
    const Polytope::Edge& edge = polytope.edges[static_cast<size_t>(e)];
    size_t from = static_cast<size_t>(edge.vertex[0]), to = static_cast<size_t>(edge.vertex[1]);
    if (is_inside(from) && is_inside(to)) continue;
    if (is_inside(from) || is_inside(to)) {
      if (is_inside(from)) std::swap(from, to);
      // Where a single plane excludes a vertex, all others hold on the whole way to a vertex inside.
      const ClipEntry entry = masked_ && std::has_single_bit(outside_[from])
                                  ? clip_entry_through(body, points_[from], points_[to], plane_[from])
                                  : clip_entry(body, points_[from], points_[to], plane_[from]);
      if (entry.found) add(e, from, to, entry);
      continue;
    }
    if (masked_ ? (outside_[from] & outside_[to]) != 0 : plane_[from] == plane_[to]) continue;
    if (body.slack(plane_[to], points_[from]) >= -tolerances::kOnPlane) continue;
    const ClipEntry entry = clip_entry(body, points_[from], points_[to], plane_[from]);
    if (!entry.found) continue;
    add(e, from, to, entry);
    const ClipEntry back = clip_entry(body, points_[to], points_[from], plane_[to]);
    if (back.found) add(e, to, from, back);
  }
}

}  // namespace tegotae
