// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/session_settings.hpp>

#include <optional>
#include <span>
#include <string_view>

namespace tegotae {

/// A number that a command line may set, as "--" and its name with dashes, and most of them a scene in <custom>, as
/// "tegotae_" and its name.
struct NumericSetting {
  std::string_view name;  ///< "physics_rate"
  std::optional<double> SettingsRequest::*field;
  double least, most;  ///< beyond these a value is a slip of the pen
  std::string_view unit;
  bool zero_too;             ///< 0 is permitted, though below `least`
  bool of_proxy;             ///< no other method has it
  bool is_switch;            ///< 0 or 1, nothing between
  std::string_view summary;  ///< for help texts
  /// Of the interface and of who holds it: the command line sets it, neither a scene nor a page.
  bool of_interface = false;
  bool is_whole = false;  ///< a whole number
};

/// All of them.
std::span<const NumericSetting> numeric_settings() noexcept;

/// Throws InputError, with the range permitted, where `value` is out of it.
void check_range(const NumericSetting& setting, double value);

}  // namespace tegotae
