// SPDX-License-Identifier: Apache-2.0
#include <tegotae/contact/penetration.hpp>

#include <tests/contact/minkowski_faces.hpp>
#include <tests/contact/separating_axis.hpp>
#include <tests/contact/support_plane.hpp>
#include <tests/random_shapes.hpp>
#include <tests/sweep_size.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace tegotae::test {
namespace {

Pose moved(const Pose& X, const Vector3& by) { return {X.p + by, X.q}; }

// What every valid answer promises for polytopes: the depth is the overlap along n, translation by it parts, by less
// does not, and the witness points are on the surfaces.
void expect_parts(const Shape& a, const Pose& X_WA, const Shape& b, const Pose& X_WB, const Penetration& found) {
  ASSERT_TRUE(found.valid);
  ASSERT_NEAR(found.n_W.norm(), 1.0, 1e-13);
  ASSERT_NEAR(-support_plane_gap(a, X_WA, b, X_WB, found.n_W), found.depth, 1e-12);
  ASSERT_LT((found.p_WB - found.p_WA - found.depth * found.n_W).norm(), 1e-14);
  ASSERT_LT(height_over_surface(a, X_WA, found.p_WA), 1e-11);
  ASSERT_LT(height_over_surface(b, X_WB, found.p_WB), 1e-11);
  if (found.depth < 1e-6) return;
  ClosestPointsCache cache;
  const Pose beyond = moved(X_WA, (found.depth * (1.0 + 1e-9) + 1e-10) * found.n_W);
  ASSERT_EQ(closest_points({a, beyond}, {b, X_WB}, cache).separation, Separation::kSeparated);
  const Pose within = moved(X_WA, 0.999 * found.depth * found.n_W);
  ASSERT_EQ(closest_points({a, within}, {b, X_WB}, cache).separation, Separation::kNotSeparated);
}

TEST(Penetration, BoxesAgainstTheSeparatingAxis) {
  std::mt19937_64 random(1);
  int valid = 0;
  for (int i = 0; i < sweep_size(6000) && !HasFailure(); ++i) {
    Vector3 half_a(uniform(random, 0.05, 1.0), uniform(random, 0.05, 1.0), uniform(random, 0.05, 1.0));
    Vector3 half_b(uniform(random, 0.05, 1.0), uniform(random, 0.05, 1.0), uniform(random, 0.05, 1.0));
    if (i % 5 == 0) half_a[i % 3] = 1e-3;
    const Pose X_WA = random_pose(random, 0.5);
    Pose X_WB = random_pose(random, 0.5);
    if (i % 4 == 0) X_WB.q = X_WA.q;
    if (i % 8 == 0) {
      X_WB.p = X_WA.p;
      half_b = half_a;
    }
    const SeparatingAxis truth(half_a, X_WA, half_b, X_WB);
    const double gap = truth.greatest_gap();
    const Shape a = make_box(half_a);
    const Shape b = make_box(half_b);
    ClosestPointsCache cache;
    const Penetration found = penetration({a, X_WA}, {b, X_WB}, cache);
    if (gap > 1e-8) {
      EXPECT_FALSE(found.valid);
      continue;
    }
    ++valid;
    ASSERT_NEAR(found.depth, -gap, 1e-12) << "case " << i;
    ASSERT_NO_FATAL_FAILURE(expect_parts(a, X_WA, b, X_WB, found)) << "case " << i;
  }
  EXPECT_GT(valid, sweep_size(1200));
}

TEST(Penetration, HullsAgainstAllFacesOfTheMinkowskiDifference) {
  std::mt19937_64 random(2);
  for (int i = 0; i < sweep_size(2000) && !HasFailure(); ++i) {
    const Shape a = make_hull(random_hull_points(random, 8 + i % 20, 0.5));
    const Shape b = i % 2 == 0 ? make_hull(random_hull_points(random, 8 + i % 13, 0.5)) : make_box({0.3, 0.2, 0.1});
    const Pose X_WA = random_pose(random, 0.2);
    const Pose X_WB = random_pose(random, 0.2);
    const double depth = least_depth_over_faces(a, X_WA, b, X_WB);
    ClosestPointsCache cache;
    const Penetration found = penetration({a, X_WA}, {b, X_WB}, cache);
    if (depth < -1e-8) {
      EXPECT_FALSE(found.valid);
      continue;
    }
    ASSERT_NEAR(found.depth, depth, 1e-12) << "case " << i;
    ASSERT_NO_FATAL_FAILURE(expect_parts(a, X_WA, b, X_WB, found)) << "case " << i;
  }
}

TEST(Penetration, LargeHullsEvenWhereTheCapacityEndsPart) {
  std::mt19937_64 random(3);
  const Shape a = make_hull(random_hull_points(random, 230, 0.1));
  const Shape b = make_hull(random_hull_points(random, 2000, 0.1));
  for (int i = 0; i < sweep_size(500) && !HasFailure(); ++i) {
    const Pose X_WA = random_pose(random, 0.03);
    const Pose X_WB = random_pose(random, 0.03);
    ClosestPointsCache cache;
    const Penetration found = penetration({a, X_WA}, {b, X_WB}, cache);
    ASSERT_TRUE(found.valid);
    ASSERT_NO_FATAL_FAILURE(expect_parts(a, X_WA, b, X_WB, found)) << "case " << i;
  }
}

TEST(Penetration, TouchingFlatAndDuplicatedGeometry) {
  const Shape cube = make_box({0.1, 0.1, 0.1});
  const Shape plate = make_box({0.1, 0.1, 1e-4});
  ClosestPointsCache cache;
  for (const double overlap : {0.0, 1e-16, 1e-12, 1e-9, 1e-6}) {
    for (const Vector3& across : {Vector3(0.0, 0.0, 0.0), Vector3(0.2, 0.0, 0.0), Vector3(0.03, 0.2, 0.0)}) {
      const Pose X_WA = {Vector3(across.x(), across.y(), 0.2 - overlap), {}};
      const Penetration found = penetration({cube, X_WA}, {cube, Pose{}}, cache);
      ASSERT_TRUE(found.valid);
      EXPECT_NEAR(found.depth, across.norm() > 0.15 ? 0.0 : overlap, 1e-14);
    }
  }
  const Penetration coincident = penetration({cube, Pose{}}, {cube, Pose{}}, cache);
  ASSERT_TRUE(coincident.valid);
  EXPECT_NEAR(coincident.depth, 0.2, 1e-14);
  const Penetration through = penetration({plate, Pose{}}, {plate, Pose{}}, cache);
  ASSERT_TRUE(through.valid);
  EXPECT_NEAR(through.depth, 2e-4, 1e-15);
}

TEST(Penetration, PlaneInClosedForm) {
  const Shape cube = make_box({0.1, 0.1, 0.1});
  const Shape plane = make_plane();
  ClosestPointsCache cache;
  const Pose sunk = {{0.3, 0.2, 0.07}, {}};
  const Penetration found = penetration({cube, sunk}, {plane, Pose{}}, cache);
  ASSERT_TRUE(found.valid);
  EXPECT_NEAR(found.depth, 0.03, 1e-15);
  EXPECT_LT((found.n_W - Vector3::UnitZ()).norm(), 1e-15);
  EXPECT_NEAR(found.p_WA.z(), -0.03, 1e-15);
  EXPECT_NEAR(found.p_WB.z(), 0.0, 1e-15);
  const Penetration swapped = penetration_from({plane, Pose{}}, {cube, sunk}, Vector3::UnitX(), cache);
  ASSERT_TRUE(swapped.valid);
  EXPECT_LT((swapped.n_W + Vector3::UnitZ()).norm(), 1e-15);
  EXPECT_NEAR(swapped.p_WA.z(), 0.0, 1e-15);
  EXPECT_NEAR(swapped.p_WB.z(), -0.03, 1e-15);
  EXPECT_FALSE(penetration({cube, Pose{{0.0, 0.0, 0.2}, {}}}, {plane, Pose{}}, cache).valid);
  EXPECT_FALSE(penetration({plane, Pose{}}, {plane, Pose{}}, cache).valid);
}

TEST(Penetration, NotANumberIsInvalid) {
  const Shape cube = make_box({0.1, 0.1, 0.1});
  const Shape ball = make_sphere(0.1);
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Shape* shape : {&cube, &ball}) {
    for (const Pose& X : {Pose{{nan, 0.0, 0.0}, {}}, Pose{{0.0, 0.0, 0.0}, {nan, 0.0, 0.0, 1.0}}}) {
      ClosestPointsCache cache;
      EXPECT_FALSE(penetration({*shape, X}, {cube, Pose{}}, cache).valid);
      EXPECT_FALSE(penetration({cube, Pose{}}, {*shape, X}, cache).valid);
      EXPECT_FALSE(penetration_from({*shape, X}, {cube, Pose{}}, Vector3::UnitZ(), cache).valid);
      EXPECT_EQ(closest_points({*shape, X}, {cube, Pose{}}, cache).separation, Separation::kNotSeparated);
      EXPECT_EQ(closest_points({cube, Pose{}}, {*shape, X}, cache).separation, Separation::kNotSeparated);
    }
    ClosestPointsCache cache;
    EXPECT_FALSE(penetration_from({*shape, Pose{}}, {cube, Pose{}}, Vector3::Zero(), cache).valid);
    EXPECT_FALSE(penetration_from({*shape, Pose{}}, {cube, Pose{}}, Vector3::Constant(nan), cache).valid);
  }
}

}  // namespace
}  // namespace tegotae::test
