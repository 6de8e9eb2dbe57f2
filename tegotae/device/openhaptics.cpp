// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/openhaptics.hpp>

#include <tegotae/device/openhaptics_device.hpp>
#include <tegotae/device/reconnecting_interface.hpp>

#include <exception>

namespace tegotae {
namespace {

using Calibrate = OpenHapticsDevice::Calibrate;

// The HD API lists no devices: the default one is asked for.
InterfacePresence find_openhaptics() {
  const VendorLibrary loaded = OpenHapticsLibrary::find();
  InterfacePresence found{loaded.file(), loaded.tried(), {}, loaded.trouble()};
  if (!loaded.is_loaded()) return found;
  try {
    found.devices.push_back("openhaptics (" + OpenHapticsDevice::model(OpenHapticsLibrary(loaded), {}) +
                            "; others by their names in the maker's configuration)");
  } catch (const InterfaceError& error) {
    found.trouble = error.what();
  }
  return found;
}

std::unique_ptr<HapticInterface> open_openhaptics(std::string_view text) {
  const OpenHapticsOptions options = OpenHapticsOptions::parse(text);
  const OpenHapticsLibrary library(OpenHapticsLibrary::find());
  const auto opener = [library, options]() -> std::unique_ptr<OpenDevice> {
    return std::make_unique<OpenHapticsDevice>(library, options, Calibrate::kYes);
  };
  return std::make_unique<ReconnectingInterface>(opener(), opener);
}

bool silence_openhaptics(std::string_view text) noexcept {
  try {
    return OpenHapticsDevice::silence(OpenHapticsLibrary(OpenHapticsLibrary::find()), OpenHapticsOptions::parse(text));
  } catch (const std::exception&) {
    return false;
  }
}

constexpr InterfaceDriver kOpenHapticsDriver = {
    "openhaptics",
    "Touch, Touch X, Omni, Desktop and Premium through the HD API of OpenHaptics",
    "NAME,axes=zxy",
    "the guard process opens the device and commands zero; while this process lives and only its haptic thread stands "
    "still, the servo loop drops the command after 20 callbacks; whether the device lets go by itself is not known "
    "here.",
    find_openhaptics,
    open_openhaptics,
    silence_openhaptics,
};

}  // namespace

const InterfaceDriver& openhaptics_driver() noexcept { return kOpenHapticsDriver; }

}  // namespace tegotae
