// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/pose.hpp>
#include <tegotae/math/twist.hpp>

#include <vector>

namespace tegotae {

/// A motion of the tool's frame: poses at instants, between them linear in position and slerp in rotation.
class Trajectory {
 public:
  struct Sample {
    double time = 0.0;  ///< s
    Pose X_WT;
  };

  /// Throws std::invalid_argument unless there are samples, their times ascend strictly, and all is finite. Allocates.
  explicit Trajectory(std::vector<Sample> samples);

  double start() const noexcept { return samples_.front().time; }
  double end() const noexcept { return samples_.back().time; }
  const std::vector<Sample>& samples() const noexcept { return samples_; }

  /// Pose at `time` (s), held before the start and after the end. Does not allocate; logarithmic in samples.
  Pose at(double time) const noexcept;

  /// Velocity of the frame's origin at `time` (that of the segment that begins there), zero outside.
  Twist twist_at(double time) const noexcept;

 private:
  std::vector<Sample>::const_iterator segment(double time) const noexcept;

  std::vector<Sample> samples_;
};

}  // namespace tegotae
