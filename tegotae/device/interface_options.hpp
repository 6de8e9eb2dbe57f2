// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>

namespace tegotae {

/// What follows a driver's name and colon: `VALUE,NAME=VALUE,...`, everything optional. Throws InterfaceError, with a
/// sentence that begins with the driver's name, for what is no such thing.
class InterfaceOptions {
 public:
  InterfaceOptions(std::string_view driver, std::string_view text);

  /// The value without a name; empty: none.
  const std::string& value() const noexcept { return value_; }
  /// The named value as text, one of `allowed` (separated by '|') unless that is empty.
  std::optional<std::string> text(const std::string& name, std::string_view allowed = {});
  /// The named value as a number from `least` to `most`.
  std::optional<double> number(const std::string& name, double least, double most);
  /// To be called after everything was asked for: refuses names that were not.
  void refuse_others() const;

 private:
  std::string driver_, value_;
  std::map<std::string, std::string> named_;
  std::set<std::string> asked_for_;
};

}  // namespace tegotae
