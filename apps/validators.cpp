// SPDX-License-Identifier: Apache-2.0
#include <apps/validators.hpp>

#include <fmt/format.h>

#include <charconv>
#include <system_error>

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

CLI::Validator whole_number(const std::string& what, long least, long most) {
  return CLI::Validator(
      [=](std::string& text) {
        long value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        const bool is_number = error == std::errc() && end == text.data() + text.size();
        if (is_number && value >= least && value <= most) return std::string();
        return fmt::format("takes a {} from {} to {}, not '{}'", what, least, most, text);
      },
      "");
}

CLI::Validator not_empty(const std::string& what) {
  return CLI::Validator(
      [what](std::string& text) { return text.empty() ? fmt::format("takes {}, not ''", what) : std::string(); }, "");
}

}  // namespace tegotae
