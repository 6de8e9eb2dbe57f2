// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/motion.hpp>

#include <tegotae/shape/support.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

namespace tegotae {

double SmoothStep::at(double time) const noexcept {
  const double u = std::clamp((time - begin) / (end - begin), 0.0, 1.0);
  // Counted from the nearer end, so that the value reaches `to` exactly and nears it with full precision.
  const auto rise = [](double v) { return v * v * v * (10.0 + v * (-15.0 + v * 6.0)); };
  return u <= 0.5 ? from + (to - from) * rise(u) : to - (to - from) * rise(1.0 - u);
}

double lowest_height(const Tool& tool, const Quaternion& q_WT, const Vector3& up_W) {
  const Vector3 down_T = q_WT.conjugate() * Vector3(-up_W);
  double lowest = std::numeric_limits<double>::infinity();
  for (const Shape& piece : tool.pieces) {
    const Vector3 p_T = piece.X_BS * support(piece, piece.X_BS.q.conjugate() * down_T).p;
    lowest = std::min(lowest, -down_T.dot(p_T));
  }
  return lowest;
}

Trajectory sampled(double begin, double end, const std::function<Pose(double)>& pose) {
  constexpr double kPeriod = 1e-3;
  std::vector<Trajectory::Sample> samples;
  const long count = std::lround((end - begin) / kPeriod);
  for (long i = 0; i <= count; ++i) {
    const double time = begin + static_cast<double>(i) * kPeriod;
    samples.push_back({time, pose(time)});
  }
  return Trajectory(std::move(samples));
}

}  // namespace tegotae
