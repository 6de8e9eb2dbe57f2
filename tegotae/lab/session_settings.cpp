// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/input_error.hpp>
#include <tegotae/lab/session_settings.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tegotae {
namespace {

template <class Value>
std::optional<Value> first_of(const std::optional<Value>& a, const std::optional<Value>& b) {
  return a ? a : b;
}

// Ranges beyond which a value is a slip of the pen. Rates: below, nothing is felt as firm; above, no interface is
// served. Margin: from a rounding error to the size of a room.
void check(std::string_view what, const std::optional<double>& value, double least, double most,
           std::string_view unit) {
  if (!value || (std::isfinite(*value) && *value >= least && *value <= most)) return;
  throw InputError(fmt::format("the {} of {:g} {} is out of range; permitted are {:g} to {:g} {}.", what, *value, unit,
                               least, most, unit));
}

void check_method(const std::string& name) {
  std::string names;
  for (const MethodName& method : method_names()) {
    if (method.name == name) return;
    names.append(names.empty() ? "" : ", ").append(method.name);
  }
  throw InputError(fmt::format("there is no method '{}'; there are: {}.", name, names));
}

void check_constraint_set(const SettingsRequest& request) {
  const std::string method = request.method.value_or(SessionSettings{}.method);
  if (!request.constraint_set || has_constraint_set(method)) return;
  throw InputError(
      fmt::format("the method '{}' has no choice of constraint set; leave it out or take method 'paper'.", method));
}

}  // namespace

bool has_constraint_set(std::string_view name) noexcept { return name == "paper"; }

SettingsRequest SettingsRequest::or_else(const SettingsRequest& other) const {
  SettingsRequest both;
  both.method = first_of(method, other.method);
  both.stiffness = first_of(stiffness, other.stiffness);
  both.damping = first_of(damping, other.damping);
  both.metric_length = first_of(metric_length, other.metric_length);
  both.constraint_set = first_of(constraint_set, other.constraint_set);
  both.physics_rate = first_of(physics_rate, other.physics_rate);
  both.haptic_rate = first_of(haptic_rate, other.haptic_rate);
  both.margin = first_of(margin, other.margin);
  return both;
}

void check_ranges(const SettingsRequest& request) {
  if (request.method) check_method(*request.method);
  check_constraint_set(request);
  check("stiffness", request.stiffness, 1e-3, 1e6, "N/m");
  check("damping", request.damping, 0.0, 1e4, "N s/m");
  if (request.metric_length != 0.0) check("metric length", request.metric_length, 1e-6, 1e3, "m");
  check("physics rate", request.physics_rate, 1.0, 2000.0, "Hz");
  check("haptic rate", request.haptic_rate, 10.0, 20000.0, "Hz");
  check("margin", request.margin, 1e-6, 10.0, "m");
}

SessionSettings decide_settings(const SettingsRequest& request, const Tool& tool) {
  check_ranges(request);
  SessionSettings settings;
  settings.method = request.method.value_or(settings.method);
  settings.stiffness = request.stiffness.value_or(settings.stiffness);
  settings.damping = request.damping.value_or(settings.damping);
  settings.metric_length = request.metric_length.value_or(default_metric_length(settings.method, tool));
  if (settings.metric_length == 0.0) settings.metric_length = tool.mass.gyration_length();
  settings.constraint_set = request.constraint_set.value_or(settings.constraint_set);
  settings.haptic_rate = request.haptic_rate.value_or(settings.haptic_rate);
  settings.physics_rate = request.physics_rate.value_or(std::min(settings.physics_rate, settings.haptic_rate));
  settings.margin = request.margin.value_or(settings.margin);
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
  of_method.constraint_set = constraint_set;
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
  if (has_constraint_set(method)) all.push_back(fmt::format("constraint set: {}", name_of(constraint_set)));
  return all;
}

std::string_view name_of(ConstraintSet set) noexcept {
  return set == ConstraintSet::kPenetratingPoints ? "penetrating" : "near";
}

}  // namespace tegotae
