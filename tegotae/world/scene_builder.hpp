// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/model/scene_geometry.hpp>
#include <tegotae/world/tool_body.hpp>

#include <string>
#include <vector>

struct mjModel_;
struct mjData_;

namespace tegotae {

/// The geometry of a compiled scene, and the link back to MuJoCo.
struct BuiltScene {
  SceneGeometry geometry;
  std::vector<int> moving_bodies;  ///< MuJoCo's body of each moving_index
  std::vector<std::string> warnings;
};

/// Builds the shapes of the tool and of every other body with contact geometry, one `Body` for each body of MuJoCo's.
/// Bodies that no joint moves are static, mocap bodies among them, for nothing moves those. `data` holds the poses.
/// Throws SceneError for a tool or a scene without contact geometry, for geometry that cannot be used, and for more
/// than kMaxMovingBodies.
BuiltScene build_scene(const mjModel_& model, const mjData_& data, const ToolBody& tool, const std::string& file);

}  // namespace tegotae
