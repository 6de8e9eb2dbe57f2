// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/shape/bounding_box.hpp>

#include <span>
#include <vector>

namespace tegotae {

/// Broad phase of one tool against many bodies: sorted end points of the boxes along each axis, kept from step to step
/// and repaired by insertion (temporal coherence). Static boxes are sorted once and only searched.
/// For the physics thread: may allocate when boxes are added, not in `candidates` once warm.
class SweepAndPrune {
 public:
  /// Adds a box and returns its handle (0, 1, 2 ...).
  int add_static(const BoundingBox& box);
  int add_moving(const BoundingBox& box);
  /// New bounds of a moving box.
  void update(int handle, const BoundingBox& box);
  /// Handles of all boxes that overlap `query`, ascending, valid until the next call.
  std::span<const int> candidates(const BoundingBox& query);
};

}  // namespace tegotae
