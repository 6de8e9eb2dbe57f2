// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/shape/mass_properties.hpp>

#include <string>
#include <vector>

struct mjModel_;

namespace tegotae {

/// The tool in a compiled scene: a body without joints, and its descendants.
struct ToolBody {
  int id = 0;
  std::vector<int> bodies;   ///< the tool's body first, then its descendants in MuJoCo's order
  std::vector<Pose> X_TB;    ///< poses of `bodies` on the tool
  std::vector<int> part_of;  ///< for every body of the scene: its place in `bodies`, or -1

  bool has_body(int body) const { return part_of[static_cast<size_t>(body)] >= 0; }
};

/// Finds the tool by name. Throws SceneError where there is no such body; where a joint would let MuJoCo move it or a
/// part of it; and where an equality constraint or a tendon holds it: the hand would not feel their force.
ToolBody find_tool_body(const mjModel_& model, const std::string& name, const std::string& file);

/// Mass of all the tool's bodies as the scene gives it, in the tool's frame; a mass of 0 where the scene gives none.
MassProperties tool_mass(const mjModel_& model, const ToolBody& tool);

}  // namespace tegotae
