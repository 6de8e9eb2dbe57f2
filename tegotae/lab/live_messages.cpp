// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/live_messages.hpp>

#include <tegotae/lab/experiment.hpp>
#include <tegotae/lab/free_body_stiffness.hpp>
#include <tegotae/lab/input_error.hpp>
#include <tegotae/lab/numeric_setting.hpp>
#include <tegotae/lab/scene_file.hpp>
#include <tegotae/lab/scripted_motion.hpp>
#include <tegotae/lab/session_messages.hpp>
#include <tegotae/stream/scene_message.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <system_error>

namespace tegotae {
namespace {

// What a page cannot change: set when the program starts, or another name of the metric length.
bool is_fixed(const ShownSetting& setting) {
  const auto known = numeric_settings();
  const auto same = [&setting](const NumericSetting& one) { return one.name == setting.name; };
  const auto found = std::find_if(known.begin(), known.end(), same);
  if (found != known.end() && found->of_interface) return true;
  return setting.name == "haptic_rate" || setting.name == "rotational_stiffness";
}

// The interface's ratings in the world's units; none where they are not applied.
InterfaceCapability bounds_of(const InterfaceCapability& rated, const SessionSettings& settings) {
  if (settings.beyond_rating) return {};
  InterfaceCapability bounds = rated;
  bounds.max_stiffness /= settings.workspace.felt_stiffness(1.0);
  bounds.max_damping /= settings.workspace.felt_stiffness(1.0);
  bounds.max_rotational_damping /= settings.workspace.felt_rotational_stiffness(1.0);
  return bounds;
}

}  // namespace

std::string live_settings_message(const LiveRun& run) {
  std::vector<ShownSetting> shown = shown_settings(run.settings());
  const InterfaceCapability interface = bounds_of(run.interface(), run.settings());
  const CouplingLimits limits = coupling_limits_for_bodies(run.geometry(), run.settings().physics_rate);
  shown.erase(std::remove_if(shown.begin(), shown.end(), is_fixed), shown.end());
  for (ShownSetting& setting : shown) {
    if (setting.name == "stiffness") {
      setting.most = std::min({setting.most, interface.max_stiffness, limits.stiffness});
    }
    if (setting.name == "damping") setting.most = std::min({setting.most, interface.max_damping, limits.damping});
    if (setting.name == "rotational_damping") setting.most = std::min(setting.most, interface.max_rotational_damping);
    if (setting.name == "transient") setting.most = std::min(setting.most, interface.max_damping);
    if (setting.name == "physics_rate") setting.most = std::min(setting.most, run.highest_physics_rate());
  }
  return encode_settings(run.settings().method, shown);
}

std::string live_scene_message(const LiveRun& run, std::span<const LiveScene> scenes) {
  SceneNames names = session_names(run.scene().name, run.settings());
  for (const LiveScene& scene : scenes) names.scenes.push_back(scene.name);
  if (run.has_device()) {
    // A person moves it: nothing is played.
    names.interface = run.interface().name;
    names.experiments.clear();
    return encode_scene(run.geometry(), names);
  }
  for (const ScriptedMotion& motion : scripted_motions()) {
    names.motions.push_back({std::string(motion.name), std::string(motion.summary)});
  }
  return encode_scene(run.geometry(), names);
}

std::vector<LiveScene> shipped_scenes() {
  std::vector<LiveScene> scenes;
  std::error_code error;
  for (const auto& entry : std::filesystem::directory_iterator(find_scene("table.xml").parent_path(), error)) {
    if (entry.path().extension() == ".xml") scenes.push_back({entry.path().stem().string(), entry.path()});
  }
  std::sort(scenes.begin(), scenes.end(), [](const LiveScene& a, const LiveScene& b) { return a.name < b.name; });
  return scenes;
}

const LiveScene& find_live_scene(std::span<const LiveScene> scenes, std::string_view name) {
  std::string names;
  for (const LiveScene& scene : scenes) {
    if (scene.name == name) return scene;
    names.append(names.empty() ? "" : ", ").append(scene.name);
  }
  throw InputError(fmt::format("there is no scene '{}'; there are: {}.", name, names));
}

LiveScene live_scene_of(const Experiment& experiment) {
  return {experiment.name, find_scene(experiment.scene), experiment.tool, &experiment};
}

}  // namespace tegotae
