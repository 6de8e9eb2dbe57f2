// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/interface_driver.hpp>

#include <span>

namespace tegotae {

/// A recording or a trajectory (trajectory_file.hpp) in the place of a hand: it moves the tool as it says, whatever is
/// displayed, and then holds it where it ended. Drivers lie in a layer that reads no files of these kinds, so this one
/// is here.
const InterfaceDriver& playback_driver() noexcept;

/// All drivers that the program knows: those of devices (interface_drivers.hpp), then playback.
std::span<const InterfaceDriver* const> known_drivers();

}  // namespace tegotae
