// SPDX-License-Identifier: Apache-2.0
#include <tegotae/contact/clip_dilation.hpp>

#include <tegotae/contact/tolerances.hpp>

#include <algorithm>

namespace tegotae {

ClipDilation::ClipDilation(int max_vertices, int max_faces)
    : points_(static_cast<size_t>(max_vertices)),
      way_(static_cast<size_t>(max_vertices)),
      vertex_faces_(3 * static_cast<size_t>(max_vertices)),
      broken_(static_cast<size_t>(max_faces)) {}

void ClipDilation::apply(const Polytope& polytope, const Vector3& dilation) noexcept {
  std::copy(polytope.vertices.begin(), polytope.vertices.end(), points_.begin());
  intact_ = true;
  if (dilation == Vector3::Zero()) return;
  find_ways(polytope, dilation);
  intact_ = move_vertices(polytope, dilation) && keeps_edges(polytope);
  if (!intact_) mark_broken(polytope);
}

void ClipDilation::find_ways(const Polytope& polytope, const Vector3& dilation) noexcept {
  std::fill_n(way_.begin(), polytope.vertices.size(), std::uint8_t{0});
  for (size_t f = 0; f < polytope.faces.size(); ++f) {
    const double shift = polytope.faces[f].normal.dot(dilation);
    const std::uint8_t way = shift > tolerances::kOnPlane ? kAlong : shift < -tolerances::kOnPlane ? kAway : 0;
    for (const int v : polytope.vertices_of(polytope.faces[f])) {
      way_[static_cast<size_t>(v)] |= way;
      // A queue of three: it holds all faces of a vertex that has three.
      int* const faces = vertex_faces_.data() + 3 * v;
      faces[0] = faces[1], faces[1] = faces[2], faces[2] = static_cast<int>(f);
    }
  }
}

// False if a vertex of the rim parts into several.
bool ClipDilation::move_vertices(const Polytope& polytope, const Vector3& dilation) noexcept {
  bool whole = true;
  for (size_t v = 0; v < polytope.vertices.size(); ++v) {
    if (way_[v] == kAlong) points_[v] += dilation;
    if (way_[v] != kBoth) continue;
    if (polytope.neighbors_of(static_cast<int>(v)).size() != 3) {
      whole = false;
      continue;
    }
    // The displacement w of the vertex: n.w = max(0, n.dilation) for its three faces.
    const auto normal = [&](size_t k) -> const Vector3& {
      return polytope.faces[static_cast<size_t>(vertex_faces_[3 * v + k])].normal;
    };
    const auto shift = [&](size_t k) { return std::max(0.0, normal(k).dot(dilation)); };
    const Vector3 bc = normal(1).cross(normal(2)), ca = normal(2).cross(normal(0)), ab = normal(0).cross(normal(1));
    points_[v] += (shift(0) * bc + shift(1) * ca + shift(2) * ab) / normal(0).dot(bc);
  }
  return whole;
}

// With three faces at each vertex of the rim, the neighbours are right if every edge still points the way it did.
bool ClipDilation::keeps_edges(const Polytope& polytope) const noexcept {
  return std::all_of(polytope.edges.begin(), polytope.edges.end(), [&](const Polytope::Edge& edge) {
    const size_t u = static_cast<size_t>(edge.vertex[0]), v = static_cast<size_t>(edge.vertex[1]);
    return (points_[v] - points_[u]).dot(polytope.vertices[v] - polytope.vertices[u]) > 0.0;
  });
}

void ClipDilation::mark_broken(const Polytope& polytope) noexcept {
  for (size_t f = 0; f < polytope.faces.size(); ++f) {
    const auto loop = polytope.vertices_of(polytope.faces[f]);
    broken_[f] = std::any_of(loop.begin(), loop.end(), [&](int v) { return way_[static_cast<size_t>(v)] == kBoth; });
  }
}

}  // namespace tegotae
