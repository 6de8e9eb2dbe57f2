// SPDX-License-Identifier: Apache-2.0
// Curved shapes and planes against closed forms.
#include <tegotae/contact/closest_points.hpp>

#include <tests/contact/point_distance.hpp>
#include <tests/random_shapes.hpp>
#include <tests/sweep_size.hpp>

#include <gtest/gtest.h>

#include <functional>

namespace tegotae::test {
namespace {

// The distance of b's centre (or a point of its axis) from a shape at the identity, minus b's radius.
using Truth = std::function<double(const Pose& X_AB)>;

struct Tally {
  int separated = 0;
  int worst_iterations = 0;
};

// Random relative poses of a pair; `truth` is the signed or clipped distance: below `least` no distance is expected.
Tally expect_distances(const Shape& a, const Shape& b, const Truth& truth, double tolerance, double least = 1e-9) {
  std::mt19937_64 random(7);
  Tally tally;
  ClosestPointsCache cache;
  for (int i = 0; i < sweep_size(4000) && !::testing::Test::HasFailure(); ++i) {
    const Pose X_WA = random_pose(random, 1.0);
    const Pose X_AB = random_pose(random, 1.5);
    const ClosestPoints found = closest_points({a, X_WA}, {b, X_WA * X_AB}, cache);
    const double expected = truth(X_AB);
    tally.worst_iterations = std::max(tally.worst_iterations, found.iterations);
    if (found.separation == Separation::kSeparated) {
      ++tally.separated;
      EXPECT_NEAR(found.distance, expected, tolerance) << "case " << i;
      EXPECT_NEAR(found.lower_bound, expected, tolerance);
      EXPECT_NEAR((found.p_WA - found.p_WB).norm(), found.distance, 1e-11);
      EXPECT_NEAR(found.n_W.norm(), 1.0, 1e-14);
      EXPECT_NEAR(found.n_W.dot(found.p_WA - found.p_WB), found.distance, tolerance);
    } else {
      EXPECT_LT(expected, least) << "case " << i;
    }
  }
  EXPECT_GT(tally.separated, sweep_size(400));
  return tally;
}

TEST(ClosestPointsCurved, SphereAndSphere) {
  expect_distances(
      make_sphere(0.3), make_sphere(0.5), [](const Pose& X) { return X.p.norm() - 0.8; }, 1e-14);
}

TEST(ClosestPointsCurved, SphereAndBoxFromBothSides) {
  const Vector3 half(0.2, 0.5, 0.9);
  expect_distances(
      make_box(half), make_sphere(0.3), [&](const Pose& X) { return point_to_box(X.p, half) - 0.3; }, 1e-14);
  expect_distances(
      make_sphere(0.3), make_box(half), [&](const Pose& X) { return point_to_box(X.inverse().p, half) - 0.3; }, 1e-14);
}

TEST(ClosestPointsCurved, SphereAndHull) {
  const Vector3 half(0.2, 0.5, 0.9);
  std::vector<Vector3> corners;
  for (const double x : {-half.x(), half.x()}) {
    for (const double y : {-half.y(), half.y()}) {
      for (const double z : {-half.z(), half.z()}) corners.emplace_back(x, y, z);
    }
  }
  expect_distances(
      make_hull(corners), make_sphere(0.3), [&](const Pose& X) { return point_to_box(X.p, half) - 0.3; }, 1e-14);
}

TEST(ClosestPointsCurved, CapsuleAndSphere) {
  const Vector3 end(0.0, 0.0, 0.6);
  expect_distances(
      make_capsule(0.2, 0.6), make_sphere(0.3), [&](const Pose& X) { return point_to_segment(X.p, -end, end) - 0.5; },
      1e-14);
}

TEST(ClosestPointsCurved, CapsuleAndCapsule) {
  const Vector3 end_a(0.0, 0.0, 0.6);
  const Vector3 end_b(0.0, 0.0, 0.8);
  expect_distances(
      make_capsule(0.2, 0.6), make_capsule(0.1, 0.8),
      [&](const Pose& X) {
        return least_on_unit_interval(
                   [&](double t) { return point_to_segment(X * Vector3((2.0 * t - 1.0) * end_b), -end_a, end_a); }) -
               0.3;
      },
      1e-12);
}

TEST(ClosestPointsCurved, CapsuleAndBox) {
  const Vector3 half(0.2, 0.5, 0.9);
  const Vector3 end(0.0, 0.0, 0.6);
  expect_distances(
      make_box(half), make_capsule(0.2, 0.6),
      [&](const Pose& X) {
        return least_on_unit_interval(
                   [&](double t) { return point_to_box(X * Vector3((2.0 * t - 1.0) * end), half); }) -
               0.2;
      },
      1e-12);
}

TEST(ClosestPointsCurved, CylinderAndSphere) {
  expect_distances(
      make_cylinder(0.4, 0.6), make_sphere(0.2), [](const Pose& X) { return point_to_cylinder(X.p, 0.4, 0.6) - 0.2; },
      1e-11);
}

TEST(ClosestPointsCurved, CylinderAndCapsule) {
  const Vector3 end(0.0, 0.0, 0.5);
  expect_distances(
      make_cylinder(0.4, 0.6), make_capsule(0.2, 0.5),
      [&](const Pose& X) {
        return least_on_unit_interval(
                   [&](double t) { return point_to_cylinder(X * Vector3((2.0 * t - 1.0) * end), 0.4, 0.6); }) -
               0.2;
      },
      1e-11);
}

TEST(ClosestPointsCurved, EllipsoidAndSphere) {
  for (const Vector3& axes : {Vector3(0.3, 0.5, 0.9), Vector3(0.05, 0.8, 0.8), Vector3(0.05, 0.05, 1.0)}) {
    expect_distances(
        make_ellipsoid(axes), make_sphere(0.2), [&](const Pose& X) { return point_to_ellipsoid(X.p, axes) - 0.2; },
        1e-11);
  }
}

TEST(ClosestPointsCurved, EllipsoidAndCapsule) {
  const Vector3 axes(0.3, 0.5, 0.9);
  const Vector3 end(0.0, 0.0, 0.5);
  expect_distances(
      make_ellipsoid(axes), make_capsule(0.2, 0.5),
      [&](const Pose& X) {
        return least_on_unit_interval(
                   [&](double t) { return point_to_ellipsoid(X * Vector3((2.0 * t - 1.0) * end), axes); }) -
               0.2;
      },
      1e-11);
}

// Where no closed form is at hand the two bounds of the answer prove it: the witness points lie on the surfaces, and
// the support planes, evaluated in the test, lie as far apart.
double cylinder_reach(const Vector3& n, double radius, double half_height) {
  return radius * std::hypot(n.x(), n.y()) + half_height * std::abs(n.z());
}

TEST(ClosestPointsCurved, PairsOfCylindersEllipsoidsAndPolytopesAreProvenFromBothSides) {
  const Vector3 half(0.2, 0.5, 0.9);
  const Vector3 axes(0.3, 0.5, 0.9);
  struct Kind {
    Shape shape;
    std::function<double(const Vector3&)> reach;     // support value
    std::function<double(const Vector3&)> distance;  // of a point, 0 inside
  };
  const Kind kinds[] = {{make_box(half), [&](const Vector3& n) { return n.cwiseAbs().dot(half); },
                         [&](const Vector3& p) { return point_to_box(p, half); }},
                        {make_cylinder(0.4, 0.6), [](const Vector3& n) { return cylinder_reach(n, 0.4, 0.6); },
                         [](const Vector3& p) { return point_to_cylinder(p, 0.4, 0.6); }},
                        {make_ellipsoid(axes), [&](const Vector3& n) { return axes.cwiseProduct(n).norm(); },
                         [&](const Vector3& p) { return point_to_ellipsoid(p, axes); }}};
  std::mt19937_64 random(11);
  int separated = 0;
  for (int i = 0; i < sweep_size(20000) && !HasFailure(); ++i) {
    const Kind& a = kinds[random() % 3];
    const Kind& b = kinds[random() % 3];
    const Pose X_WA = random_pose(random, 1.0);
    const Pose X_WB = random_pose(random, 1.0);
    ClosestPointsCache cache;
    const ClosestPoints found = closest_points({a.shape, X_WA}, {b.shape, X_WB}, cache);
    if (found.separation != Separation::kSeparated) continue;
    ++separated;
    const double proven = found.n_W.dot(X_WA.p - X_WB.p) - a.reach(X_WA.q.conjugate() * found.n_W) -
                          b.reach(X_WB.q.conjugate() * found.n_W);
    EXPECT_NEAR(proven, found.lower_bound, 1e-13);
    EXPECT_NEAR(proven, found.distance, 1e-9) << "case " << i;
    EXPECT_NEAR(found.n_W.dot(found.p_WA - found.p_WB), found.distance, 1e-9);
    EXPECT_LT(a.distance(X_WA.inverse() * found.p_WA), 1e-12);
    EXPECT_LT(b.distance(X_WB.inverse() * found.p_WB), 1e-12);
  }
  EXPECT_GT(separated, sweep_size(4000));
}

TEST(ClosestPointsPlane, EveryKindAgainstItsReach) {
  const Vector3 size(0.2, 0.5, 0.9);
  struct Kind {
    Shape shape;
    std::function<double(const Vector3&)> reach;
  };
  const Kind kinds[] = {{make_box(size), [&](const Vector3& n) { return n.cwiseAbs().dot(size); }},
                        {make_sphere(0.3), [](const Vector3&) { return 0.3; }},
                        {make_capsule(0.3, 0.5), [](const Vector3& n) { return 0.3 + 0.5 * std::abs(n.z()); }},
                        {make_cylinder(0.4, 0.6), [](const Vector3& n) { return cylinder_reach(n, 0.4, 0.6); }},
                        {make_ellipsoid(size), [&](const Vector3& n) { return size.cwiseProduct(n).norm(); }}};
  std::mt19937_64 random(12);
  const Shape plane = make_plane();
  for (int i = 0; i < sweep_size(5000); ++i) {
    const Kind& kind = kinds[random() % 5];
    const Pose X_WA = random_pose(random, 1.0);
    const Pose X_WB = random_pose(random, 1.0);
    const Vector3 n = X_WB.q * Vector3::UnitZ();
    const double gap = n.dot(X_WA.p - X_WB.p) - kind.reach(X_WA.q.conjugate() * n);
    ClosestPointsCache cache;
    const ClosestPoints found = closest_points({kind.shape, X_WA}, {plane, X_WB}, cache);
    ASSERT_EQ(found.separation == Separation::kSeparated, gap > 0.0);
    ASSERT_NEAR(found.distance, gap, 1e-14);
    ASSERT_LT((found.n_W - n).norm(), 1e-14);
    ASSERT_LT((found.p_WA - found.p_WB - gap * n).norm(), 1e-14);
    ASSERT_NEAR(n.dot(found.p_WB - X_WB.p), 0.0, 1e-14);

    const ClosestPoints swapped = closest_points({plane, X_WB}, {kind.shape, X_WA}, cache);
    ASSERT_EQ(swapped.separation, found.separation);
    ASSERT_LT((swapped.n_W + n).norm(), 1e-14);
    ASSERT_LT((swapped.p_WA - found.p_WB).norm(), 1e-14);
    ASSERT_LT((swapped.p_WB - found.p_WA).norm(), 1e-14);
  }
}

TEST(ClosestPointsPlane, TwoPlanesHaveNoAnswer) {
  const Shape plane = make_plane();
  ClosestPointsCache cache;
  EXPECT_EQ(closest_points({plane, Pose{}}, {plane, Pose{{0.0, 0.0, -1.0}, {}}}, cache).separation,
            Separation::kNotSeparated);
}

}  // namespace
}  // namespace tegotae::test
