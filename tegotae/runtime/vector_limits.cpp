// SPDX-License-Identifier: Apache-2.0
#include <tegotae/runtime/vector_limits.hpp>

#include <algorithm>
#include <limits>

namespace tegotae {

Vector3 growth_limited(const Vector3& target, const Vector3& previous, double step) noexcept {
  const double square = previous.squaredNorm();
  // A previous vector too small to be squared counts as zero: the segment is then a point.
  const bool has_direction = square >= std::numeric_limits<double>::min();
  const double along = has_direction ? std::clamp(target.dot(previous) / square, 0.0, 1.0) : 0.0;
  const Vector3 nearest = along * previous;
  const Vector3 beyond = target - nearest;
  const double distance = beyond.norm();
  if (distance <= step) return target;
  return nearest + beyond * (step / distance);
}

Vector3 saturated(const Vector3& target, double limit) noexcept {
  const double norm = target.norm();
  if (norm <= limit) return target;
  constexpr double kInward = 1.0 - 8.0 * std::numeric_limits<double>::epsilon();
  return target * (limit / norm * kInward);
}

}  // namespace tegotae
