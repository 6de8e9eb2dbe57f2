// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/intended_motion.hpp>
#include <tegotae/device/simulated_grip.hpp>
#include <tegotae/device/spidar_transport.hpp>

#include <memory>

namespace tegotae {

/// A SPIDAR in a hand. `geometry` is what it really is, which its driver may take for something else.
struct SimulatedSpidarSettings {
  SpidarGeometry geometry;
  Pose X_WS;                                       ///< where it stands in the world of the hand's motion
  GripMechanics mechanics{0.05, 2e-5, 0.5, 1e-3};  ///< a light ball with knots; reflected inertia of motors included
  HandImpedance hand;
  double substep = 20e-6;  ///< s
};

/// Motors, strings and encoders of a SPIDAR, simulated, and the hand that holds the grip and means to follow a motion.
///
/// Motors: each tension is clipped to [0, its greatest] (what is not finite becomes its least) and held until the next.
/// Strings: massless and taut, so the grip feels the tensions along them, as they lie, at once. Each gives by
/// tension/axial_stiffness of its length, so the pulley has let out length/(1 + tension/axial_stiffness).
/// Encoders: what the pulleys let out since `reset`, in pulses, rounded to the nearest one.
/// The counts are zero with the grip at S, unrotated, under least tensions, as if a person had held it there at
/// `reset`, wherever the motion begins. Between two calls the strings' directions are renewed every 0.2 ms. Runs in the
/// caller's time from 0, without a wall clock, so it repeats bit for bit. No motor has inertia or friction of its own.
/// `read` and `write` do not allocate.
class SimulatedSpidar final : public SpidarTransport {
 public:
  /// Throws std::invalid_argument as check_numbers and SimulatedGrip do. `intended` may not be null. Allocates.
  SimulatedSpidar(const SimulatedSpidarSettings& settings, std::unique_ptr<IntendedMotion> intended);

  bool reset() noexcept override;
  /// Integrates up to `time`; false, and nothing moves, where it is not finite or over a second after the last.
  bool read(double time, SpidarVector& counts) noexcept override;
  bool write(const SpidarVector& tensions) noexcept override;

  const GripState& grip() const noexcept { return grip_.state(); }  ///< the true one, world axes
  const Pose& intended() const noexcept { return X_WH_; }           ///< where the hand means the grip to be now
  void set_grip(const GripState& state) noexcept { grip_.set_state(state); }
  const SpidarVector& tensions() const noexcept { return tensions_; }  ///< what the motors pull now, N
  Wrench displayed() const noexcept;                                   ///< on the grip, about its origin, world axes

  /// Pulls the plug, or puts it back: all calls fail meanwhile, the hand goes on, the tensions fall to zero.
  void set_connected(bool connected) noexcept;

 private:
  void advance_to(double time) noexcept;
  SpidarVector let_out(const SpidarVector& lengths, const SpidarVector& tensions) const noexcept;

  SimulatedSpidarSettings settings_;
  std::unique_ptr<IntendedMotion> intended_;
  SimulatedGrip grip_;
  Pose X_WH_;  ///< where the hand means to be at `time_`
  SpidarVector let_out_at_reset_;
  SpidarVector tensions_;
  double time_ = 0.0;  ///< s
  bool is_connected_ = true;
};

}  // namespace tegotae
