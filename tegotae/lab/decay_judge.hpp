// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <limits>

namespace tegotae {

/// Judges whether a motion decays: "stable" in the sense of the laboratory. Two windows of a second are compared, the
/// first after the touch and the last of the time given. It decays if the speed's root mean square in the last is at
/// most `kShrink` of that in the first, or below `kStill`. So a motion that keeps its amplitude, such as a limit cycle,
/// does not; and a mode of mass m is passed as soon as its net damping exceeds 2 m ln(1/kShrink) / 4 s, which at 0.5 kg
/// is 0.03 N s/m: under a hundredth of what a hand has.
class DecayJudge {
 public:
  static constexpr double kDuration = 5.0;  ///< s from the touch's end to the verdict
  static constexpr double kWindow = 1.0;    ///< s
  static constexpr double kShrink = 0.9;    ///< of the root mean square, over the four seconds between the windows
  static constexpr double kStill = 1e-6;    ///< m/s: a thousandth of the speed of the touch
  static constexpr double kDiverged = 0.1;  ///< m/s: a hundred times the speed of the touch, beyond doubt

  /// `begin`: s, when the touch has ended.
  explicit DecayJudge(double begin) noexcept : begin_(begin) {}

  /// The speed (m/s, of translation and rotation together) at `time` (s), in order of time. False once no more is
  /// needed.
  bool add(double time, double speed) noexcept;

  bool decayed() const noexcept;
  double first_speed() const noexcept { return first_.root_mean_square(); }  ///< m/s, in the first window
  double last_speed() const noexcept { return last_.root_mean_square(); }    ///< m/s, in the last window

 private:
  struct Window {
    double squares = 0.0;
    long count = 0;
    double root_mean_square() const noexcept;
  };

  double begin_;
  bool diverged_ = false;
  Window first_, last_;
};

}  // namespace tegotae
