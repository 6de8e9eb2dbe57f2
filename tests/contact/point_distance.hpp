// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/types.hpp>

#include <algorithm>
#include <cmath>

namespace tegotae::test {

// Distances of a point from a shape in the shape's own frame, in closed form or by bisection; shares nothing with the
// library. All in metres, 0 inside.

inline double point_to_segment(const Vector3& p, const Vector3& a, const Vector3& b) {
  const double t = std::clamp((p - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
  return (p - a - t * (b - a)).norm();
}

inline double point_to_box(const Vector3& p, const Vector3& half) { return (p.cwiseAbs() - half).cwiseMax(0.0).norm(); }

inline double point_to_cylinder(const Vector3& p, double radius, double half_height) {
  const double across = std::max(std::hypot(p.x(), p.y()) - radius, 0.0);
  const double along = std::max(std::abs(p.z()) - half_height, 0.0);
  return std::hypot(across, along);
}

/// The foot x of a point p outside satisfies p - x = t grad: x_i = a_i^2 p_i / (a_i^2 + t) with t > 0 the root of
/// sum (a_i p_i / (a_i^2 + t))^2 = 1, which falls with t.
inline double point_to_ellipsoid(const Vector3& p, const Vector3& axes) {
  const auto excess = [&](double t) {
    double sum = -1.0;
    for (int i = 0; i < 3; ++i) sum += std::pow(axes[i] * p[i] / (axes[i] * axes[i] + t), 2);
    return sum;
  };
  if (excess(0.0) <= 0.0) return 0.0;
  double low = 0.0;
  double high = axes.maxCoeff() * p.norm();
  for (int k = 0; k < 80; ++k) {
    const double middle = 0.5 * (low + high);
    (excess(middle) > 0.0 ? low : high) = middle;
  }
  Vector3 foot;
  for (int i = 0; i < 3; ++i) foot[i] = axes[i] * axes[i] * p[i] / (axes[i] * axes[i] + low);
  return (p - foot).norm();
}

/// Least value over [0, 1] of a convex function, by golden sections.
template <typename Function>
double least_on_unit_interval(Function function) {
  constexpr double kGolden = 0.6180339887498949;
  double low = 0.0;
  double high = 1.0;
  for (int k = 0; k < 70; ++k) {
    const double a = high - kGolden * (high - low);
    const double b = low + kGolden * (high - low);
    (function(a) < function(b) ? high : low) = function(a) < function(b) ? b : a;
  }
  return function(0.5 * (low + high));
}

}  // namespace tegotae::test
