// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/interface_drivers.hpp>

#include <tegotae/device/force_dimension.hpp>
#include <tegotae/device/openhaptics.hpp>
#include <tegotae/device/spacenav.hpp>
#include <tegotae/device/spidar_driver.hpp>
#include <tegotae/device/virtuose.hpp>

#include <fmt/format.h>

#include <array>

namespace tegotae {

std::span<const InterfaceDriver* const> interface_drivers() {
  static const std::array<const InterfaceDriver*, 5> drivers = {
      &force_dimension_driver(), &openhaptics_driver(), &virtuose_driver(), &spidar_driver(), &spacenav_driver()};
  return drivers;
}

InterfacePresence find_interface(const InterfaceDriver& driver, std::string_view options) {
  if (options.empty() || driver.find_with == nullptr) return driver.find();
  try {
    return driver.find_with(options);
  } catch (const InterfaceError& error) {
    return {"", {}, {}, error.what()};
  }
}

InterfaceRescue rescue_of(const InterfaceDriver& driver, std::string_view options) {
  if (driver.rescue != nullptr) return driver.rescue(options);
  const RescueTime time = driver.silence == nullptr ? RescueTime::kNever : RescueTime::kAfterDeath;
  return {time, std::string(driver.after_a_crash)};
}

InterfaceName parse_interface_name(std::string_view text) {
  const std::size_t colon = text.find(':');
  if (colon == std::string_view::npos) return {std::string(text), ""};
  return {std::string(text.substr(0, colon)), std::string(text.substr(colon + 1))};
}

const InterfaceDriver& find_interface_driver(std::string_view name, std::span<const InterfaceDriver* const> drivers) {
  std::string names;
  for (const InterfaceDriver* driver : drivers) {
    if (driver->name == name) return *driver;
    names += (names.empty() ? "" : ", ") + std::string(driver->name);
  }
  throw InterfaceError(fmt::format("there is no driver '{}'; there are: {}.", name, names));
}

}  // namespace tegotae
