// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/types.hpp>

namespace tegotae {

/// Velocity of a rigid body: linear velocity of a stated point (its frame's origin unless a name says otherwise)
/// and angular velocity, both in world axes.
struct Twist {
  Vector3 linear = Vector3::Zero();   ///< m/s
  Vector3 angular = Vector3::Zero();  ///< rad/s

  /// Velocity of the body point at `arm` (m) from the twist's own point.
  Vector3 at(const Vector3& arm) const noexcept { return linear + angular.cross(arm); }
  bool is_finite() const noexcept { return linear.allFinite() && angular.allFinite(); }
};

}  // namespace tegotae
