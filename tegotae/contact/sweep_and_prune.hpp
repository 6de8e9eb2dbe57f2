// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/contact/sorted_bounds.hpp>
#include <tegotae/shape/bounding_box.hpp>

#include <span>
#include <vector>

namespace tegotae {

/// Broad phase of one tool against many bodies (Baraff 1992; Cohen et al. 1995): sorted end points of the boxes along
/// each axis, kept from step to step. Static boxes are sorted once; those of moving boxes are repaired by insertion.
/// The query's own end points stay in the sorted lists as positions, and only the end points that they pass on their
/// way to the new bounds are looked at: the cost of a step is that of what changed, and at most linear in the boxes.
/// Boxes may be unbounded (infinite). A box or a query with a bound that is not a number overlaps nothing.
/// For the physics thread: allocates when boxes are added and in the first query after that, else not.
class SweepAndPrune {
 public:
  /// Adds a box and returns its handle (0, 1, 2 ...).
  int add_static(const BoundingBox& box);
  int add_moving(const BoundingBox& box);
  /// New bounds of a moving box. Throws std::invalid_argument if `handle` is not that of a moving box.
  void update(int handle, const BoundingBox& box);
  /// Handles of all boxes that overlap `query` (touching included), ascending, valid until the next call.
  std::span<const int> candidates(const BoundingBox& query);

 private:
  struct Place {
    bool moving;
    int index;  // in its set
  };
  int add(SortedBounds& set, std::vector<int>& handles, const BoundingBox& box, bool moving);

  SortedBounds static_, moving_;
  std::vector<int> static_handles_, moving_handles_;  ///< by index in the set; ascending
  std::vector<Place> places_;                         ///< by handle
  std::vector<int> candidates_;
};

}  // namespace tegotae
