// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/interface_driver.hpp>

namespace tegotae {

/// Haption's Virtuose arms through the maker's API, version 4, found at run time: virtuose_device has what is read and
/// commanded, docs/interfaces.md what a person must know. The device is on the network: it is named by its address.
const InterfaceDriver& virtuose_driver() noexcept;

}  // namespace tegotae
