// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/virtuose.hpp>

#include <tegotae/device/reconnecting_interface.hpp>
#include <tegotae/device/virtuose_device.hpp>

#include <exception>

namespace tegotae {
namespace {

InterfacePresence find_virtuose() {
  const VendorLibrary loaded = VirtuoseLibrary::find();
  InterfacePresence found{loaded.file(), loaded.tried(), {}, loaded.trouble()};
  if (!loaded.is_loaded()) return found;
  try {
    const VirtuoseLibrary library(loaded);
    found.trouble =
        "virtuose: devices are on the network and cannot be listed; name the address of one's controller, as "
        "virtuose:192.168.1.5.";
  } catch (const InterfaceError& error) {
    found.trouble = error.what();
  }
  return found;
}

std::unique_ptr<HapticInterface> open_virtuose(std::string_view text) {
  const VirtuoseOptions options = VirtuoseOptions::parse(text);
  const VirtuoseLibrary library(VirtuoseLibrary::find());
  const auto stopped = std::make_shared<std::atomic<bool>>(false);
  const auto open_again = [library, options, stopped] {
    return std::make_unique<VirtuoseDevice>(library, options, stopped);
  };
  auto device = open_again();
  return std::make_unique<ReconnectingInterface>(std::move(device), open_again);
}

bool silence_virtuose(std::string_view text) noexcept {
  try {
    return VirtuoseDevice::silence(VirtuoseLibrary(VirtuoseLibrary::find()), VirtuoseOptions::parse(text));
  } catch (const std::exception&) {
    return false;
  }
}

constexpr InterfaceDriver kVirtuoseDriver = {
    "virtuose",
    "Haption's Virtuose arms through the Virtuose API, version 4",
    "HOST[#PORT],axes=xyz,period=S,max-force=N,max-torque=NM",
    "the guard process opens the device, commands zero and switches its power off; the maker says that the controller "
    "stops by itself 2 s after commands cease, which was not tried here.",
    find_virtuose,
    open_virtuose,
    silence_virtuose,
};

}  // namespace

const InterfaceDriver& virtuose_driver() noexcept { return kVirtuoseDriver; }

}  // namespace tegotae
