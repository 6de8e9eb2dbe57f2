// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/pose.hpp>

namespace tegotae {

/// A pose from MuJoCo's arrays: position (m) and unit quaternion, w first, of element `index`.
inline Pose pose_from(const double* positions, const double* quaternions, int index) noexcept {
  const double* p = positions + 3 * static_cast<std::ptrdiff_t>(index);
  const double* q = quaternions + 4 * static_cast<std::ptrdiff_t>(index);
  return {{p[0], p[1], p[2]}, Quaternion(q[0], q[1], q[2], q[3]).normalized()};
}

/// Writes a pose into MuJoCo's arrays as element `index`.
inline void write_pose(const Pose& X, double* positions, double* quaternions, int index) noexcept {
  double* p = positions + 3 * static_cast<std::ptrdiff_t>(index);
  double* q = quaternions + 4 * static_cast<std::ptrdiff_t>(index);
  for (int k = 0; k < 3; ++k) p[k] = X.p[k];
  q[0] = X.q.w(), q[1] = X.q.x(), q[2] = X.q.y(), q[3] = X.q.z();
}

inline Vector3 vector_from(const double* values, int index) noexcept {
  const double* v = values + 3 * static_cast<std::ptrdiff_t>(index);
  return {v[0], v[1], v[2]};
}

}  // namespace tegotae
