// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/interface_driver.hpp>

namespace tegotae {

/// 3-D mice (3Dconnexion and others) through the daemon spacenavd and libspnav, found at run time: they move the tool
/// (spacenav_motion has how) and display nothing.
const InterfaceDriver& spacenav_driver() noexcept;

}  // namespace tegotae
