// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/spacenav.hpp>

#include <tegotae/device/reconnecting_interface.hpp>
#include <tegotae/device/spacenav_device.hpp>

#include <memory>

namespace tegotae {
namespace {

InterfacePresence find_spacenav() {
  const VendorLibrary loaded = SpacenavLibrary::find();
  InterfacePresence found{loaded.file(), loaded.tried(), {}, loaded.trouble()};
  if (!loaded.is_loaded()) return found;
  try {
    SpacenavDevice::check_daemon(SpacenavLibrary(loaded));
    found.devices.emplace_back("spacenav (what the daemon spacenavd knows)");
  } catch (const InterfaceError& error) {
    found.trouble = error.what();
  }
  return found;
}

std::unique_ptr<HapticInterface> open_spacenav(std::string_view text) {
  const auto motion = std::make_shared<SpacenavMotion>(parse_spacenav_settings(text));
  const SpacenavLibrary library(SpacenavLibrary::find());
  const auto opener = [library, motion]() -> std::unique_ptr<OpenDevice> {
    return std::make_unique<SpacenavDevice>(library, motion);
  };
  return std::make_unique<ReconnectingInterface>(opener(), opener);
}

constexpr InterfaceDriver kSpacenavDriver = {
    "spacenav",
    "3-D mice of 3Dconnexion and others through spacenavd; they move the tool and display nothing",
    "mode=rate|offset,speed=M/S,turning-speed=RAD/S,reach=M,tilt=RAD,dead-zone=PART,axes=x-zy",
    "there is nothing to do, as it displays no force.",
    find_spacenav,
    open_spacenav,
    nullptr,
};

}  // namespace

const InterfaceDriver& spacenav_driver() noexcept { return kSpacenavDriver; }

}  // namespace tegotae
