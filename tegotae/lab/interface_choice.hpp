// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/interface_drivers.hpp>
#include <tegotae/device/observed_interface.hpp>
#include <tegotae/lab/spidar_place.hpp>

#include <memory>
#include <string>
#include <string_view>
#include <variant>

namespace tegotae {

/// A simulated interface that the program knows by name.
struct SimulatedChoice {
  std::string name;  ///< as on the command line
  std::variant<SimulatedDevice, SpidarGeometry> model;
};

/// "simulated:PRESET, ..., spidar-g6:PRESET|FILE,simulated": those that there are, for help and messages.
std::string simulated_interface_names();

/// Whether the name is that of a simulated interface, though perhaps of none that there is: "simulated..." or options
/// whose last word, after a comma, is "simulated".
bool is_simulated(const InterfaceName& name) noexcept;

/// "simulated:PRESET" (simulated_presets.hpp) or "spidar-g6:PRESET,simulated" (spidar_presets.hpp) or
/// "spidar-g6:FILE,simulated" (spidar_file.hpp). Throws InputError, a sentence with what there is, for any other name,
/// a file that cannot be used, a SPIDAR without force closure, and a device that is not simulated.
SimulatedChoice find_simulated(const InterfaceName& name);

/// Its name as a part of a file's name: "spidar-g6:frames/b.txt,simulated" becomes "spidar-g6-b.txt-simulated". What
/// stands there for the folders of a file is left out, any other character but letters, digits, '-', '_' and '.' is
/// '-'.
std::string file_name_of(const SimulatedChoice& choice);

/// What the interface can do in `hand`, read and commanded each `period` (s): as it states, and rated for no more than
/// nine tenths of the linear bound of stiffness_bounds.hpp without any damping of the coupling.
InterfaceCapability capability_in_hand(const SimulatedChoice& choice, const HandImpedance& hand, double period);

/// A preset by name, else a file. Throws InputError, a sentence with what there is or what is wrong in the file.
SpidarGeometry spidar_geometry_of(std::string_view preset_or_file);

/// The interface in `hand`, which means the tool to follow `intended` (not null). `place` matters to a SPIDAR alone.
/// Throws InputError. Allocates.
std::unique_ptr<ObservedInterface> make_simulated(const SimulatedChoice& choice, const HandImpedance& hand,
                                                  std::unique_ptr<IntendedMotion> intended,
                                                  const SpidarPlace& place = {});

}  // namespace tegotae
