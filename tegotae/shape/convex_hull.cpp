// SPDX-License-Identifier: Apache-2.0
#include <tegotae/shape/convex_hull.hpp>

#include <tegotae/shape/hull_triangles.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <stdexcept>
#include <utility>

namespace tegotae {
namespace {

using DirectedEdge = std::pair<int, int>;

class FaceMerger {
 public:
  FaceMerger(std::span<const Vector3> points, std::vector<HullTriangle> triangles, double coplanarity)
      : points_(points), triangles_(std::move(triangles)), group_(triangles_.size(), -1) {
    Vector3 lower = points[0], upper = points[0];
    for (const Vector3& p : points) lower = lower.cwiseMin(p), upper = upper.cwiseMax(p);
    tolerance_ = coplanarity * (upper - lower).norm();
    for (size_t t = 0; t < triangles_.size(); ++t) {
      for (int k = 0; k < 3; ++k) owner_[edge_of(static_cast<int>(t), k)] = static_cast<int>(t);
    }
  }

  /// Vertex loops of the maximal faces.
  std::vector<std::vector<int>> loops() {
    std::vector<int> order(triangles_.size());
    std::iota(order.begin(), order.end(), 0);
    std::stable_sort(order.begin(), order.end(), [this](int a, int b) { return area(a) > area(b); });
    std::vector<std::vector<int>> result;
    for (const int seed : order) {
      if (group_[static_cast<size_t>(seed)] < 0) result.push_back(boundary(grow(seed)));
    }
    return result;
  }

 private:
  DirectedEdge edge_of(int triangle, int k) const {
    const auto& v = triangles_[static_cast<size_t>(triangle)].vertex;
    return {v[static_cast<size_t>(k)], v[static_cast<size_t>((k + 1) % 3)]};
  }
  const Vector3& point(int i) const { return points_[static_cast<size_t>(i)]; }

  double area(int triangle) const {
    const auto& v = triangles_[static_cast<size_t>(triangle)].vertex;
    return (point(v[1]) - point(v[0])).cross(point(v[2]) - point(v[0])).norm();
  }

  bool lies_in_plane(int triangle, const Vector3& normal, double offset) const {
    const auto& v = triangles_[static_cast<size_t>(triangle)].vertex;
    return std::all_of(v.begin(), v.end(),
                       [&](int i) { return std::abs(normal.dot(point(i)) - offset) <= tolerance_; });
  }

  // All triangles connected to `seed` within its plane.
  std::vector<int> grow(int seed) {
    const Vector3 normal = triangles_[static_cast<size_t>(seed)].normal;
    const double offset = normal.dot(point(triangles_[static_cast<size_t>(seed)].vertex[0]));
    std::vector<int> members{seed};
    group_[static_cast<size_t>(seed)] = seed;
    for (size_t i = 0; i < members.size(); ++i) {
      for (int k = 0; k < 3; ++k) {
        const auto [a, b] = edge_of(members[i], k);
        const auto neighbor = owner_.find({b, a});
        if (neighbor == owner_.end()) continue;
        const int t = neighbor->second;
        if (group_[static_cast<size_t>(t)] >= 0 || !lies_in_plane(t, normal, offset)) continue;
        group_[static_cast<size_t>(t)] = seed;
        members.push_back(t);
      }
    }
    return members;
  }

  std::vector<int> boundary(const std::vector<int>& members) const {
    std::map<int, int> next;
    for (const int t : members) {
      for (int k = 0; k < 3; ++k) {
        const auto [a, b] = edge_of(t, k);
        const auto neighbor = owner_.find({b, a});
        const bool inside = neighbor != owner_.end() && group_[static_cast<size_t>(neighbor->second)] ==
                                                            group_[static_cast<size_t>(members.front())];
        if (!inside && !next.emplace(a, b).second) throw std::invalid_argument("a convex hull face touches itself");
      }
    }
    std::vector<int> loop{next.begin()->first};
    for (int v = next.begin()->second; v != loop.front() && loop.size() <= next.size(); v = next.at(v)) {
      loop.push_back(v);
    }
    if (loop.size() != next.size()) throw std::invalid_argument("a convex hull face has a hole");
    return loop;
  }

  std::span<const Vector3> points_;
  std::vector<HullTriangle> triangles_;
  std::vector<int> group_;
  std::map<DirectedEdge, int> owner_;
  double tolerance_ = 0.0;
};

// Vertices met by fewer than three faces lie inside an edge.
void drop_straight_vertices(std::vector<std::vector<int>>& loops) {
  std::map<int, int> faces_at;
  for (const auto& loop : loops) {
    for (const int v : loop) ++faces_at[v];
  }
  for (auto& loop : loops) {
    loop.erase(std::remove_if(loop.begin(), loop.end(), [&](int v) { return faces_at[v] < 3; }), loop.end());
  }
  loops.erase(std::remove_if(loops.begin(), loops.end(), [](const auto& loop) { return loop.size() < 3; }),
              loops.end());
}

void add_vertices_and_faces(std::span<const Vector3> points, const std::vector<std::vector<int>>& loops,
                            Polytope& polytope) {
  std::map<int, int> index;
  for (const auto& loop : loops) {
    for (const int v : loop) index.emplace(v, 0);
  }
  for (auto& [point, vertex] : index) {
    vertex = static_cast<int>(polytope.vertices.size());
    polytope.vertices.push_back(points[static_cast<size_t>(point)]);
    polytope.radius = std::max(polytope.radius, polytope.vertices.back().norm());
  }
  for (const auto& loop : loops) {
    Polytope::Face face;
    face.first = static_cast<int>(polytope.face_vertices.size());
    face.count = static_cast<int>(loop.size());
    const Vector3& origin = points[static_cast<size_t>(loop[0])];
    for (size_t k = 0; k < loop.size(); ++k) {
      const Vector3 a = points[static_cast<size_t>(loop[k])] - origin;
      const Vector3 b = points[static_cast<size_t>(loop[(k + 1) % loop.size()])] - origin;
      face.normal += a.cross(b);
      polytope.face_vertices.push_back(index[loop[k]]);
    }
    face.normal.normalize();
    // The outermost vertex sets the plane, so that the faces enclose every vertex.
    face.offset = face.normal.dot(origin);
    for (const int v : loop) face.offset = std::max(face.offset, face.normal.dot(points[static_cast<size_t>(v)]));
    polytope.faces.push_back(face);
  }
}

void add_edges(Polytope& polytope) {
  std::map<DirectedEdge, int> left;
  for (size_t f = 0; f < polytope.faces.size(); ++f) {
    const auto loop = polytope.vertices_of(polytope.faces[f]);
    for (size_t k = 0; k < loop.size(); ++k) left[{loop[k], loop[(k + 1) % loop.size()]}] = static_cast<int>(f);
  }
  std::vector<std::vector<int>> neighbors(polytope.vertices.size());
  for (const auto& [edge, face] : left) {
    const auto opposite = left.find({edge.second, edge.first});
    if (opposite == left.end()) throw std::invalid_argument("the points of a convex hull do not span a volume");
    neighbors[static_cast<size_t>(edge.first)].push_back(edge.second);
    if (edge.first > edge.second) continue;
    polytope.edges.push_back({{edge.first, edge.second}, {face, opposite->second}});
  }
  polytope.face_neighbors.resize(polytope.face_vertices.size());
  for (const auto& face : polytope.faces) {
    const auto loop = polytope.vertices_of(face);
    for (size_t k = 0; k < loop.size(); ++k) {
      polytope.face_neighbors[static_cast<size_t>(face.first) + k] = left.at({loop[(k + 1) % loop.size()], loop[k]});
    }
  }
  std::vector<std::vector<int>> neighbor_edges(polytope.vertices.size());
  // Both lists of a vertex rise with the other end's index: edges with it as the first end come after all others.
  for (size_t e = 0; e < polytope.edges.size(); ++e) {
    neighbor_edges[static_cast<size_t>(polytope.edges[e].vertex[1])].push_back(static_cast<int>(e));
  }
  for (size_t e = 0; e < polytope.edges.size(); ++e) {
    neighbor_edges[static_cast<size_t>(polytope.edges[e].vertex[0])].push_back(static_cast<int>(e));
  }
  polytope.first_neighbor.push_back(0);
  for (const auto& list : neighbor_edges) {
    polytope.neighbor_edges.insert(polytope.neighbor_edges.end(), list.begin(), list.end());
  }
  for (const auto& list : neighbors) {
    polytope.neighbors.insert(polytope.neighbors.end(), list.begin(), list.end());
    polytope.first_neighbor.push_back(static_cast<int>(polytope.neighbors.size()));
  }
}

void add_centroid(Polytope& polytope) {
  const Vector3& apex = polytope.vertices[0];
  double volume = 0.0;
  Vector3 moment = Vector3::Zero();
  for (const auto& face : polytope.faces) {
    const auto loop = polytope.vertices_of(face);
    const Vector3 a = polytope.vertices[static_cast<size_t>(loop[0])] - apex;
    for (size_t k = 1; k + 1 < loop.size(); ++k) {
      const Vector3 b = polytope.vertices[static_cast<size_t>(loop[k])] - apex;
      const Vector3 c = polytope.vertices[static_cast<size_t>(loop[k + 1])] - apex;
      const double tetrahedron = a.dot(b.cross(c));
      volume += tetrahedron;
      moment += tetrahedron * (a + b + c) / 4.0;
    }
  }
  polytope.centroid = apex + moment / volume;
}

}  // namespace

Polytope convex_hull(std::span<const Vector3> points, double coplanarity) {
  FaceMerger merger(points, hull_triangles(points), coplanarity);
  std::vector<std::vector<int>> loops = merger.loops();
  drop_straight_vertices(loops);
  Polytope polytope;
  if (loops.size() < 4) throw std::invalid_argument("the points of a convex hull do not span a volume");
  add_vertices_and_faces(points, loops, polytope);
  add_edges(polytope);
  add_centroid(polytope);
  return polytope;
}

}  // namespace tegotae
