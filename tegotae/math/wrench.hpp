// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/types.hpp>

namespace tegotae {

/// Force and torque about a stated point, in a stated frame (world unless a name says otherwise).
struct Wrench {
  Vector3 force = Vector3::Zero();   ///< N
  Vector3 torque = Vector3::Zero();  ///< N m

  /// The same wrench about another point: `arm` is the vector from the new point to the old one, m.
  Wrench shifted(const Vector3& arm) const noexcept { return {force, torque + arm.cross(force)}; }
  bool is_finite() const noexcept { return force.allFinite() && torque.allFinite(); }

  Wrench operator+(const Wrench& other) const noexcept { return {force + other.force, torque + other.torque}; }
  Wrench operator-(const Wrench& other) const noexcept { return {force - other.force, torque - other.torque}; }
  Wrench operator-() const noexcept { return {-force, -torque}; }
  Wrench operator*(double scale) const noexcept { return {scale * force, scale * torque}; }
};

}  // namespace tegotae
