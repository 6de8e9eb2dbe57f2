// SPDX-License-Identifier: Apache-2.0
#include <apps/validators.hpp>

#include <fmt/format.h>

namespace tegotae {

CLI::Validator number_in(const std::string& unit) {
  return CLI::Validator(
      [unit](std::string& text) {
        double value = 0.0;
        if (CLI::detail::lexical_cast(text, value)) return std::string();
        return fmt::format("takes a number{}{}, not '{}'", unit.empty() ? "" : " in ", unit, text);
      },
      "");
}

CLI::Validator not_empty(const std::string& what) {
  return CLI::Validator(
      [what](std::string& text) { return text.empty() ? fmt::format("takes {}, not ''", what) : std::string(); }, "");
}

}  // namespace tegotae
