// SPDX-License-Identifier: Apache-2.0
#include <tegotae/world/haptic_settings.hpp>
#include <tegotae/world/scene_error.hpp>

#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <array>
#include <cmath>
#include <string_view>

namespace tegotae {
namespace {

struct Setting {
  std::string_view name;
  std::optional<double> HapticSettingsInScene::*field;
  bool may_be_zero;
  std::string_view unit;
};

constexpr std::string_view kPrefix = "tegotae_";
constexpr std::array<Setting, 6> kSettings = {{
    {"tegotae_stiffness", &HapticSettingsInScene::stiffness, false, "N/m"},
    {"tegotae_damping", &HapticSettingsInScene::damping, true, "N s/m"},
    {"tegotae_metric_length", &HapticSettingsInScene::metric_length, true, "m"},
    {"tegotae_margin", &HapticSettingsInScene::margin, false, "m"},
    {"tegotae_physics_rate", &HapticSettingsInScene::physics_rate, false, "Hz"},
    {"tegotae_haptic_rate", &HapticSettingsInScene::haptic_rate, false, "Hz"},
}};

const Setting& setting_named(std::string_view name, const std::string& file) {
  std::string known;
  for (const Setting& setting : kSettings) {
    if (setting.name == name) return setting;
    known += fmt::format("{}{}", known.empty() ? "" : ", ", setting.name);
  }
  throw SceneError(fmt::format("{}: unknown haptic setting '{}' in <custom>; known are {}", file, name, known));
}

}  // namespace

HapticSettingsInScene read_haptic_settings(const mjModel_& model, const std::string& file) {
  HapticSettingsInScene settings;
  for (int i = 0; i < static_cast<int>(model.nnumeric); ++i) {
    const char* raw_name = mj_id2name(&model, mjOBJ_NUMERIC, i);
    const std::string_view name = raw_name != nullptr ? raw_name : "";
    if (name.substr(0, kPrefix.size()) != kPrefix) continue;
    const Setting& setting = setting_named(name, file);
    if (model.numeric_size[i] != 1) {
      throw SceneError(fmt::format("{}: the haptic setting '{}' has {} numbers; give it one, in {}", file, name,
                                   model.numeric_size[i], setting.unit));
    }
    const double value = model.numeric_data[model.numeric_adr[i]];
    if (!std::isfinite(value) || value < 0.0 || (value == 0.0 && !setting.may_be_zero)) {
      throw SceneError(fmt::format("{}: the haptic setting '{}' is {} {}; give a {} number", file, name, value,
                                   setting.unit, setting.may_be_zero ? "positive or zero" : "positive"));
    }
    settings.*(setting.field) = value;
  }
  return settings;
}

}  // namespace tegotae
