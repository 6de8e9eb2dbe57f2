// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/simulated_presets.hpp>

#include <array>
#include <stdexcept>
#include <string>

namespace tegotae {
namespace {

// Viscous damping alone, so that the bounds that assume it can be measured. Mass and damping of the order of a desktop
// interface with a handle.
SimulatedDevice laboratory() {
  SimulatedDevice device;
  device.capability.name = "laboratory";
  device.mechanics = {0.2, 1e-3, 1.0, 0.01, 0.0, 0.0};
  return device;
}

// Data sheet of 3D Systems' Touch: 45 g apparent at the tip, 0.26 N of friction driven backwards, 0.055 mm of position
// resolution, 3.3 N at most, force only (its three rotations are not driven, 1 kHz). Viscous damping, inertia about the
// tip and friction and resolution of the gimbal are not stated there: taken small, and 0.1 degree.
SimulatedDevice stylus() {
  SimulatedDevice device;
  device.capability.name = "stylus";
  device.capability.output_degrees_of_freedom = 3;
  device.capability.max_force = 3.3;
  device.capability.max_torque = 0.0;
  device.capability.max_stiffness = 1020.0;
  device.capability.encoder_step = 55e-6;
  device.mechanics = {0.045, 5e-5, 0.1, 1e-4, 0.26, 2e-4};
  device.encoder_angle = 1.7e-3;
  device.delay = 1e-3;
  return device;
}

// Data sheet of Force Dimension's omega series: 12 N, resolution under 10 um, 14.5 N/mm in closed loop, up to 4 kHz.
// Moving mass, damping and friction are not stated there; a delta arm of that size with a rotational end is taken as
// 0.3 kg. Torque, and rotation 0.09 degree, of the order of its larger sister with a driven wrist.
SimulatedDevice parallel() {
  SimulatedDevice device;
  device.capability.name = "parallel";
  device.capability.max_force = 12.0;
  device.capability.max_torque = 0.4;
  device.capability.max_stiffness = 14500.0;
  device.capability.rate = 4000.0;
  device.capability.encoder_step = 10e-6;
  device.mechanics = {0.3, 5e-4, 1.0, 2e-3, 0.3, 3e-3};
  device.encoder_angle = 1.6e-3;
  device.delay = 1e-3;
  return device;
}

// Of the strength of a desktop interface, ideal otherwise: what a person at a screen sees is the rendering's. Rated at
// a quarter (rotation: half) of what a sampled spring may have with this damping and that of a moderate hand, 2 b / T,
// and at half of what a damper may have with their mass m, pi/2 m / t_d: the velocity over 10 ms is t_d = 6.5 ms old
// when it is displayed.
SimulatedDevice page() {
  SimulatedDevice device;
  device.capability.name = "page";
  device.capability.max_force = 12.0;
  device.capability.max_torque = 0.6;
  device.capability.max_stiffness = 4000.0;
  device.capability.max_rotational_stiffness = 100.0;
  device.capability.max_damping = 60.0;
  device.capability.max_rotational_damping = 0.3;
  device.mechanics = {0.1, 5e-4, 3.0, 0.04, 0.0, 0.0};
  return device;
}

const auto& devices() {
  static const std::array<Preset<SimulatedDevice>, 4> presets{
      {{"laboratory", "viscous damping alone, of a desktop interface's order", laboratory()},
       {"page", "light and well damped, ideal otherwise; of a desktop interface's strength", page()},
       {"stylus", "data sheet of the Touch (3D Systems); what it leaves out is assumed", stylus()},
       {"parallel", "data sheet of the omega series (Force Dimension); what it leaves out is assumed", parallel()}}};
  return presets;
}

// Rotation: no measurement covers a whole hand on a handle. Inertia as of the hand's mass at 7 cm, damping b l^2 with
// l = 0.1 m (what a tool of that gyration length asks for), stiffness of the order of a wrist at rest.
const auto& hands() {
  static const std::array<Preset<HandImpedance>, 3> presets{
      {{"relaxed",
        "one subject's arm on a handle: van Beek, Bergmann Tiest and Kappers, Sci. Rep. 5:18004, figure 3",
        {0.554, 2.7e-3, 6.45, 0.065, 135.0, 0.5}},
       {"moderate",
        "middle of the published ranges, 0.1 to 0.6 kg, 4 to 7 N s/m, 135 to 1255 N/m",
        {0.4, 2e-3, 5.0, 0.06, 700.0, 2.0}},
       {"firm",
        "upper end of the published stiffness with the least mass and damping",
        {0.1, 5e-4, 4.0, 0.04, 1255.0, 4.0}}}};
  return presets;
}

template <class Presets>
const auto& find(const Presets& presets, std::string_view name, const char* what) {
  std::string names;
  for (const auto& preset : presets) {
    if (preset.name == name) return preset.value;
    names.append(names.empty() ? "" : ", ").append(preset.name);
  }
  throw std::invalid_argument("there is no simulated " + std::string(what) + " '" + std::string(name) +
                              "'; there are: " + names + ".");
}

}  // namespace

std::span<const Preset<SimulatedDevice>> simulated_devices() { return devices(); }
std::span<const Preset<HandImpedance>> simulated_hands() { return hands(); }
const SimulatedDevice& simulated_device(std::string_view name) { return find(devices(), name, "device"); }
const HandImpedance& simulated_hand(std::string_view name) { return find(hands(), name, "hand"); }

}  // namespace tegotae
