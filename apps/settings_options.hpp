// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/numeric_setting.hpp>
#include <tegotae/lab/session_settings.hpp>

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

namespace tegotae {

/// The options that say how to render, as they stand on the command line.
struct SettingsOptions {
  SettingsRequest request;
  std::optional<std::string> metric_length;
  std::optional<std::string> constraint_set;

  void add_method(CLI::App& command);
  /// All but those of an interface.
  void add_all(CLI::App& command);
  /// Those of an interface and of who holds it.
  void add_interface(CLI::App& command);
  /// For a command without an interface: those options are not in its help, and `why` (a clause) answers them.
  static void refuse_interface(CLI::App& command, const std::string& why);
  /// What keeps an interface stable, to be turned off by name.
  void add_limits(CLI::App& command);

  /// What was asked for. Throws UsageError for names that are not there and values out of range.
  SettingsRequest checked() const;

 private:
  void add_number(CLI::App& command, const NumericSetting& setting);
};

}  // namespace tegotae
