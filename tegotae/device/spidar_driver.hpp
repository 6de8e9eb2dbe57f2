// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/interface_driver.hpp>

namespace tegotae {

/// SPIDAR-G6. Its boards' packets are not public, so a library of its owner's speaks to the board: spidar_transport.h
/// has what it must offer, spidar_device.hpp what is read and commanded, docs/spidar.md what a person must know. A
/// device that is lost and comes back with its counts' zero is taken up where it is; one that lost it stays lost until
/// it is calibrated.
const InterfaceDriver& spidar_driver() noexcept;

}  // namespace tegotae
