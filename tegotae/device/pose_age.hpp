// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/pose.hpp>
#include <tegotae/math/twist.hpp>

namespace tegotae {

/// Tells when the pose was measured that a maker's library reports, where that gives no time: for a pose that has
/// frozen while the hand goes on. A pose that stays the same to the last bit for longer than `kLongestStill`, while the
/// library says that it moves, dates from when it last changed; any other is new. A hand that rests keeps its pose as
/// well, but has no velocity then; so a device whose velocity freezes at zero with its pose is not told from a hand
/// that rests. Does not allocate.
class PoseAge {
 public:
  /// s. Makers' velocities are means over up to 20 ms: a hand that stopped has none after that.
  static constexpr double kLongestStill = 0.03;
  /// m/s and rad/s that are clearly no rest: in `kLongestStill` 0.6 mm and 6 mrad, tens of steps of any encoder.
  static constexpr double kMovingSpeed = 0.02, kTurningSpeed = 0.2;

  /// s, when the pose was measured that was read at `time` (s) with the velocity `V`. What is not finite is new.
  double measured(double time, const Pose& X, const Twist& V) noexcept {
    const bool is_same = has_read_ && X.p == last_.p && X.q.coeffs() == last_.q.coeffs();
    if (!is_same) changed_ = time;
    last_ = X;
    has_read_ = true;
    const bool moves = V.linear.norm() > kMovingSpeed || V.angular.norm() > kTurningSpeed;
    return moves && time - changed_ > kLongestStill ? changed_ : time;
  }

 private:
  Pose last_;
  double changed_ = 0.0;  ///< s
  bool has_read_ = false;
};

}  // namespace tegotae
