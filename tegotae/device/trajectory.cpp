// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/trajectory.hpp>

#include <tegotae/math/rotation.hpp>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace tegotae {

Trajectory::Trajectory(std::vector<Sample> samples) : samples_(std::move(samples)) {
  if (samples_.empty()) throw std::invalid_argument("a trajectory needs at least one sample");
  for (size_t i = 0; i < samples_.size(); ++i) {
    const std::string where = "trajectory sample " + std::to_string(i + 1);
    if (!std::isfinite(samples_[i].time) || !samples_[i].X_WT.is_finite()) {
      throw std::invalid_argument(where + " is not finite");
    }
    if (i > 0 && samples_[i].time <= samples_[i - 1].time) {
      throw std::invalid_argument(where + " is not later than the one before");
    }
  }
}

// The sample that ends the segment in which `time` lies, strictly inside or at its beginning.
std::vector<Trajectory::Sample>::const_iterator Trajectory::segment(double time) const noexcept {
  return std::upper_bound(samples_.begin(), samples_.end(), time,
                          [](double t, const Sample& sample) { return t < sample.time; });
}

Pose Trajectory::at(double time) const noexcept {
  const auto next = segment(time);
  if (next == samples_.begin()) return samples_.front().X_WT;
  if (next == samples_.end()) return samples_.back().X_WT;
  const auto last = next - 1;
  return interpolate(last->X_WT, next->X_WT, (time - last->time) / (next->time - last->time));
}

Twist Trajectory::twist_at(double time) const noexcept {
  const auto next = segment(time);
  if (next == samples_.begin() || next == samples_.end()) return {};
  const auto last = next - 1;
  const double duration = next->time - last->time;
  return {(next->X_WT.p - last->X_WT.p) / duration,
          rotation_vector(next->X_WT.q * last->X_WT.q.conjugate()) / duration};
}

}  // namespace tegotae
