// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/shape/polytope.hpp>

#include <cstdint>
#include <vector>

namespace tegotae {

/// The vertices and edges of a polytope after each of its face planes, of outward normal n, moved outward by
/// max(0, n . dilation). No face vanishes. A vertex whose faces all look along the way moves with it, and one whose
/// faces all look away stays; their edges stay what they are. Only along the rim between the two may neighbours change:
/// a vertex of more than three faces parts into several, and an edge may shrink to nothing. Where that happens the
/// polytope is not `intact`: faces of the rim are `broken`, and of their edges and vertices nothing is told. Fixed
/// memory.
class ClipDilation {
 public:
  /// Allocates; nothing else does.
  ClipDilation(int max_vertices, int max_faces);

  void apply(const Polytope& polytope, const Vector3& dilation) noexcept;

  bool intact() const noexcept { return intact_; }
  bool is_broken(int face) const noexcept { return broken_[static_cast<size_t>(face)] != 0; }
  bool has_vertex(size_t vertex) const noexcept { return intact_ || way_[vertex] != kBoth; }
  const Vector3& point(size_t vertex) const noexcept { return points_[vertex]; }

 private:
  static constexpr std::uint8_t kAway = 1, kAlong = 2, kBoth = 3;

  void find_ways(const Polytope& polytope, const Vector3& dilation) noexcept;
  bool move_vertices(const Polytope& polytope, const Vector3& dilation) noexcept;
  bool keeps_edges(const Polytope& polytope) const noexcept;
  void mark_broken(const Polytope& polytope) noexcept;

  bool intact_ = true;
  std::vector<Vector3> points_;    ///< m
  std::vector<std::uint8_t> way_;  ///< which ways the faces of each vertex look
  std::vector<int> vertex_faces_;  ///< three faces of each vertex
  std::vector<std::uint8_t> broken_;
};

}  // namespace tegotae
