// SPDX-License-Identifier: Apache-2.0
#include <tegotae/runtime/vector_limits.hpp>

#include <tests/random_shapes.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tegotae {
namespace {

using test::random_unit;
using test::random_vector;

double log_uniform(std::mt19937_64& random, double low_power, double high_power) {
  return std::pow(10.0, std::uniform_real_distribution<double>(low_power, high_power)(random));
}

// Distance from `point` to the segment from zero to `end`, by way of the triangle (not the projection under test).
double distance_to_segment(const Vector3& point, const Vector3& end) {
  const double length = end.norm();
  if (length == 0.0 || point.dot(end) <= 0.0) return point.norm();
  if ((point - end).dot(end) >= 0.0) return (point - end).norm();
  return point.cross(end).norm() / length;
}

TEST(GrowthLimited, KeepsItsLawOverRandomVectors) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 200'000; ++i) {
    const Vector3 previous = log_uniform(random, -6, 3) * random_unit(random);
    const Vector3 target = log_uniform(random, -6, 6) * random_unit(random);
    const double step = log_uniform(random, -6, 3);
    const Vector3 result = growth_limited(target, previous, step);
    const double rounding = 1e-14 * (previous.norm() + step);
    ASSERT_LE(result.norm(), previous.norm() + step + rounding) << "magnitude grows by the step at most";
    ASSERT_LE(distance_to_segment(result, previous), step + rounding);
    ASSERT_LE(result.norm(), std::max(target.norm(), previous.norm()) + rounding);
    if (distance_to_segment(target, previous) < step * (1.0 - 1e-9)) {
      ASSERT_EQ(result, target) << "bit for bit within the limit";
    }
  }
}

TEST(GrowthLimited, IsNearestAmongTheAllowed) {
  std::mt19937_64 random(2);
  std::uniform_real_distribution<double> fraction(0.0, 1.0);
  for (int i = 0; i < 20'000; ++i) {
    const Vector3 previous = random_vector(random, 2.0), target = random_vector(random, 5.0);
    const double step = log_uniform(random, -3, 0.5);
    const double distance = (growth_limited(target, previous, step) - target).norm();
    const Vector3 allowed = fraction(random) * previous + fraction(random) * step * random_unit(random);
    ASSERT_LE(distance, (allowed - target).norm() + 1e-12);
  }
}

TEST(GrowthLimited, IsContinuous) {
  std::mt19937_64 random(3);
  for (int i = 0; i < 20'000; ++i) {
    const Vector3 previous = random_vector(random, 2.0), a = random_vector(random, 5.0);
    const Vector3 b = a + log_uniform(random, -9, 0) * random_unit(random);
    const double step = log_uniform(random, -3, 0.5);
    const double moved = (growth_limited(a, previous, step) - growth_limited(b, previous, step)).norm();
    ASSERT_LE(moved, (a - b).norm() + 1e-13);
  }
}

TEST(GrowthLimited, GrowsAlongTheDirectionReleasesFreelyAndReversesThroughZero) {
  const Vector3 x = Vector3::UnitX(), y = Vector3::UnitY();
  EXPECT_EQ(growth_limited(10.0 * x, 2.0 * x, 0.5), 2.5 * x);
  EXPECT_EQ(growth_limited(10.0 * y, Vector3::Zero(), 0.5), 0.5 * y);
  EXPECT_EQ(growth_limited(Vector3::Zero(), 100.0 * x, 0.5), Vector3::Zero());
  EXPECT_EQ(growth_limited(1.0 * x, 100.0 * x, 0.0), 1.0 * x);
  EXPECT_EQ(growth_limited(-10.0 * x, 100.0 * x, 0.5), -0.5 * x);
  EXPECT_EQ(growth_limited(10.0 * x + 10.0 * y, 10.0 * x, 0.5), 10.0 * x + 0.5 * y);
}

TEST(GrowthLimited, ExtremeMagnitudesStayFinite) {
  constexpr double kDenormal = 1e-310, kTiny = 1e-200, kHuge = 1e149;
  for (const double a : {0.0, kDenormal, kTiny, 1.0, kHuge}) {
    for (const double b : {0.0, kDenormal, kTiny, 1.0, kHuge}) {
      for (const double step : {0.0, kDenormal, kTiny, 1.0, kHuge}) {
        const Vector3 result = growth_limited(Vector3(a, -a, a), Vector3(b, b, -b), step);
        EXPECT_TRUE(result.allFinite()) << a << " " << b << " " << step;
      }
    }
  }
}

TEST(Saturated, NeverExceedsTheLimitAndKeepsTheDirection) {
  std::mt19937_64 random(4);
  for (int i = 0; i < 200'000; ++i) {
    const Vector3 target = log_uniform(random, -6, 6) * random_unit(random);
    const double limit = log_uniform(random, -3, 3);
    const Vector3 result = saturated(target, limit);
    ASSERT_LE(result.norm(), limit);
    if (target.norm() <= limit) {
      ASSERT_EQ(result, target);
    } else {
      ASSERT_GE(result.norm(), limit * (1.0 - 1e-14));
      ASSERT_LT(result.cross(target).norm(), 1e-15 * target.norm() * limit);
      ASSERT_GT(result.dot(target), 0.0);
    }
  }
}

TEST(Saturated, ZeroLimitGivesZero) { EXPECT_EQ(saturated(Vector3(1.0, 2.0, 3.0), 0.0), Vector3::Zero()); }

}  // namespace
}  // namespace tegotae
