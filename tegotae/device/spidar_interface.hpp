// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/pose_history.hpp>
#include <tegotae/device/spidar_kinematics.hpp>
#include <tegotae/device/spidar_tensions.hpp>
#include <tegotae/device/spidar_transport.hpp>
#include <tegotae/runtime/haptic_interface.hpp>

#include <cstdint>
#include <memory>

namespace tegotae {

/// A SPIDAR on a table: where it stands and how fast it is.
struct SpidarSettings {
  SpidarGeometry geometry;
  Pose X_WS;                      ///< the frame S in the world
  double velocity_window = 0.01;  ///< s over which the velocity is a finite difference: a pulse is then 2 mm/s
  double rate = 1000.0;           ///< Hz, of its board
};

/// Where the zero of the counts comes from when a SPIDAR is taken into use.
enum class SpidarZero : std::uint8_t {
  kHere,  ///< calibrated now: the grip is held at the centre, unrotated
  kKept,  ///< of an earlier calibration, which the board has kept
};

/// Driver of a SPIDAR with eight strings, on a transport. The tool's frame is the grip's.
///
/// `read`: counts to string lengths (those at the centre, plus pulses, plus what the tensions last written stretch), to
/// the pose that fits them best (spidar_kinematics.hpp) from the last one, else from the centre, and its velocity.
/// kLost, with least tensions, where the transport does not answer, counts are not finite, no pose fits, or the best
/// misses the lengths by more than tolerance::kSpidarMisfit (RMS): a counter slipped, or the geometry is another one's.
/// It recovers by itself when they fit again. Lengths that leaped by more than a hand does (kSpidarFastest) must fit
/// much better (kSpidarSureMisfit), once: several slips fit a wrong pose within a millimetre. `write`: tensions for the
/// wrench at the pose read last (spidar_tensions.hpp), in the best part that the motors reach; least tensions where the
/// last read was lost, or for a wrench that is not finite. The destructor leaves least tensions. `read` and `write` do
/// not allocate.
class SpidarInterface final : public HapticInterface {
 public:
  /// With SpidarZero::kHere the grip must be held at the centre, unrotated. Throws std::invalid_argument for a geometry
  /// that cannot be used (check_force_closure), std::runtime_error where the transport does not answer. Allocates.
  SpidarInterface(const SpidarSettings& settings, std::unique_ptr<SpidarTransport> transport,
                  SpidarZero zero = SpidarZero::kHere);
  ~SpidarInterface() override;
  SpidarInterface(const SpidarInterface&) = delete;
  SpidarInterface& operator=(const SpidarInterface&) = delete;

  /// Again, with the grip held at the centre, unrotated. Does not allocate.
  InterfaceStatus calibrate() noexcept;

  /// Greatest force and torque: at the centre, each alone, in every direction (spidar_reach.hpp). The encoder's step:
  /// of a position as uncertain as rounding the counts leaves it at the centre.
  InterfaceCapability capability() const override { return capability_; }
  InterfaceStatus read(double time, InterfaceState& state) noexcept override;
  InterfaceStatus write(const InterfaceCommand& command) noexcept override;

  const SpidarPose& pose() const noexcept { return pose_; }            ///< of the last read, with its misfit
  const SpidarTensions& display() const noexcept { return display_; }  ///< of the last write, axes of S
  std::uint64_t shortfalls() const noexcept { return shortfalls_; }    ///< writes that displayed less than asked for

 private:
  SpidarVector lengths(const SpidarVector& counts) const noexcept;
  bool fit(const SpidarVector& lengths, double time) noexcept;
  bool begin(SpidarZero zero) noexcept;
  InterfaceStatus lost() noexcept;

  SpidarSettings settings_;
  std::unique_ptr<SpidarTransport> transport_;
  InterfaceCapability capability_;
  double radius_;  ///< m, of the knots
  SpidarVector metres_per_pulse_, min_, max_;
  SpidarVector let_out_at_centre_;  ///< m, unstretched, under least tensions
  SpidarPose pose_;
  SpidarTensions display_;
  PoseHistory history_;
  SpidarVector last_lengths_;  ///< m, the last that were believed
  double last_time_ = 0.0;     ///< s, when
  bool is_doubted_ = false;    ///< the lengths leaped, and did not fit well since
  bool is_lost_ = true;
  std::uint64_t shortfalls_ = 0;
};

}  // namespace tegotae
