// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/session_settings.hpp>

#include <tegotae/lab/input_error.hpp>
#include <tegotae/lab/numeric_setting.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace tegotae {
namespace {

template <class Value>
std::optional<Value> first_of(const std::optional<Value>& a, const std::optional<Value>& b) {
  return a ? a : b;
}

void check_method(const std::string& name) {
  std::string names;
  for (const MethodName& method : method_names()) {
    if (method.name == name) return;
    names.append(names.empty() ? "" : ", ").append(method.name);
  }
  throw InputError(fmt::format("there is no method '{}'; there are: {}.", name, names));
}

double decided_metric_length(const SettingsRequest& request, const SessionSettings& settings, const Tool& tool) {
  if (request.rotational_stiffness) return std::sqrt(*request.rotational_stiffness / settings.stiffness);
  const double length = request.metric_length.value_or(default_metric_length(settings.method, tool));
  return length == 0.0 ? tool.mass.gyration_length() : length;
}

void decide_interface(const SettingsRequest& request, SessionSettings& settings) {
  WorkspaceSettings& workspace = settings.workspace;
  workspace.translation_scale = request.translation_scale.value_or(workspace.translation_scale);
  workspace.rotation_scale = request.rotation_scale.value_or(workspace.rotation_scale);
  workspace.force_scale = request.force_scale.value_or(workspace.force_scale);
  workspace.clutch_button = static_cast<int>(request.clutch_button.value_or(workspace.clutch_button));
  settings.dead_man_button = static_cast<int>(request.dead_man_button.value_or(settings.dead_man_button));
  if (settings.dead_man_button >= 0 && settings.dead_man_button == workspace.clutch_button) {
    throw InputError(
        fmt::format("button {} cannot both clutch and be the dead-man button: nothing would ever be felt; name two.",
                    settings.dead_man_button));
  }
  settings.energy_bound = request.energy_bound.value_or(1.0) != 0.0;
  settings.beyond_rating = request.beyond_rating.value_or(0.0) != 0.0;
}

std::vector<std::string> interface_lines(const SessionSettings& settings) {
  const WorkspaceSettings& workspace = settings.workspace;
  std::vector<std::string> lines;
  const auto add_scale = [&lines](const char* name, double scale) {
    if (scale != 1.0) lines.push_back(fmt::format("{} scale: {}", name, scale));
  };
  add_scale("translation", workspace.translation_scale);
  add_scale("rotation", workspace.rotation_scale);
  add_scale("force", workspace.force_scale);
  if (workspace.clutch_button >= 0) lines.push_back(fmt::format("clutch button: {}", workspace.clutch_button));
  if (settings.dead_man_button >= 0) lines.push_back(fmt::format("dead-man button: {}", settings.dead_man_button));
  if (!settings.energy_bound) lines.emplace_back("energy bound: off");
  if (settings.beyond_rating) lines.emplace_back("interface's ratings: not applied");
  return lines;
}

}  // namespace

bool has_constraint_set(std::string_view name) noexcept { return name == "paper"; }

void check_fits_method(const SettingsRequest& request) {
  const std::string method = request.method.value_or(SessionSettings{}.method);
  if (request.constraint_set && !has_constraint_set(method)) {
    throw InputError(
        fmt::format("the method '{}' has no choice of constraint set; leave it out or take method 'paper'.", method));
  }
  for (const NumericSetting& setting : numeric_settings()) {
    if (!setting.of_proxy || method == "proxy" || !(request.*setting.field)) continue;
    throw InputError(
        fmt::format("the method '{}' has no {}; leave it out or take method 'proxy'.", method, setting.name));
  }
  if (request.rotational_stiffness && request.metric_length) {
    throw InputError("the rotational stiffness is k l^2: give either it or the metric length l, not both.");
  }
}

SettingsRequest SettingsRequest::or_else(const SettingsRequest& other) const {
  SettingsRequest both;
  both.method = first_of(method, other.method);
  both.constraint_set = first_of(constraint_set, other.constraint_set);
  for (const NumericSetting& setting : numeric_settings()) {
    both.*setting.field = first_of(this->*setting.field, other.*setting.field);
  }
  // Two names of one quantity: who gives the one does not get the other from elsewhere.
  if (metric_length) both.rotational_stiffness.reset();
  if (rotational_stiffness) both.metric_length.reset();
  return both;
}

void check_ranges(const SettingsRequest& request) {
  if (request.method) check_method(*request.method);
  for (const NumericSetting& setting : numeric_settings()) {
    if (request.*setting.field) check_range(setting, *(request.*setting.field));
  }
}

SessionSettings decide_settings(const SettingsRequest& request, const Tool& tool) {
  check_ranges(request);
  SessionSettings settings;
  settings.method = request.method.value_or(settings.method);
  settings.stiffness = request.stiffness.value_or(settings.stiffness);
  settings.damping = request.damping.value_or(settings.damping);
  settings.metric_length = decided_metric_length(request, settings, tool);
  settings.constraint_set = request.constraint_set.value_or(settings.constraint_set);
  settings.haptic_rate = request.haptic_rate.value_or(settings.haptic_rate);
  settings.physics_rate = request.physics_rate.value_or(std::min(settings.physics_rate, settings.haptic_rate));
  settings.margin = request.margin.value_or(settings.margin);
  settings.rotational_damping = request.rotational_damping;
  settings.contact_margin = request.contact_margin.value_or(settings.contact_margin);
  settings.friction = request.friction;
  settings.kinetic_friction = request.kinetic_friction.value_or(settings.kinetic_friction);
  settings.viscous_friction = request.viscous_friction.value_or(settings.viscous_friction);
  settings.tool_weight = request.tool_weight.value_or(0.0) != 0.0;
  settings.tool_inertia = request.tool_inertia.value_or(0.0) != 0.0;
  settings.transient = request.transient.value_or(settings.transient);
  decide_interface(request, settings);
  if (settings.physics_rate > settings.haptic_rate) {
    throw InputError(
        fmt::format("the physics rate of {:g} Hz is above the haptic rate of {:g} Hz; lower the one or "
                    "raise the other.",
                    settings.physics_rate, settings.haptic_rate));
  }
  return settings;
}

RenderingMethod SessionSettings::make_method(const SceneGeometry& geometry) const {
  MethodSettings of_method;
  of_method.stiffness = stiffness;
  of_method.damping = damping;
  of_method.metric_length = metric_length;
  of_method.rotational_damping = rotational_damping;
  of_method.constraint_set = constraint_set;
  of_method.friction = friction;
  of_method.kinetic_friction = kinetic_friction;
  of_method.viscous_friction = viscous_friction;
  of_method.contact_margin = contact_margin;
  of_method.tool_weight = tool_weight;
  of_method.tool_inertia = tool_inertia;
  of_method.gravity = gravity;
  of_method.transient.amplitude = transient;
  return tegotae::make_method(method, of_method, geometry);
}

std::vector<std::string> SessionSettings::lines() const {
  std::vector<std::string> all = {
      fmt::format("method: {}", method),
      fmt::format("stiffness: {} N/m", stiffness),
      fmt::format("damping: {} N s/m", damping),
      fmt::format("metric length: {} m", metric_length),
      fmt::format("physics rate: {} Hz", physics_rate),
      fmt::format("haptic rate: {} Hz", haptic_rate),
      fmt::format("margin: {} m", margin),
  };
  if (rotational_damping) all.push_back(fmt::format("rotational damping: {} N m s/rad", *rotational_damping));
  if (method == "proxy") {
    all.push_back(friction ? fmt::format("friction: {}", *friction) : "friction: the scene's");
    all.push_back(fmt::format("kinetic friction: {} of the static coefficient", kinetic_friction));
    all.push_back(fmt::format("viscous friction: {} N s/m", viscous_friction));
    all.push_back(fmt::format("contact margin: {} m", contact_margin));
    if (tool_weight) all.emplace_back("tool weight: felt");
    if (tool_inertia) all.emplace_back("tool inertia: felt");
    if (transient > 0.0) all.push_back(fmt::format("contact transient: {} N s/m", transient));
  }
  if (has_constraint_set(method)) all.push_back(fmt::format("constraint set: {}", name_of(constraint_set)));
  for (std::string& line : interface_lines(*this)) all.push_back(std::move(line));
  return all;
}

std::string_view name_of(ConstraintSet set) noexcept {
  return set == ConstraintSet::kPenetratingPoints ? "penetrating" : "near";
}

}  // namespace tegotae
