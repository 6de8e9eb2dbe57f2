// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/pose.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace tegotae::testing {

/// Two boxes by the fifteen axes of the separating-axis theorem, in long double; shares nothing with the library.
struct SeparatingAxis {
  double gap = -1e300;             ///< greatest separation over all axes, m; negative: they overlap by -gap
  Vector3 axis = Vector3::Zero();  ///< unit, from b to a
};

inline SeparatingAxis separating_axis(const Vector3& half_a, const Pose& X_WA, const Vector3& half_b,
                                      const Pose& X_WB) {
  using Long3 = Eigen::Matrix<long double, 3, 1>;
  using LongMatrix3 = Eigen::Matrix<long double, 3, 3>;
  const LongMatrix3 A = X_WA.q.cast<long double>().normalized().toRotationMatrix();
  const LongMatrix3 B = X_WB.q.cast<long double>().normalized().toRotationMatrix();
  const Long3 between = X_WA.p.cast<long double>() - X_WB.p.cast<long double>();
  SeparatingAxis best;
  long double greatest = -1e300L;
  const auto consider = [&](Long3 axis) {
    const long double length = axis.norm();
    if (length < 1e-12L) return;
    axis /= length;
    if (axis.dot(between) < 0.0L) axis = -axis;
    long double reach = 0.0L;
    for (int k = 0; k < 3; ++k) {
      reach += std::abs(axis.dot(A.col(k))) * static_cast<long double>(half_a[k]) +
               std::abs(axis.dot(B.col(k))) * static_cast<long double>(half_b[k]);
    }
    const long double gap = axis.dot(between) - reach;
    if (gap > greatest) {
      greatest = gap;
      best.axis = axis.cast<double>();
    }
  };
  for (int i = 0; i < 3; ++i) {
    consider(A.col(i));
    consider(B.col(i));
    for (int j = 0; j < 3; ++j) consider(A.col(i).cross(B.col(j)));
  }
  best.gap = static_cast<double>(greatest);
  return best;
}

}  // namespace tegotae::testing
