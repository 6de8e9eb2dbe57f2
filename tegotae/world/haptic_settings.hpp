// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

struct mjModel_;

namespace tegotae {

/// A haptic setting that a scene holds, as `<custom><numeric name="tegotae_stiffness" data="9000"/></custom>`. Which
/// names there are, and their ranges, is for whoever renders to say (lab/numeric_setting.hpp).
struct HapticSettingInScene {
  std::string name;  ///< without the prefix: "stiffness"
  double value = 0.0;
};

/// The settings of a compiled scene, in its order. Throws SceneError for a `tegotae_` numeric that is not one finite
/// number. `file` is for the message.
std::vector<HapticSettingInScene> read_haptic_settings(const mjModel_& model, const std::string& file);

}  // namespace tegotae
