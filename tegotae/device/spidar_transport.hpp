// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/spidar_geometry.hpp>

#include <cstdint>

namespace tegotae {

/// Port to the motors and encoders of a SPIDAR, behind which its board is (spidar_board.hpp: in a library of its
/// owner's), or a simulated one. All is called from one thread and must not block longer than a haptic period has room
/// for; false: nothing came or went, the board does not answer.
class SpidarTransport {
 public:
  SpidarTransport() = default;
  SpidarTransport(const SpidarTransport&) = delete;
  SpidarTransport& operator=(const SpidarTransport&) = delete;
  virtual ~SpidarTransport() = default;

  /// The grip is at the centre, unrotated: all counts are zero here.
  virtual bool reset() noexcept = 0;
  /// Counts now, `time` in s on the caller's clock; pulses, fractions where the board interpolates.
  virtual bool read(double time, SpidarVector& counts) noexcept = 0;
  /// Tensions to hold until the next ones, N.
  virtual bool write(const SpidarVector& tensions) noexcept = 0;

  // Of the last reading.

  /// s since the counts were measured; 0 where the board does not know.
  virtual double age() const noexcept { return 0.0; }
  /// Of the grip, a bit each.
  virtual std::uint32_t buttons() const noexcept { return 0; }
};

}  // namespace tegotae
