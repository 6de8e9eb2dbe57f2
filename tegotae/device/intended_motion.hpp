// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/trajectory.hpp>

#include <utility>

namespace tegotae {

/// Where a simulated hand means the grip to be: from a file, or from a person at a page.
class IntendedMotion {
 public:
  IntendedMotion() = default;
  IntendedMotion(const IntendedMotion&) = delete;
  IntendedMotion& operator=(const IntendedMotion&) = delete;
  virtual ~IntendedMotion() = default;

  /// Where the motion begins.
  virtual Pose start() const noexcept = 0;

  /// Pose meant at `time` (s since the motion began). Called with times that never fall. Does not allocate.
  virtual Pose at(double time) noexcept = 0;
};

/// The hand means to follow a trajectory, whose start is time 0.
class IntendedTrajectory final : public IntendedMotion {
 public:
  explicit IntendedTrajectory(Trajectory trajectory) : trajectory_(std::move(trajectory)) {}

  Pose start() const noexcept override { return trajectory_.samples().front().X_WT; }
  Pose at(double time) noexcept override { return trajectory_.at(trajectory_.start() + time); }

 private:
  Trajectory trajectory_;
};

}  // namespace tegotae
