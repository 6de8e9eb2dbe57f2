// SPDX-License-Identifier: Apache-2.0
#include <tegotae/world/haptic_settings.hpp>

#include <tegotae/world/scene_error.hpp>

#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <cmath>
#include <string_view>

namespace tegotae {

std::vector<HapticSettingInScene> read_haptic_settings(const mjModel_& model, const std::string& file) {
  constexpr std::string_view kPrefix = "tegotae_";
  std::vector<HapticSettingInScene> settings;
  for (int i = 0; i < static_cast<int>(model.nnumeric); ++i) {
    const char* raw_name = mj_id2name(&model, mjOBJ_NUMERIC, i);
    const std::string_view name = raw_name != nullptr ? raw_name : "";
    if (name.substr(0, kPrefix.size()) != kPrefix) continue;
    if (model.numeric_size[i] != 1) {
      throw SceneError(
          fmt::format("{}: the haptic setting '{}' has {} numbers; give it one", file, name, model.numeric_size[i]));
    }
    const double value = model.numeric_data[model.numeric_adr[i]];
    if (!std::isfinite(value)) {
      throw SceneError(fmt::format("{}: the haptic setting '{}' is {}; give a finite number", file, name, value));
    }
    settings.push_back({std::string(name.substr(kPrefix.size())), value});
  }
  return settings;
}

}  // namespace tegotae
