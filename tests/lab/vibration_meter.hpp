// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/types.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tegotae::test {

/// What a velocity (six components, m/s) has above 20 Hz, where no hand moves of its own will: Butterworth high-pass of
/// second order. Root mean square over all that counts, and of the worst stretch that counts without a break.
class VibrationMeter {
 public:
  explicit VibrationMeter(double period) {
    const double k = std::tan(std::numbers::pi * 20.0 * period), norm = 1.0 / (1.0 + std::numbers::sqrt2 * k + k * k);
    b_ = norm;
    a1_ = 2.0 * (k * k - 1.0) * norm;
    a2_ = (1.0 - std::numbers::sqrt2 * k + k * k) * norm;
  }

  void add(const Vector6& velocity, bool counts) {
    const Vector6 fast = b_ * (velocity - 2.0 * x1_ + x2_) - a1_ * y1_ - a2_ * y2_;
    x2_ = x1_;
    x1_ = velocity;
    y2_ = y1_;
    y1_ = fast;
    if (counts) {
      stretch_.add(fast);
      all_.add(fast);
      return;
    }
    worst_ = worst();
    stretch_ = {};
  }

  double worst() const { return std::max(worst_, stretch_.root_mean_square()); }  ///< m/s
  double mean() const { return all_.root_mean_square(); }                         ///< m/s

 private:
  struct Squares {
    double sum = 0.0;
    long count = 0;
    void add(const Vector6& value) {
      sum += value.squaredNorm();
      ++count;
    }
    double root_mean_square() const { return count > 0 ? std::sqrt(sum / static_cast<double>(count)) : 0.0; }
  };

  double b_, a1_, a2_;
  Vector6 x1_ = Vector6::Zero(), x2_ = Vector6::Zero(), y1_ = Vector6::Zero(), y2_ = Vector6::Zero();
  Squares stretch_, all_;
  double worst_ = 0.0;
};

}  // namespace tegotae::test
