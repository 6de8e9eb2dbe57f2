// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/interface_driver.hpp>

#include <span>
#include <string>
#include <string_view>

namespace tegotae {

/// All drivers, in the order in which they are listed. Valid for the program's life.
std::span<const InterfaceDriver* const> interface_drivers();

/// "NAME" or "NAME:OPTIONS" as it stands on the command line.
struct InterfaceName {
  std::string driver, options;
};
InterfaceName parse_interface_name(std::string_view text);

/// The driver called `name` among `drivers`. Throws InterfaceError, with the names, where there is none.
const InterfaceDriver& find_interface_driver(std::string_view name,
                                             std::span<const InterfaceDriver* const> drivers = interface_drivers());

}  // namespace tegotae
