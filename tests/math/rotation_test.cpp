// SPDX-License-Identifier: Apache-2.0
#include <tegotae/math/rotation.hpp>

#include <gtest/gtest.h>

#include <numbers>
#include <random>

namespace tegotae {
namespace {

Vector3 random_vector(std::mt19937& random, double scale) {
  std::uniform_real_distribution<double> uniform(-scale, scale);
  return {uniform(random), uniform(random), uniform(random)};
}

TEST(Rotation, SkewIsTheCrossProduct) {
  std::mt19937 random(1);
  for (int i = 0; i < 100; ++i) {
    const Vector3 a = random_vector(random, 1.0), b = random_vector(random, 1.0);
    EXPECT_LT((skew(a) * b - a.cross(b)).norm(), 1e-15);
  }
}

TEST(Rotation, VectorAndQuaternionAreInverseToEachOther) {
  std::mt19937 random(2);
  for (const double scale : {1e-12, 1e-6, 1e-3, 1.0, 1.8}) {
    for (int i = 0; i < 200; ++i) {
      const Vector3 theta = random_vector(random, scale);
      if (theta.norm() > std::numbers::pi) continue;
      const Quaternion q = rotation_from_vector(theta);
      EXPECT_NEAR(q.norm(), 1.0, 1e-15);
      EXPECT_LT((rotation_vector(q) - theta).norm(), 1e-15 + 1e-13 * theta.norm());
      EXPECT_LT((rotation_vector(Quaternion(-q.w(), -q.x(), -q.y(), -q.z())) - theta).norm(),
                1e-15 + 1e-13 * theta.norm());
    }
  }
}

TEST(Rotation, SmallAngleSeriesJoinsTheExactFormula) {
  const Vector3 axis = Vector3(1.0, 2.0, -2.0) / 3.0;
  const Quaternion below = rotation_from_vector(0.99999e-4 * axis), above = rotation_from_vector(1.00001e-4 * axis);
  EXPECT_NEAR(below.vec().norm(), 0.5 * 0.99999e-4, 1e-13);
  EXPECT_NEAR(above.vec().norm(), 0.5 * 1.00001e-4, 1e-13);
}

TEST(Rotation, PerpendicularIsUnitAndPerpendicular) {
  std::mt19937 random(3);
  for (int i = 0; i < 100; ++i) {
    const Vector3 n = random_vector(random, 1.0).normalized();
    const Vector3 u = any_perpendicular(n);
    EXPECT_NEAR(u.norm(), 1.0, 1e-14);
    EXPECT_NEAR(u.dot(n), 0.0, 1e-14);
  }
}

}  // namespace
}  // namespace tegotae
