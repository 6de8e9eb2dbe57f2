// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/spidar_driver.hpp>

#include <tegotae/device/interface_options.hpp>
#include <tegotae/device/reconnecting_interface.hpp>
#include <tegotae/device/spidar_device.hpp>

#include <fmt/format.h>

#include <exception>

namespace tegotae {
namespace {

constexpr std::string_view kNoSpidarTransport =
    "no transport to a SPIDAR's board is given, and none is part of this program, as the boards' packets are not "
    "public: name the library that speaks to yours, spidar-g6:x3r,transport=/path/libmyboard.so (docs/spidar.md), or "
    "try the simulated one in an experiment: tegotae experiment NAME --interface spidar-g6:x3r,simulated";

constexpr std::string_view kSpidarBoardOnly =
    "the board's own watchdog must let go of the motors where no command comes: its library does not let another "
    "process stop them.";

InterfacePresence find_spidar() { return {"", {}, {}, fmt::format("{}.", kNoSpidarTransport)}; }

SpidarOptions with_transport(std::string_view text) {
  if (text.ends_with(",simulated")) {
    throw InterfaceError(fmt::format(
        "spidar-g6:{0}: a simulated SPIDAR is held by a simulated hand, which follows an experiment: tegotae "
        "experiment NAME --interface spidar-g6:{0}.",
        text));
  }
  if (text.empty()) throw InterfaceError(fmt::format("spidar-g6: {}.", kNoSpidarTransport));
  SpidarOptions options = SpidarOptions::parse(text);
  if (options.transport.empty()) throw InterfaceError(fmt::format("spidar-g6:{}: {}.", text, kNoSpidarTransport));
  return options;
}

SpidarBoardLibrary library_for(const SpidarOptions& options) {
  return SpidarBoardLibrary(SpidarBoardLibrary::find(options.transport));
}

// The board is not opened: somebody may be driving it.
InterfacePresence find_spidar_with(std::string_view text) {
  const SpidarOptions options = with_transport(text);
  const VendorLibrary loaded = SpidarBoardLibrary::find(options.transport);
  InterfacePresence found{loaded.file(), loaded.tried(), {}, loaded.trouble()};
  if (!loaded.is_loaded()) return found;
  try {
    static_cast<void>(SpidarBoardLibrary(loaded));
    found.devices.push_back(fmt::format("spidar-g6:{} (its board is not opened to look for it)", text));
  } catch (const InterfaceError& error) {
    found.trouble = error.what();
  }
  return found;
}

std::unique_ptr<HapticInterface> open_spidar(std::string_view text) {
  const SpidarOptions options = with_transport(text);
  const SpidarBoardLibrary library = library_for(options);
  const auto zero = options.is_zero_kept ? SpidarZero::kKept : SpidarZero::kHere;
  // Where a hand holds the grip of a device that comes back nobody knows: it is not calibrated then.
  return std::make_unique<ReconnectingInterface>(
      std::make_unique<SpidarDevice>(library, options, zero),
      [library, options] { return std::make_unique<SpidarDevice>(library, options, SpidarZero::kKept); });
}

// Not by way of the geometry: its file may have been changed or moved since the board was opened, and is not needed.
bool silence_spidar(std::string_view text) noexcept {
  try {
    InterfaceOptions given("spidar-g6", text);
    const SpidarBoardLibrary library(SpidarBoardLibrary::find(given.text("transport").value_or("")));
    return SpidarBoard::silence(library, given.text("board").value_or(""));
  } catch (const std::exception&) {
    return false;
  }
}

InterfaceRescue spidar_rescue(std::string_view text) {
  const SpidarBoardLibrary library = library_for(with_transport(text));
  switch (library.sharing) {
    case TEGOTAE_SPIDAR_AFTER_DEATH:
      return {RescueTime::kAfterDeath, "the guard process opens the board and takes the current off its motors."};
    case TEGOTAE_SPIDAR_ANY_TIME:
      return {RescueTime::kAnyTime,
              "the guard process opens the board and takes the current off its motors, also where the program stands "
              "still."};
    default:
      return {RescueTime::kNever, std::string(kSpidarBoardOnly)};
  }
}

constexpr InterfaceDriver kSpidarDriver = {
    "spidar-g6",
    "SPIDAR-G6, eight strings, through a library that speaks to its board",
    "PRESET|FILE,transport=LIBRARY,board=TEXT,axes=xyz,rate=HZ,stiffness=N/M,zero=here|kept,hold=S",
    "the guard process stops the motors, where the board's library lets another process do so; else the board's own "
    "watchdog must.",
    find_spidar,
    open_spidar,
    silence_spidar,
    "hold the grip still in the middle of the frame, unrotated, until it is open; its strings are pulled taut",
    find_spidar_with,
    spidar_rescue,
};

}  // namespace

const InterfaceDriver& spidar_driver() noexcept { return kSpidarDriver; }

}  // namespace tegotae
