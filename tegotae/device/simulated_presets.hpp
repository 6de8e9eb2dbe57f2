// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/simulated_hand_interface.hpp>

#include <span>
#include <string_view>

namespace tegotae {

/// A simulated device or hand that has a name, and where its numbers come from.
template <class Value>
struct Preset {
  std::string_view name;
  std::string_view source;
  Value value;
};

/// Devices: "laboratory" (viscous damping alone: for bounds that assume it), "page" (light and well damped,
/// without delay or encoder: for a hand at a screen), "stylus" (a desktop stylus arm) and
/// "parallel" (a desktop parallel mechanism). Allocated once, valid for the program's life.
std::span<const Preset<SimulatedDevice>> simulated_devices();

/// Hands: "relaxed", "moderate" and "firm".
std::span<const Preset<HandImpedance>> simulated_hands();

// By name. Throw std::invalid_argument, with the names, where there is none.

const SimulatedDevice& simulated_device(std::string_view name);
const HandImpedance& simulated_hand(std::string_view name);

}  // namespace tegotae
