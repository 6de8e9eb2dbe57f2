// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/interface_options.hpp>

#include <tegotae/device/interface_driver.hpp>

#include <charconv>

namespace tegotae {
namespace {

// The part up to the next separator, which is taken off `rest` with it.
std::string_view next_option_part(std::string_view& rest, char separator) {
  const std::size_t end = rest.find(separator);
  const std::string_view part = rest.substr(0, end);
  rest = end == std::string_view::npos ? std::string_view{} : rest.substr(end + 1);
  return part;
}

bool is_among(std::string_view text, std::string_view allowed) {
  while (!allowed.empty()) {
    if (next_option_part(allowed, '|') == text) return true;
  }
  return false;
}

std::string shown_number(double value) {
  std::string text = std::to_string(value);
  text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

}  // namespace

InterfaceOptions::InterfaceOptions(std::string_view driver, std::string_view text) : driver_(driver) {
  bool is_first = true;
  while (!text.empty()) {
    std::string_view value = next_option_part(text, ',');
    const bool is_named = value.find('=') != std::string_view::npos;
    if (!is_named) {
      if (!is_first) throw InterfaceError(driver_ + ": '" + std::string(value) + "' has no name; write NAME=VALUE.");
      value_ = value;
    } else {
      const std::string name(next_option_part(value, '='));
      if (!named_.emplace(name, value).second) throw InterfaceError(driver_ + ": '" + name + "' is given twice.");
    }
    is_first = false;
  }
}

std::optional<std::string> InterfaceOptions::text(const std::string& name, std::string_view allowed) {
  asked_for_.insert(name);
  const auto found = named_.find(name);
  if (found == named_.end()) return std::nullopt;
  if (!allowed.empty() && !is_among(found->second, allowed)) {
    throw InterfaceError(driver_ + ": " + name + "=" + found->second + " is none of " + std::string(allowed) + ".");
  }
  return found->second;
}

std::optional<double> InterfaceOptions::number(const std::string& name, double least, double most) {
  const std::optional<std::string> given = text(name);
  if (!given) return std::nullopt;
  double value = 0.0;
  const char* end = given->data() + given->size();
  const auto [stop, error] = std::from_chars(given->data(), end, value);
  if (error != std::errc() || stop != end || !(value >= least && value <= most)) {
    throw InterfaceError(driver_ + ": " + name + "=" + *given + " is no number from " + shown_number(least) + " to " +
                         shown_number(most) + ".");
  }
  return value;
}

void InterfaceOptions::refuse_others() const {
  std::string known;
  for (const std::string& name : asked_for_) known.append(known.empty() ? "" : ", ").append(name);
  for (const auto& [name, value] : named_) {
    if (asked_for_.count(name) == 1) continue;
    throw InterfaceError(std::string(driver_).append(": there is no option '").append(name).append("'; there are: ") +
                         known + ".");
  }
}

}  // namespace tegotae
