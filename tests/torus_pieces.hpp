// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/rotation.hpp>
#include <tegotae/model/scene_geometry.hpp>

#include <cmath>
#include <numbers>
#include <vector>

// A body and a tool of many convex pieces, as a split mesh gives them.
namespace tegotae::test {

inline constexpr double kTorusRadius = 0.06, kTorusTube = 0.02;  // m

/// A torus about z cut into `sectors` around it and `wedges` around its tube: each piece is the hull of two wedges of
/// the tube's cross-section, at its two ends.
inline std::vector<Shape> torus_pieces(int sectors, int wedges) {
  const auto corner = [&](double sector, double wedge, double radius) {
    const double around = 2.0 * std::numbers::pi * sector / sectors, about = 2.0 * std::numbers::pi * wedge / wedges;
    const double reach = kTorusRadius + radius * std::cos(about);
    return Vector3(reach * std::cos(around), reach * std::sin(around), radius * std::sin(about));
  };
  std::vector<Shape> pieces;
  for (int s = 0; s < sectors; ++s) {
    for (int w = 0; w < wedges; ++w) {
      std::vector<Vector3> points;
      for (const int end : {s, s + 1}) {
        points.push_back(corner(end, w, 0.0));
        points.push_back(corner(end, w, kTorusTube));
        points.push_back(corner(end, w + 1, kTorusTube));
      }
      pieces.push_back(make_hull(points));
    }
  }
  return pieces;
}

/// A comb along x, its teeth of 8 mm pointing down: `count` boxes, the last one the back.
inline std::vector<Shape> comb_pieces(int count) {
  std::vector<Shape> pieces;
  const int teeth = count - 1;
  for (int i = 0; i < teeth; ++i) {
    pieces.push_back(
        make_box({0.003, 0.004, 0.008}, {{0.01 * (i - 0.5 * (teeth - 1)), 0.0, 0.0}, Quaternion::Identity()}));
  }
  pieces.push_back(make_box({0.005 * teeth, 0.006, 0.002}, {{0.0, 0.0, 0.01}, Quaternion::Identity()}));
  return pieces;
}

}  // namespace tegotae::test
