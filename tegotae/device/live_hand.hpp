// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/guided_motion.hpp>
#include <tegotae/device/playback_interface.hpp>
#include <tegotae/device/simulated_hand_interface.hpp>

#include <atomic>
#include <optional>

namespace tegotae {

/// The interface of a session without a device: a simulated interface in a simulated hand that a person guides. It may
/// begin by playing a motion exactly, as experiments do, whatever is displayed; after that, or when it is interrupted,
/// the hand takes the tool where it is. Where nothing was read for over a second (a program that was stopped, a machine
/// that was suspended) the interface is lost for one reading, and then held where it was. `read` and `write` do not
/// allocate.
class LiveHand final : public HapticInterface {
 public:
  /// At `start`, guided; or, with `exact`, at its start and playing it. Throws as SimulatedHandInterface.
  LiveHand(const Pose& start, const SimulatedDevice& device, const HandImpedance& hand,
           std::optional<Trajectory> exact = std::nullopt);

  InterfaceCapability capability() const override { return hand_.capability(); }
  InterfaceStatus read(double time, InterfaceState& state) noexcept override;
  InterfaceStatus write(const InterfaceCommand& command) noexcept override;

  // For the thread that guides.

  GuidedMotion& guide() noexcept { return *guide_; }
  const GuidedMotion& guide() const noexcept { return *guide_; }
  bool is_playing_exactly() const noexcept { return exactly_.load(std::memory_order_acquire); }
  /// Ends the exact motion at the next tick.
  void interrupt() noexcept { interrupted_.store(true, std::memory_order_release); }

 private:
  LiveHand(std::unique_ptr<GuidedMotion> guide, const SimulatedDevice& device, const HandImpedance& hand,
           std::optional<Trajectory>&& exact);

  /// The hand holds the tool there from `time` (s) on, at rest.
  void take_at(double time, const Pose& X_WT) noexcept;

  GuidedMotion* guide_;  ///< of hand_
  SimulatedHandInterface hand_;
  std::optional<PlaybackInterface> playback_;
  std::atomic<bool> exactly_;
  std::atomic<bool> interrupted_{false};
};

}  // namespace tegotae
