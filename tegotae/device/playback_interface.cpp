// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/playback_interface.hpp>

#include <utility>

namespace tegotae {

PlaybackInterface::PlaybackInterface(Trajectory trajectory, const InterfaceCapability& capability)
    : trajectory_(std::move(trajectory)), capability_(capability) {}

InterfaceCapability PlaybackInterface::default_capability() {
  InterfaceCapability capability;
  capability.name = "playback";
  capability.in_hand = false;
  return capability;
}

InterfaceStatus PlaybackInterface::read(double time, InterfaceState& state) noexcept {
  const double played = trajectory_.start() + time;
  state = {};
  state.time = time;
  state.X_WT = trajectory_.at(played);
  state.V_WT = trajectory_.twist_at(played);
  return InterfaceStatus::kOk;
}

InterfaceStatus PlaybackInterface::write(const InterfaceCommand& command) noexcept {
  last_command_ = command;
  return InterfaceStatus::kOk;
}

}  // namespace tegotae
