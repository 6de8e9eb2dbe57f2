// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/interface_driver.hpp>

namespace tegotae {

/// SPIDAR-G6. What talks to its board (SpidarTransport) is its owner's, as the packets are not public: no device is
/// found, and `open` throws InterfaceError that says so. In a program of one's own, a SpidarInterface is made on one's
/// own transport.
const InterfaceDriver& spidar_driver() noexcept;

}  // namespace tegotae
