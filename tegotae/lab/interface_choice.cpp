// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/interface_choice.hpp>

#include <tegotae/device/simulated_presets.hpp>
#include <tegotae/device/spidar_file.hpp>
#include <tegotae/device/spidar_presets.hpp>
#include <tegotae/device/spidar_reach.hpp>
#include <tegotae/lab/input_error.hpp>
#include <tegotae/lab/stiffness_bounds.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <stdexcept>
#include <utility>

namespace tegotae {
namespace {

constexpr std::string_view kSimulated = "simulated", kSpidar = "spidar-g6";

// Of "x3r,simulated": "x3r".
std::string_view without_last_word(std::string_view options) { return options.substr(0, options.rfind(',')); }

std::string_view last_word(std::string_view options) {
  const size_t comma = options.rfind(',');
  return comma == std::string_view::npos ? std::string_view() : options.substr(comma + 1);
}

// Of those that can be used.
std::string preset_names() {
  std::string names;
  for (const SpidarPreset& preset : spidar_presets()) {
    if (preset.is_refused) continue;
    names.append(names.empty() ? "" : ", ").append(preset.name);
  }
  return names;
}

// What is not simulated, or not there.
[[noreturn]] void refuse(const InterfaceName& name) {
  const std::string full = name.options.empty() ? name.driver : fmt::format("{}:{}", name.driver, name.options);
  for (const InterfaceDriver* driver : interface_drivers()) {
    if (driver->name != name.driver) continue;
    if (driver->name == kSpidar) {
      throw InputError(fmt::format(
          "'{}' is not simulated, and an experiment plays its motion in a simulated hand: give spidar-g6:{},{}.", full,
          name.options.empty() ? "x3r" : name.options.substr(0, name.options.find(',')), kSimulated));
    }
    throw InputError(fmt::format("'{}' is not simulated; there are: {}.", full, simulated_interface_names()));
  }
  throw InputError(
      fmt::format("there is no simulated interface '{}'; there are: {}.", full, simulated_interface_names()));
}

SimulatedChoice find_device(const InterfaceName& name) {
  try {
    return {fmt::format("simulated:{}", name.options), simulated_device(name.options)};
  } catch (const std::invalid_argument&) {
    refuse(name);
  }
}

SimulatedChoice find_spidar(const InterfaceName& name) {
  SpidarGeometry geometry = spidar_geometry_of(without_last_word(name.options));
  try {
    check_force_closure(geometry);
  } catch (const std::invalid_argument& error) {
    throw InputError(error.what());
  }
  return {fmt::format("{}:{}", name.driver, name.options), std::move(geometry)};
}

}  // namespace

std::string simulated_interface_names() {
  std::string names;
  for (const auto& preset : simulated_devices()) names += fmt::format("{}:{}, ", kSimulated, preset.name);
  return names + fmt::format("{}:PRESET,{} and {}:FILE,{} (presets: {})", kSpidar, kSimulated, kSpidar, kSimulated,
                             preset_names());
}

bool is_simulated(const InterfaceName& name) noexcept {
  return name.driver == kSimulated || last_word(name.options) == kSimulated;
}

SimulatedChoice find_simulated(const InterfaceName& name) {
  if (name.driver == kSimulated) return find_device(name);
  if (name.driver == kSpidar && is_simulated(name)) return find_spidar(name);
  refuse(name);
}

std::string file_name_of(const SimulatedChoice& choice) {
  std::string name = choice.name;
  const size_t folder = name.find(':') + 1, file = name.rfind('/') + 1;
  if (file > folder) name.erase(folder, file - folder);
  std::replace_if(
      name.begin(), name.end(), [](unsigned char c) { return std::isalnum(c) == 0 && c != '_' && c != '.'; }, '-');
  return name;
}

InterfaceCapability capability_in_hand(const SimulatedChoice& choice, const HandImpedance& hand, double period) {
  constexpr double kPartOfBound = 0.9;  // at the bound itself a touch rings for long
  StiffnessBoundInput input;
  input.hand = hand;
  input.period = period;
  if (const auto* device = std::get_if<SimulatedDevice>(&choice.model)) {
    input.device = *device;
  } else {
    const auto& geometry = std::get<SpidarGeometry>(choice.model);
    const SpidarReach reach = spidar_reach(geometry, {});
    input.device.capability.max_force = reach.force;
    input.device.capability.max_torque = reach.torque;
    input.device.mechanics = SimulatedSpidarSettings{}.mechanics;
  }
  const StiffnessBounds bounds = stiffness_bounds(input);
  InterfaceCapability result = input.device.capability;
  result.max_stiffness = std::min(result.max_stiffness, kPartOfBound * bounds.linear_translation);
  result.max_rotational_stiffness = std::min(result.max_rotational_stiffness, kPartOfBound * bounds.linear_rotation);
  return result;
}

SpidarGeometry spidar_geometry_of(std::string_view preset_or_file) {
  try {
    return find_spidar_geometry(preset_or_file);
  } catch (const SpidarFileError& error) {
    throw InputError(error.what());
  }
}

std::unique_ptr<ObservedInterface> make_simulated(const SimulatedChoice& choice, const HandImpedance& hand,
                                                  std::unique_ptr<IntendedMotion> intended, const SpidarPlace& place) {
  if (const auto* device = std::get_if<SimulatedDevice>(&choice.model)) {
    return observed_device(*device, hand, std::move(intended));
  }
  SpidarSettings settings;
  settings.geometry = std::get<SpidarGeometry>(choice.model);
  settings.X_WS = place.X_WS;
  return observed_spidar(settings, hand, std::move(intended), place.q_GT);
}

}  // namespace tegotae
