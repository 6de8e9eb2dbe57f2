// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/spidar_geometry.hpp>

namespace tegotae {

/// Port to the motors and encoders of a SPIDAR: what its owner fills in for a board (spidar_volts converts tensions).
/// All is called from one thread and must not block longer than a haptic period has room for; false: nothing came or
/// went, the board does not answer.
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
};

}  // namespace tegotae
