// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/pose.hpp>

#include <algorithm>
#include <cmath>

namespace tegotae::test {

/// The separating-axis theorem for two boxes, in long double; shares nothing with the library.
class SeparatingAxis {
 public:
  SeparatingAxis(const Vector3& half_a, const Pose& X_WA, const Vector3& half_b, const Pose& X_WB)
      : half_a_(half_a),
        half_b_(half_b),
        A_(X_WA.q.cast<long double>().normalized().toRotationMatrix()),
        B_(X_WB.q.cast<long double>().normalized().toRotationMatrix()),
        between_(X_WA.p.cast<long double>() - X_WB.p.cast<long double>()) {}

  /// The gap between the boxes that the axis (any length) proves, m; negative: their shadows overlap by so much.
  double gap_along(const Vector3& axis) const { return static_cast<double>(gap(axis.cast<long double>())); }

  /// The greatest gap over the fifteen axes, m. The cross product of two edges that are parallel within an angle is
  /// known only to 1e-19 rad over that angle, which is why `gap_along` exists.
  double greatest_gap() const {
    long double greatest = -1e300L;
    for (int i = 0; i < 3; ++i) {
      greatest = std::max({greatest, gap(A_.col(i)), gap(B_.col(i))});
      for (int j = 0; j < 3; ++j) greatest = std::max(greatest, gap(A_.col(i).cross(B_.col(j))));
    }
    return static_cast<double>(greatest);
  }

 private:
  using Long3 = Eigen::Matrix<long double, 3, 1>;
  using LongMatrix3 = Eigen::Matrix<long double, 3, 3>;

  long double gap(const Long3& direction) const {
    const long double length = direction.norm();
    if (length < 1e-12L) return -1e300L;
    const Long3 axis = direction / length;
    long double reach = 0.0L;
    for (int k = 0; k < 3; ++k) {
      reach += std::abs(axis.dot(A_.col(k))) * static_cast<long double>(half_a_[k]) +
               std::abs(axis.dot(B_.col(k))) * static_cast<long double>(half_b_[k]);
    }
    return std::abs(axis.dot(between_)) - reach;
  }

  Vector3 half_a_, half_b_;
  LongMatrix3 A_, B_;
  Long3 between_;
};

}  // namespace tegotae::test
