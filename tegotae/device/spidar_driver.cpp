// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/spidar_driver.hpp>

#include <fmt/format.h>

namespace tegotae {
namespace {

constexpr std::string_view kNoSpidarTransport =
    "no transport to a SPIDAR's board is part of this program, as its packets are not public: fill in SpidarTransport "
    "for yours (docs/spidar.md), or try the simulated one in an experiment: tegotae experiment NAME --interface "
    "spidar-g6:x3r,simulated";

InterfacePresence find_spidar() { return {"", {}, {}, fmt::format("{}.", kNoSpidarTransport)}; }

std::unique_ptr<HapticInterface> open_spidar(std::string_view options) {
  if (options.ends_with(",simulated")) {
    throw InterfaceError(fmt::format(
        "spidar-g6:{0}: a simulated SPIDAR is held by a simulated hand, which follows an experiment: tegotae "
        "experiment NAME --interface spidar-g6:{0}.",
        options));
  }
  throw InterfaceError(fmt::format("spidar-g6{}{}: {}.", options.empty() ? "" : ":", options, kNoSpidarTransport));
}

constexpr InterfaceDriver kSpidarDriver = {
    "spidar-g6",
    "SPIDAR-G6, eight strings",
    "PRESET|FILE,simulated",
    "its owner's transport: the board must let go of the motors by itself where no packet comes.",
    find_spidar,
    open_spidar,
    nullptr,
};

}  // namespace

const InterfaceDriver& spidar_driver() noexcept { return kSpidarDriver; }

}  // namespace tegotae
