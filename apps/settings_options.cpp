// SPDX-License-Identifier: Apache-2.0
#include <apps/commands.hpp>
#include <apps/settings_options.hpp>
#include <apps/validators.hpp>
#include <tegotae/lab/input_error.hpp>
#include <tegotae/lab/numeric_setting.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string>
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

double parse_switch(const std::string& option, const std::string& text) {
  if (text == "on" || text == "1") return 1.0;
  if (text == "off" || text == "0") return 0.0;
  throw UsageError(fmt::format("{} takes 'on' or 'off', not '{}'.", option, text));
}

ConstraintSet parse_constraint_set(const std::string& text) {
  for (const ConstraintSet set : {ConstraintSet::kPenetratingPoints, ConstraintSet::kNearPoints}) {
    if (text == name_of(set)) return set;
  }
  throw UsageError(fmt::format("--constraint-set takes 'penetrating' or 'near', not '{}'.", text));
}

std::string option_of(const NumericSetting& setting) {
  std::string name = fmt::format("--{}", setting.name);
  std::replace(name.begin(), name.end(), '_', '-');
  return name;
}

}  // namespace

void SettingsOptions::add_method(CLI::App& command) {
  command.add_option("--method", request.method, "Rendering method (see 'tegotae methods'); default: proxy")
      ->type_name("NAME");
}

void SettingsOptions::add_number(CLI::App& command, const NumericSetting& setting) {
  const std::string name = option_of(setting);
  const std::string summary(setting.summary);
  std::optional<double>& value = request.*setting.field;
  if (setting.is_switch) {
    const auto take = [&value, name](const std::string& text) { value = parse_switch(name, text); };
    command.add_option_function<std::string>(name, take, setting.of_proxy ? summary + "; of 'proxy'" : summary)
        ->type_name("on|off");
    return;
  }
  if (setting.field == &SettingsRequest::metric_length) {
    command.add_option(name, metric_length, summary)->type_name("m|gyration");
    return;
  }
  const std::string unit(setting.unit.empty() ? "NUMBER" : setting.unit);
  command.add_option(name, value, setting.of_proxy ? summary + "; of 'proxy'" : summary)
      ->type_name(unit)
      ->check(number_in(setting.unit.empty() ? "" : unit));
}

void SettingsOptions::add_interface(CLI::App& command) {
  for (const NumericSetting& setting : numeric_settings()) {
    if (setting.of_interface) add_number(command, setting);
  }
}

void SettingsOptions::refuse_interface(CLI::App& command, const std::string& why) {
  for (const NumericSetting& setting : numeric_settings()) {
    if (!setting.of_interface) continue;
    const std::string name = option_of(setting);
    const auto refuse = [name, why](const CLI::results_t&) -> bool {
      throw UsageError(fmt::format("{} is of an interface in a hand, and {}; leave it out.", name, why));
    };
    command.add_option(name, refuse)->expected(0, 1)->group("");
  }
}

void SettingsOptions::add_limits(CLI::App& command) {
  for (const NumericSetting& setting : numeric_settings()) {
    if (setting.field == &SettingsRequest::energy_bound || setting.field == &SettingsRequest::beyond_rating) {
      add_number(command, setting);
    }
  }
}

void SettingsOptions::add_all(CLI::App& command) {
  add_method(command);
  for (const NumericSetting& setting : numeric_settings()) {
    if (!setting.of_interface) add_number(command, setting);
  }
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
    check_fits_method(wanted);
  } catch (const InputError& error) {
    throw UsageError(error.what());
  }
  return wanted;
}

}  // namespace tegotae
