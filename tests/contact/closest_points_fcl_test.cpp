// SPDX-License-Identifier: Apache-2.0
// Random pairs of polytopes against an independent library: FCL with its libccd backend.
#include <tegotae/contact/closest_points.hpp>

#include <tests/contact/fcl_shapes.hpp>
#include <tests/contact/support_plane.hpp>
#include <tests/random_shapes.hpp>
#include <tests/sweep_size.hpp>

#include <gtest/gtest.h>

namespace tegotae::test {
namespace {

struct TwinShape {
  Shape shape;
  std::shared_ptr<fcl::CollisionGeometryd> twin;
};

std::vector<TwinShape> random_twins(std::mt19937_64& random) {
  std::uniform_int_distribution<int> count(8, 60);
  std::uniform_real_distribution<double> half(0.2, 1.0);
  std::vector<TwinShape> twins;
  for (int i = 0; i < 60; ++i) {
    Shape shape = i % 3 == 0 ? make_box({half(random), half(random), half(random)})
                             : make_hull(random_hull_points(random, count(random), 1.0));
    auto twin = fcl_geometry(shape);
    twins.push_back({std::move(shape), std::move(twin)});
  }
  return twins;
}

struct Disagreements {
  int we_err = 0;
  int fcl_errs = 0;
};

// A distance is right when witness points prove it from above and a support plane from below, both evaluated here by
// brute force. Where ours is proven, a different answer of FCL's is FCL's error.
void compare(const TwinShape& a, const Pose& X_WA, const TwinShape& b, const Pose& X_WB, Disagreements& count) {
  ClosestPointsCache cache;
  const ClosestPoints ours = closest_points({a.shape, X_WA}, {b.shape, X_WB}, cache);
  const double theirs = fcl_distance(*a.twin, fcl_pose(X_WA), *b.twin, fcl_pose(X_WB));
  const bool apart = ours.separation == Separation::kSeparated;
  if (apart) {
    const double proven = support_plane_gap(a.shape, X_WA, b.shape, X_WB, ours.n_W);
    ASSERT_NEAR(proven, ours.distance, 1e-9);
    ASSERT_NEAR(proven, ours.lower_bound, 1e-12);
    ASSERT_NEAR((ours.p_WA - ours.p_WB).norm(), ours.distance, 1e-12);
    ASSERT_LT(height_over_surface(a.shape, X_WA, ours.p_WA), 1e-12);
    ASSERT_LT(height_over_surface(b.shape, X_WB, ours.p_WB), 1e-12);
    if (std::abs(theirs - ours.distance) > 1e-9) ++count.fcl_errs;
  } else if (theirs > 1e-9) {
    ++count.we_err;
  }
}

TEST(ClosestPointsAgainstFcl, RandomPolytopePairs) {
  std::mt19937_64 random(20);
  const std::vector<TwinShape> twins = random_twins(random);
  std::uniform_int_distribution<size_t> pick(0, twins.size() - 1);
  std::uniform_real_distribution<double> spread(0.3, 2.5);
  Disagreements count;
  int apart = 0;
  const int pairs = sweep_size(100000);
  for (int i = 0; i < pairs; ++i) {
    const TwinShape& a = twins[pick(random)];
    const TwinShape& b = twins[pick(random)];
    const Pose X_WA = random_pose(random, 0.2);
    const Pose X_WB = {X_WA.p + spread(random) * random_unit(random), random_rotation(random)};
    ClosestPointsCache cache;
    if (closest_points({a.shape, X_WA}, {b.shape, X_WB}, cache).separation == Separation::kSeparated) ++apart;
    ASSERT_NO_FATAL_FAILURE(compare(a, X_WA, b, X_WB, count));
  }
  EXPECT_GT(apart, pairs / 5);
  EXPECT_LT(apart, pairs * 4 / 5);
  EXPECT_EQ(count.we_err, 0);
  EXPECT_EQ(count.fcl_errs, 0);
}

}  // namespace
}  // namespace tegotae::test
