// SPDX-License-Identifier: Apache-2.0
#include <tegotae/contact/closest_points.hpp>
#include <tegotae/lab/separating_plane.hpp>
#include <tegotae/math/rotation.hpp>

#include <tests/lab/placed_core.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

namespace tegotae {
namespace {

Pose moved_to(double x, double y, double z) { return Pose{.p = {x, y, z}}; }

double widest_gap(const ConvexCore& above, const ConvexCore& below) {
  return gap_along(above, below, widest_gap_normal(above, below));
}

TEST(SeparatingPlane, GapOfBoxesIsTheirDistance) {
  const ConvexCore below = test::placed_core(make_box({0.1, 0.2, 0.3}), Pose{});
  const Shape small = make_box(Vector3::Constant(0.01));
  EXPECT_NEAR(widest_gap(test::placed_core(small, moved_to(0.0, 0.0, 0.315)), below), 0.005, 1e-9);    // faces
  EXPECT_NEAR(widest_gap(test::placed_core(small, moved_to(0.113, 0.214, 0.0)), below), 0.005, 1e-8);  // edges
  EXPECT_NEAR(widest_gap(test::placed_core(small, moved_to(0.112, 0.213, 0.316)), below), std::sqrt(49e-6),
              1e-8);                                                                                       // corners
  EXPECT_NEAR(widest_gap(test::placed_core(small, moved_to(0.0, 0.0, 0.31 + 2e-6)), below), 2e-6, 1e-12);  // a skin
}

TEST(SeparatingPlane, OverlapIsTheLeastThatPartsThem) {
  const ConvexCore below = test::placed_core(make_box({0.1, 0.1, 0.1}), Pose{});
  const ConvexCore above = test::placed_core(make_box({0.05, 0.05, 0.05}), moved_to(0.02, 0.01, 0.147));
  const Vector3 n = widest_gap_normal(above, below);
  EXPECT_LT((n - Vector3::UnitZ()).norm(), 1e-6);
  EXPECT_NEAR(gap_along(above, below, n), -0.003, 1e-9);
}

TEST(SeparatingPlane, RoundShapesAreAsFarAsTheirAxesLessTheirRadii) {
  const ConvexCore capsule = test::placed_core(make_capsule(0.01, 0.05), Pose{});
  EXPECT_NEAR(widest_gap(test::placed_core(make_sphere(0.02), moved_to(0.033, 0.0, 0.01)), capsule), 0.003, 1e-9);
  EXPECT_NEAR(widest_gap(test::placed_core(make_sphere(0.02), moved_to(0.03, 0.0, 0.09)), capsule), 0.02, 1e-8);
}

TEST(SeparatingPlane, HalfSpaceKeepsItsOwnNormal) {
  const Pose X_WB{{0.0, 0.0, 0.1}, rotation_from_vector({0.3, -0.2, 0.1})};
  const ConvexCore below = test::placed_core(make_plane(), X_WB);
  const ConvexCore above = test::placed_core(make_sphere(0.02), Pose{X_WB * Vector3(0.1, 0.2, 0.025)});
  EXPECT_LT((widest_gap_normal(above, below) - X_WB.q * Vector3::UnitZ()).norm(), 1e-12);
  EXPECT_NEAR(widest_gap(above, below), 0.005, 1e-12);
}

// Against the library's distance of closest points, which reaches it from the other side.
TEST(SeparatingPlane, GapOfRandomHullsIsTheirDistance) {
  std::mt19937 engine(11);
  std::normal_distribution<double> normal;
  const auto vector = [&](double scale) -> Vector3 {
    return Vector3(normal(engine), normal(engine), normal(engine)) * scale;
  };
  int apart = 0;
  for (int trial = 0; trial < 200; ++trial) {
    std::vector<Vector3> points[2];
    for (auto& cloud : points)
      for (int i = 0; i < 20; ++i) cloud.push_back(vector(0.02));
    const Shape a = make_hull(points[0]), b = make_hull(points[1]);
    const Pose X_WA{vector(0.05), rotation_from_vector(vector(1.0))};
    ClosestPointsCache cache;
    const ClosestPoints closest = closest_points(PlacedShape(a, X_WA), PlacedShape(b, Pose{}), cache);
    const double gap = widest_gap(test::placed_core(a, X_WA), test::placed_core(b, Pose{}));
    if (closest.separation != Separation::kSeparated) {
      EXPECT_LE(gap, 0.0);
      continue;
    }
    ++apart;
    EXPECT_NEAR(gap, closest.distance, 1e-5 * closest.distance + 1e-9) << "trial " << trial;
  }
  EXPECT_GT(apart, 50);
}

}  // namespace
}  // namespace tegotae
