// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/interface_drivers.hpp>
#include <tegotae/lab/doctor_system.hpp>

#include <filesystem>
#include <functional>
#include <span>
#include <string_view>
#include <vector>

namespace tegotae {

/// Whether this process may read and write a device's node.
using NodeAccess = std::function<bool(const std::filesystem::path&)>;

/// Asks the system.
bool may_use_node(const std::filesystem::path& node);

/// A finding for each force-feedback interface and 3-D mouse on the USB, known by its maker's number: whether the
/// process may use its node. One finding that there is none, where there is none.
std::vector<Finding> usb_findings(const SystemRoots& roots, const NodeAccess& may_use = may_use_node);

/// A finding for each driver: whether its library and a device were found, and where was looked. What is missing could
/// be better, as nobody owns all of them; for the one called `wanted` (empty: none), with its `options`, it is not
/// possible. Throws InputError, with the names, where no driver is called so.
std::vector<Finding> driver_findings(std::span<const InterfaceDriver* const> drivers, std::string_view wanted,
                                     std::string_view options = {});

/// The findings of all drivers, `wanted` being what a person means to hold, as `tegotae serve --interface` takes it: a
/// driver with or without options, or an interface without a device: "page", which needs nothing, or "playback:FILE",
/// whose file is read. Throws InputError, a sentence with what to name, where there is none of that name, or no file.
std::vector<Finding> interface_findings(const InterfaceName& wanted);

}  // namespace tegotae
