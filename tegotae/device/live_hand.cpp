// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/live_hand.hpp>

#include <utility>

namespace tegotae {
namespace {

Pose first_pose(const Pose& start, const std::optional<Trajectory>& exact) {
  return exact ? exact->samples().front().X_WT : start;
}

}  // namespace

LiveHand::LiveHand(const Pose& start, const SimulatedDevice& device, const HandImpedance& hand,
                   std::optional<Trajectory> exact)
    : LiveHand(std::make_unique<GuidedMotion>(first_pose(start, exact)), device, hand, std::move(exact)) {}

LiveHand::LiveHand(std::unique_ptr<GuidedMotion> guide, const SimulatedDevice& device, const HandImpedance& hand,
                   std::optional<Trajectory>&& exact)
    : guide_(guide.get()), hand_(std::move(guide), device, hand), exactly_(exact.has_value()) {
  if (exact) playback_.emplace(std::move(*exact), device.capability);
}

InterfaceStatus LiveHand::read(double time, InterfaceState& state) noexcept {
  if (!exactly_.load(std::memory_order_relaxed)) {
    const InterfaceStatus status = hand_.read(time, state);
    if (status != InterfaceStatus::kOk) take_at(time, hand_.grip().X_WG);
    return status;
  }
  const InterfaceStatus status = playback_->read(time, state);
  const Trajectory& motion = playback_->trajectory();
  if (time >= motion.end() - motion.start() || interrupted_.load(std::memory_order_acquire)) {
    take_at(time, state.X_WT);
    exactly_.store(false, std::memory_order_release);
  }
  return status;
}

void LiveHand::take_at(double time, const Pose& X_WT) noexcept {
  guide_->place(time, X_WT);
  hand_.restart(time, X_WT);
}

InterfaceStatus LiveHand::write(const InterfaceCommand& command) noexcept {
  return exactly_.load(std::memory_order_relaxed) ? playback_->write(command) : hand_.write(command);
}

}  // namespace tegotae
