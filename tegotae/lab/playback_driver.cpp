// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/playback_driver.hpp>

#include <tegotae/device/interface_drivers.hpp>
#include <tegotae/device/playback_interface.hpp>
#include <tegotae/lab/input_error.hpp>
#include <tegotae/lab/trajectory_file.hpp>

#include <filesystem>
#include <stdexcept>
#include <string>
#include <vector>

namespace tegotae {
namespace {

InterfacePresence find_playback() { return {"", {}, {"playback:FILE, any recording (MCAP) or trajectory (CSV)"}, ""}; }

std::unique_ptr<HapticInterface> open_playback(std::string_view file) {
  if (file.empty()) {
    throw InterfaceError("playback: give a recording (MCAP) or a trajectory (CSV) to play: playback:FILE.");
  }
  try {
    return std::make_unique<PlaybackInterface>(read_trajectory(std::filesystem::path(file)));
  } catch (const std::runtime_error& error) {
    throw InterfaceError(std::string("playback: ") + error.what());
  }
}

constexpr InterfaceDriver kPlaybackDriver = {
    "playback",    "a recording or a trajectory in the place of a hand, which feels nothing",
    "FILE",        "there is nothing to do, as it displays no force.",
    find_playback, open_playback,
    nullptr,
};

}  // namespace

const InterfaceDriver& playback_driver() noexcept { return kPlaybackDriver; }

std::span<const InterfaceDriver* const> known_drivers() {
  static const std::vector<const InterfaceDriver*> drivers = [] {
    std::vector<const InterfaceDriver*> all(interface_drivers().begin(), interface_drivers().end());
    all.push_back(&playback_driver());
    return all;
  }();
  return drivers;
}

}  // namespace tegotae
