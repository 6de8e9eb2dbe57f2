// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/runtime/haptic_interface.hpp>

#include <cstdint>

namespace tegotae {

/// What a pose that an interface reported is worth.
enum class PoseVerdict : std::uint8_t {
  kGood,   ///< goes on from the last good one
  kFault,  ///< no pose (NaN, infinite, no unit quaternion), or it leapt here a moment ago
  kMoved,  ///< good, but elsewhere than the last good one: after a leap, or after the interface was lost
};

/// Watches the poses of an interface. A pose leaps where it is farther from the one before than a hand moves in the
/// time since it last changed (a device slower than the haptic rate repeats its poses) and at least in a period. The
/// reading that leaps is refused, and those that go on from there until they have done so for `kProof`: then the place
/// is taken, marked `kMoved`. A glitch that ends before is forgotten. Does not allocate.
class PoseGuard {
 public:
  static constexpr double kProof = 0.05;  ///< s

  struct Limits {
    double speed = 5.0;           ///< m/s; infinite: all is taken
    double turning_speed = 50.0;  ///< rad/s
  };

  /// `elapsed`: s since the last call, at least a period. A quaternion within half of unit length is
  /// accepted, and a place within 100 m of the origin.
  PoseVerdict judge(const Limits& limits, const InterfaceState& state, double elapsed) noexcept;

  /// The interface is lost: what it reports next need not go on from here.
  void lose() noexcept { lost_ = true; }

 private:
  Pose seen_;            ///< the last one that was a pose
  Pose good_;            ///< the last one that was taken
  double still_ = 0.0;   ///< s since `seen_` last changed
  double absent_ = 0.0;  ///< s of readings since `good_` was taken
  double proven_ = 0.0;  ///< s since the last leap
  bool leapt_ = false;   ///< and it is not known yet whether that is where the interface is
  bool started_ = false;
  bool lost_ = false;
};

}  // namespace tegotae
