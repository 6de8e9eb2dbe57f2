// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/pose_penetration.hpp>

#include <tegotae/contact/penetration.hpp>

#include <algorithm>
#include <limits>

namespace tegotae {

PosePenetration::PosePenetration(const SceneGeometry& scene) {
  for (const Shape& piece : scene.tool.pieces) {
    for (const Body& body : scene.bodies) {
      if (body.moving_index >= 0) continue;
      for (const Shape& object : body.pieces) {
        if (may_touch(piece, object))
          pairs_.push_back({&piece, {object, body.X_WB}, bounding_box(object, body.X_WB), {}});
      }
    }
  }
}

double PosePenetration::at(const Pose& X_WT) noexcept {
  if (!X_WT.is_finite()) return std::numeric_limits<double>::infinity();
  double deepest = 0.0;
  const Shape* placed = nullptr;
  PlacedShape tool;
  BoundingBox box;
  for (Pair& pair : pairs_) {
    if (pair.tool != placed) {
      placed = pair.tool;
      tool = PlacedShape(*placed, X_WT);
      box = bounding_box(*placed, X_WT);
    }
    if (!box.overlaps(pair.box)) continue;
    if (closest_points(tool, pair.object, pair.cache).separation == Separation::kSeparated) continue;
    const Penetration found = penetration(tool, pair.object, pair.cache);
    if (found.valid) deepest = std::max(deepest, found.depth);
  }
  return deepest;
}

}  // namespace tegotae
