// SPDX-License-Identifier: Apache-2.0
#include <apps/commands.hpp>
#include <apps/settings_options.hpp>
#include <apps/validators.hpp>
#include <tegotae/lab/input_error.hpp>

#include <fmt/format.h>

#include <charconv>
#include <system_error>

namespace tegotae {
namespace {

double parse_metric_length(const std::string& text) {
  if (text == "gyration") return 0.0;
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error == std::errc() && end == text.data() + text.size() && value != 0.0) return value;
  throw UsageError(
      fmt::format("--metric-length takes a length in m above 0, or 'gyration' for the tool's gyration "
                  "length, not '{}'.",
                  text));
}

ConstraintSet parse_constraint_set(const std::string& text) {
  for (const ConstraintSet set : {ConstraintSet::kPenetratingPoints, ConstraintSet::kNearPoints}) {
    if (text == name_of(set)) return set;
  }
  throw UsageError(fmt::format("--constraint-set takes 'penetrating' or 'near', not '{}'.", text));
}

}  // namespace

void SettingsOptions::add_method(CLI::App& command) {
  command.add_option("--method", request.method, "Rendering method (see 'tegotae methods'); default: paper")
      ->type_name("NAME");
}

void SettingsOptions::add_all(CLI::App& command) {
  add_method(command);
  command.add_option("--stiffness", request.stiffness, "Stiffness k of the coupling; default: the scene's, else 1000")
      ->type_name("N/m")
      ->check(number_in("N/m"));
  command.add_option("--damping", request.damping, "Damping d of the coupling; default: the scene's, else 0")
      ->type_name("N*s/m")
      ->check(number_in("N*s/m"));
  command
      .add_option("--metric-length", metric_length,
                  "Length l that weighs rotation against translation, or 'gyration' for the tool's gyration length; "
                  "default: the scene's, else the method's (paper: 1)")
      ->type_name("m|gyration");
  command
      .add_option("--physics-rate", request.physics_rate, "Rate of the physics steps; default: the scene's, else 500")
      ->type_name("Hz")
      ->check(number_in("Hz"));
  command.add_option("--haptic-rate", request.haptic_rate, "Rate of the haptic ticks; default: the scene's, else 1000")
      ->type_name("Hz")
      ->check(number_in("Hz"));
  command
      .add_option("--margin", request.margin,
                  "Distance below which objects are near, beyond what the speeds ask for; default: the scene's, else "
                  "0.002")
      ->type_name("m")
      ->check(number_in("m"));
  command
      .add_option("--constraint-set", constraint_set,
                  "Contact points that constrain the tool: 'penetrating' (the paper) or all 'near' ones; "
                  "default: penetrating; only 'paper' has the choice")
      ->type_name("NAME");
}

SettingsRequest SettingsOptions::checked() const {
  SettingsRequest wanted = request;
  if (metric_length) wanted.metric_length = parse_metric_length(*metric_length);
  if (constraint_set) wanted.constraint_set = parse_constraint_set(*constraint_set);
  try {
    check_ranges(wanted);
  } catch (const InputError& error) {
    throw UsageError(error.what());
  }
  return wanted;
}

}  // namespace tegotae
