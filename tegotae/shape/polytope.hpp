// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/types.hpp>

#include <span>
#include <vector>

namespace tegotae {

/// A bounded convex polytope with its combinatorial structure, in its own frame. Immutable once made: hulls are
/// shared between bodies and threads. Faces are maximal: coplanar facets are merged.
struct Polytope {
  struct Face {
    Vector3 normal = Vector3::Zero();  ///< unit, outward
    double offset = 0.0;               ///< m: normal . p == offset on the face
    int first = 0;                     ///< into `face_vertices`
    int count = 0;                     ///< vertices, counter-clockwise seen from outside
  };
  struct Edge {
    int vertex[2] = {0, 0};
    int face[2] = {0, 0};  ///< face[0] runs vertex[0] -> vertex[1] counter-clockwise, face[1] the other way
  };

  std::vector<Vector3> vertices;  ///< m, each an extreme point, none twice
  std::vector<Face> faces;
  std::vector<int> face_vertices;
  std::vector<int> face_neighbors;  ///< beside `face_vertices`: the face across the edge from that vertex to the next
  std::vector<Edge> edges;
  std::vector<int> first_neighbor;  ///< size vertices + 1: neighbours of v are neighbors[first_neighbor[v] .. [v + 1])
  std::vector<int> neighbors;
  std::vector<int> neighbor_edges;     ///< beside `neighbors`: the edge to that neighbour
  Vector3 centroid = Vector3::Zero();  ///< of the volume, m; strictly inside
  double radius = 0.0;                 ///< greatest distance of a vertex from the frame's origin, m

  std::span<const int> vertices_of(const Face& face) const noexcept {
    return {face_vertices.data() + face.first, static_cast<size_t>(face.count)};
  }
  std::span<const int> neighbors_of(const Face& face) const noexcept {
    return {face_neighbors.data() + face.first, static_cast<size_t>(face.count)};
  }
  std::span<const int> neighbors_of(int vertex) const noexcept {
    return {neighbors.data() + first_neighbor[vertex],
            static_cast<size_t>(first_neighbor[vertex + 1] - first_neighbor[vertex])};
  }
  std::span<const int> edges_of(int vertex) const noexcept {
    return {neighbor_edges.data() + first_neighbor[vertex],
            static_cast<size_t>(first_neighbor[vertex + 1] - first_neighbor[vertex])};
  }
};

}  // namespace tegotae
