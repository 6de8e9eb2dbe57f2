// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/pose.hpp>
#include <tegotae/math/twist.hpp>

#include <array>
#include <cstddef>

namespace tegotae {

/// The last poses that an interface read, for the velocity of one whose makers give none. Does not allocate.
class PoseHistory {
 public:
  /// s. Differences of times up to this are rounding: sums of periods are not exact.
  static constexpr double kTimeRounding = 5e-10;

  void add(double time, const Pose& X) noexcept;
  void clear() noexcept { count_ = 0; }

  /// Finite difference (linear part: of the frame's origin, both in the axes of the poses) from the oldest reading
  /// within `window` (s) of the newest, or the one before the newest where there is none, but at most 63 readings back;
  /// zero where there are not two readings.
  Twist velocity(double window) const noexcept;

 private:
  struct Reading {
    double time = 0.0;  ///< s
    Pose X;
  };
  static constexpr std::size_t kReadings = 64;

  const Reading& back(std::size_t readings) const noexcept { return readings_[(count_ - 1 - readings) % kReadings]; }

  std::array<Reading, kReadings> readings_;  ///< a ring, newest at (count_ - 1) % kReadings
  std::size_t count_ = 0;
};

}  // namespace tegotae
