// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/pose_history.hpp>

#include <algorithm>

namespace tegotae {

void PoseHistory::add(double time, const Pose& X) noexcept {
  readings_[count_ % kReadings] = {time, X};
  ++count_;
}

Twist PoseHistory::velocity(double window) const noexcept {
  if (count_ < 2) return {};
  const Reading& newest = back(0);
  const std::size_t kept = std::min(count_, kReadings);
  std::size_t readings = 1;
  while (readings + 1 < kept && newest.time - back(readings + 1).time <= window + kTimeRounding) ++readings;
  const Reading& before = back(readings);
  const double span = newest.time - before.time;
  if (!(span > 0.0)) return {};
  const Vector6 way = displacement(before.X, newest.X, Vector3::Zero());
  return {way.head<3>() / span, way.tail<3>() / span};
}

}  // namespace tegotae
