// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/force_dimension.hpp>

#include <tegotae/device/force_dimension_device.hpp>
#include <tegotae/device/reconnecting_interface.hpp>

#include <exception>
#include <string>
#include <utility>

namespace tegotae {
namespace {

InterfacePresence find_force_dimension() {
  const VendorLibrary loaded = ForceDimensionLibrary::find();
  InterfacePresence found{loaded.file(), loaded.tried(), {}, loaded.trouble()};
  if (!loaded.is_loaded()) return found;
  try {
    const ForceDimensionLibrary library(loaded);
    const int count = library.device_count();
    for (int i = 0; i < count; ++i) {
      found.devices.push_back("force-dimension:" + std::to_string(i) +
                              (library.drd_open != nullptr ? " (moves by itself when opened, if it is not calibrated)"
                                                           : " (must be calibrated by hand: this is libdhd)"));
    }
    if (count <= 0) {
      found.trouble =
          "force-dimension: no device is seen; check its power and cable, and your rights on USB devices of vendor "
          "1451.";
    }
  } catch (const InterfaceError& error) {
    found.trouble = error.what();
  }
  return found;
}

std::unique_ptr<HapticInterface> open_force_dimension(std::string_view text) {
  const ForceDimensionOptions options = ForceDimensionOptions::parse(text);
  const ForceDimensionLibrary library(ForceDimensionLibrary::find());
  auto device = std::make_unique<ForceDimensionDevice>(library, options, true);
  // A hand may be on a device that comes back: it is not moved.
  return std::make_unique<ReconnectingInterface>(std::move(device), [library, options] {
    return std::make_unique<ForceDimensionDevice>(library, options, false);
  });
}

bool silence_force_dimension(std::string_view text) noexcept {
  try {
    return ForceDimensionDevice::silence(ForceDimensionLibrary(ForceDimensionLibrary::find()),
                                         ForceDimensionOptions::parse(text));
  } catch (const std::exception&) {
    return false;
  }
}

constexpr InterfaceDriver kForceDimensionDriver = {
    "force-dimension",
    "omega, sigma, lambda, delta and Falcon through the Force Dimension SDK",
    "ID,axes=xyz,gravity-compensation=on|off,effector-mass=KG,auto-init=on|off",
    "the guard process opens the device and commands zero; whether the device lets go by itself when commands cease is "
    "not known here.",
    find_force_dimension,
    open_force_dimension,
    silence_force_dimension,
};

}  // namespace

const InterfaceDriver& force_dimension_driver() noexcept { return kForceDimensionDriver; }

}  // namespace tegotae
