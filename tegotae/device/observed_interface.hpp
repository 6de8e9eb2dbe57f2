// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/simulated_hand_interface.hpp>
#include <tegotae/device/simulated_spidar.hpp>
#include <tegotae/device/spidar_interface.hpp>
#include <tegotae/math/plain.hpp>
#include <tegotae/runtime/spsc_ring.hpp>

#include <memory>

namespace tegotae {

/// What really happened at the grip of a simulated interface in one haptic tick.
struct GripTruth {
  double time = 0.0;         ///< s, of the read before
  PlainWrench displayed;     ///< by the motors once the command was written: on the grip, about it, world axes
  PlainPose X_WT;            ///< the tool's frame, without the rounding of encoders
  PlainPose X_WH;            ///< where the hand means the tool's frame to be
  bool falls_short = false;  ///< the motors cannot give what was commanded
};

/// A simulated interface in a simulated hand that tells what really happens at its grip, beside what a driver can know.
///
/// The tool is held at the grip as a person takes a thing into the hand: the origins of both frames agree, and the tool
/// is turned by a constant `q_GT` in the grip's frame, so that a motion far from unturned needs no wrist that is.
/// Forces and torques keep their directions. `read` and `write` do not allocate.
class ObservedInterface : public HapticInterface {
 public:
  InterfaceStatus read(double time, InterfaceState& state) noexcept final;
  /// Then adds what is true now to what `take` gives.
  InterfaceStatus write(const InterfaceCommand& command) noexcept final;

  /// The oldest truth that was not taken yet; false: there is none. One after every `write`, but those that nobody took
  /// for some seconds. By one thread, which need not be the one that reads and writes.
  bool take(GripTruth& truth) noexcept { return truths_.pop(truth); }

 protected:
  explicit ObservedInterface(const Quaternion& q_GT);

  // In terms of the grip, which the functions above turn into those of the tool.

  virtual InterfaceStatus read_grip(double time, InterfaceState& state) noexcept = 0;
  virtual InterfaceStatus write_grip(const InterfaceCommand& command) noexcept = 0;
  virtual GripTruth truth(const InterfaceCommand& command) const noexcept = 0;

 private:
  Pose of_tool(const Pose& X_WG) const noexcept;

  Quaternion q_GT_;
  double time_ = 0.0;  ///< s, of the last read
  SpscRing<GripTruth> truths_;
};

/// A simulated device. Throws as SimulatedHandInterface. `intended` is that of the tool; it may not be null. Allocates.
std::unique_ptr<ObservedInterface> observed_device(const SimulatedDevice& device, const HandImpedance& hand,
                                                   std::unique_ptr<IntendedMotion> intended);

/// The driver of a SPIDAR on a simulated one of the same geometry and place. Throws as SpidarInterface and
/// SimulatedSpidar. `intended` is that of the tool; it may not be null. Allocates.
std::unique_ptr<ObservedInterface> observed_spidar(const SpidarSettings& settings, const HandImpedance& hand,
                                                   std::unique_ptr<IntendedMotion> intended,
                                                   const Quaternion& q_GT = Quaternion::Identity());

}  // namespace tegotae
