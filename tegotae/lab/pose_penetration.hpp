// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/contact/closest_points.hpp>
#include <tegotae/model/scene_geometry.hpp>
#include <tegotae/shape/bounding_box.hpp>

#include <vector>

namespace tegotae {

/// How deep the tool stands in a scene. Bodies that move are left out, as a record of a tick does not hold their
/// poses. Refers to the scene.
class PosePenetration {
 public:
  explicit PosePenetration(const SceneGeometry& scene);

  /// The greatest depth (m) of any pair of a tool piece and a piece of a static body that may touch, with the tool at
  /// `X_WT`: the least translation that parts the pair (contact/penetration.hpp). 0: all pairs are apart, as certified
  /// distances show. A lower bound of what parts the bodies where several pieces overlap. Infinite for a pose that is
  /// not finite. Does not allocate.
  double at(const Pose& X_WT) noexcept;

 private:
  struct Pair {
    const Shape* tool;
    PlacedShape object;
    BoundingBox box;  // of the object
    ClosestPointsCache cache;
  };
  std::vector<Pair> pairs_;
};

}  // namespace tegotae
