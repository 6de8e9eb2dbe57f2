// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/interface_driver.hpp>

namespace tegotae {

/// Touch, Touch X, Phantom Omni, Desktop and Premium (3D Systems, formerly SensAble) through the HD API of OpenHaptics,
/// found at run time: openhaptics_servo has what is read and commanded, docs/interfaces.md what a person must know.
const InterfaceDriver& openhaptics_driver() noexcept;

}  // namespace tegotae
