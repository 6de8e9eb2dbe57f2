// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/trajectory.hpp>
#include <tegotae/model/scene_geometry.hpp>

#include <functional>

namespace tegotae {

/// A value that changes from `from` to `to` between the times `begin` and `end` (s) and is held before and after: the
/// polynomial of degree 5 with no velocity and no acceleration at both ends, as a hand moves (Flash and Hogan 1985).
struct SmoothStep {
  double begin = 0.0, end = 1.0;
  double from = 0.0, to = 1.0;

  double at(double time) const noexcept;
};

/// Height of the tool's lowest point above its frame's origin, along `up_W` (unit), m, the tool turned by `q_WT`.
/// Negative where the origin lies inside the tool.
double lowest_height(const Tool& tool, const Quaternion& q_WT, const Vector3& up_W);

/// Samples `pose` from `begin` to `end` (s) at 1 kHz, both included.
Trajectory sampled(double begin, double end, const std::function<Pose(double)>& pose);

}  // namespace tegotae
