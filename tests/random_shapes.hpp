// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/rotation.hpp>
#include <tegotae/shape/shape.hpp>

#include <random>
#include <vector>

namespace tegotae::test {

inline double uniform(std::mt19937_64& random, double lower, double upper) {
  return std::uniform_real_distribution<double>(lower, upper)(random);
}

inline Vector3 random_vector(std::mt19937_64& random, double half_range) {
  std::uniform_real_distribution<double> coordinate(-half_range, half_range);
  const double x = coordinate(random), y = coordinate(random), z = coordinate(random);
  return {x, y, z};
}

inline Vector3 random_unit(std::mt19937_64& random) {
  Vector3 v = random_vector(random, 1.0);
  while (v.norm() < 0.1 || v.norm() > 1.0) v = random_vector(random, 1.0);
  return v.normalized();
}

inline Quaternion random_rotation(std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  const double w = normal(random), x = normal(random), y = normal(random), z = normal(random);
  return Quaternion(w, x, y, z).normalized();
}

inline Pose random_pose(std::mt19937_64& random, double half_range) {
  const Vector3 p = random_vector(random, half_range);
  return {p, random_rotation(random)};
}

/// `count` points on an ellipsoid of random semi-axes between 0.3 and 1 times `size`: all are extreme.
inline std::vector<Vector3> random_hull_points(std::mt19937_64& random, int count, double size) {
  std::uniform_real_distribution<double> axis(0.3 * size, size);
  const double a = axis(random), b = axis(random), c = axis(random);
  std::vector<Vector3> points;
  for (int i = 0; i < count; ++i) points.emplace_back(random_unit(random).cwiseProduct(Vector3(a, b, c)));
  return points;
}

}  // namespace tegotae::test
