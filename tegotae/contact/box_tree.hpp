// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/shape/bounding_box.hpp>

#include <span>
#include <vector>

namespace tegotae {

/// A bounding-volume hierarchy over boxes that do not move against each other: the pieces of one body, in its frame.
/// Binary, split at the median of the boxes' centres along the longest axis, nodes in depth-first order, so that a walk
/// needs no stack: a node that the query misses is skipped with all below it. Construction allocates; queries do not,
/// and end after at most 2 n - 1 nodes.
class BoxTree {
 public:
  explicit BoxTree(std::span<const BoundingBox> boxes);

  /// Calls `visit(index)` for each box that overlaps `query` (touching included), in the tree's order.
  template <class Visit>
  void visit_overlapping(const BoundingBox& query, const Visit& visit) const {
    for (size_t i = 0; i < nodes_.size();) {
      const Node& node = nodes_[i];
      const bool overlaps = node.box.overlaps(query);
      if (overlaps && node.index >= 0) visit(node.index);
      i = overlaps ? i + 1 : node.next;
    }
  }

  /// Of all boxes together; empty without any.
  BoundingBox bounds() const noexcept { return nodes_.empty() ? BoundingBox{} : nodes_.front().box; }

 private:
  struct Node {
    BoundingBox box;
    size_t next = 0;  ///< the node after all those below this one
    int index = -1;   ///< of the box, at a leaf
  };

  void add(std::span<const BoundingBox> boxes, std::span<int> indices);

  std::vector<Node> nodes_;
};

/// The tightest box, in the axes of the frame A, of a box given in the axes of B. An unbounded box stays so on all
/// sides.
BoundingBox turned_box(const BoundingBox& box_B, const Pose& X_AB) noexcept;

}  // namespace tegotae
