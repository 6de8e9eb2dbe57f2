// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/session_messages.hpp>

#include <tegotae/lab/experiment.hpp>
#include <tegotae/lab/numeric_setting.hpp>

#include <algorithm>
#include <utility>

namespace tegotae {
namespace {

// "metric_length" for people: "Metric length".
std::string label_of(std::string_view name) {
  std::string label(name);
  std::replace(label.begin(), label.end(), '_', ' ');
  if (!label.empty() && label[0] >= 'a' && label[0] <= 'z') label[0] = static_cast<char>(label[0] - 'a' + 'A');
  return label;
}

// All that was decided, as a request has it.
SettingsRequest values_of(const SessionSettings& settings) {
  const double l2 = settings.metric_length * settings.metric_length;
  SettingsRequest values;
  values.stiffness = settings.stiffness;
  values.damping = settings.damping;
  values.metric_length = settings.metric_length;
  values.rotational_stiffness = settings.stiffness * l2;
  values.rotational_damping = settings.rotational_damping.value_or(settings.damping * l2);
  values.physics_rate = settings.physics_rate;
  values.haptic_rate = settings.haptic_rate;
  values.margin = settings.margin;
  values.friction = settings.friction;
  values.kinetic_friction = settings.kinetic_friction;
  values.viscous_friction = settings.viscous_friction;
  values.contact_margin = settings.contact_margin;
  values.tool_weight = settings.tool_weight ? 1.0 : 0.0;
  values.tool_inertia = settings.tool_inertia ? 1.0 : 0.0;
  values.transient = settings.transient;
  values.translation_scale = settings.workspace.translation_scale;
  values.rotation_scale = settings.workspace.rotation_scale;
  values.force_scale = settings.workspace.force_scale;
  if (settings.workspace.clutch_button >= 0) values.clutch_button = settings.workspace.clutch_button;
  if (settings.dead_man_button >= 0) values.dead_man_button = settings.dead_man_button;
  values.energy_bound = settings.energy_bound ? 1.0 : 0.0;
  values.beyond_rating = settings.beyond_rating ? 1.0 : 0.0;
  return values;
}

}  // namespace

std::vector<ShownSetting> shown_settings(const SessionSettings& settings) {
  const SettingsRequest values = values_of(settings);
  std::vector<ShownSetting> shown;
  for (const NumericSetting& setting : numeric_settings()) {
    ShownSetting& one = shown.emplace_back();
    one.name = setting.name;
    one.label = label_of(setting.name);
    one.unit = setting.unit;
    one.value = values.*setting.field;
    one.least = setting.least;
    one.most = setting.most;
    one.zero_too = setting.zero_too;
    one.is_switch = setting.is_switch;
    one.available = !setting.of_proxy || settings.method == "proxy";
  }
  return shown;
}

SceneNames session_names(std::string scene, const SessionSettings& settings) {
  SceneNames names;
  names.name = std::move(scene);
  names.program = "tegotae " TEGOTAE_VERSION;
  names.up = up_axis(settings.gravity);
  for (const Experiment& experiment : experiments()) names.experiments.push_back({experiment.name, experiment.summary});
  for (const MethodName& method : method_names()) {
    names.methods.push_back({std::string(method.name), std::string(method.summary)});
  }
  return names;
}

}  // namespace tegotae
