// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/interface_driver.hpp>

namespace tegotae {

/// Devices of Force Dimension (and Novint's Falcon) through the maker's SDK, found at run time: force_dimension_device
/// has what is read and commanded, docs/interfaces.md what a person must know. A device that is lost and comes back
/// uncalibrated is not moved: it stays lost until it is calibrated by hand.
const InterfaceDriver& force_dimension_driver() noexcept;

}  // namespace tegotae
