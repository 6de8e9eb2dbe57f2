// SPDX-License-Identifier: Apache-2.0
// Penetration of curved shapes against closed forms and against a search over directions.
#include <tegotae/contact/penetration.hpp>

#include <tests/contact/point_distance.hpp>
#include <tests/random_shapes.hpp>
#include <tests/sweep_size.hpp>

#include <gtest/gtest.h>

#include <functional>

namespace tegotae::test {
namespace {

TEST(PenetrationCurved, SpheresInClosedFormEvenConcentric) {
  const Shape a = make_sphere(0.3);
  const Shape b = make_sphere(0.5);
  std::mt19937_64 random(1);
  ClosestPointsCache cache;
  for (int i = 0; i < 1000; ++i) {
    const Vector3 between = uniform(random, 0.0, 0.9) * random_unit(random);
    const Penetration found = penetration({a, Pose{between, {}}}, {b, Pose{}}, cache);
    ASSERT_EQ(found.valid, between.norm() < 0.8);
    if (!found.valid) continue;
    ASSERT_NEAR(found.depth, 0.8 - between.norm(), 1e-14);
    ASSERT_LT((found.n_W - between.normalized()).norm(), 1e-12);
    ASSERT_LT((found.p_WB - 0.5 * found.n_W).norm(), 1e-13);
  }
  const Penetration concentric = penetration({a, Pose{}}, {b, Pose{}}, cache);
  ASSERT_TRUE(concentric.valid);
  EXPECT_NEAR(concentric.depth, 0.8, 1e-15);
  EXPECT_NEAR(concentric.n_W.norm(), 1.0, 1e-15);
}

TEST(PenetrationCurved, CapsulesWhoseAxesCrossOrCoincide) {
  const Shape a = make_capsule(0.1, 0.5);
  ClosestPointsCache cache;
  const Quaternion turned = rotation_from_vector(Vector3(0.7, 0.0, 0.0));
  const Penetration crossed = penetration({a, Pose{{0.0, 0.1, 0.1}, turned}}, {a, Pose{}}, cache);
  ASSERT_TRUE(crossed.valid);
  EXPECT_NEAR(crossed.depth, 0.2, 1e-14);
  EXPECT_NEAR(std::abs(crossed.n_W.x()), 1.0, 1e-14);
  const Penetration coincident = penetration({a, Pose{{0.0, 0.0, 0.3}, {}}}, {a, Pose{}}, cache);
  ASSERT_TRUE(coincident.valid);
  EXPECT_NEAR(coincident.depth, 0.2, 1e-14);
  EXPECT_NEAR(coincident.n_W.z(), 0.0, 1e-14);
}

TEST(PenetrationCurved, SphereInABoxInClosedForm) {
  const Vector3 half(0.2, 0.5, 0.9);
  const Shape box = make_box(half);
  const Shape ball = make_sphere(0.3);
  std::mt19937_64 random(2);
  ClosestPointsCache cache;
  for (int i = 0; i < sweep_size(5000); ++i) {
    const Pose X_WB = random_pose(random, 0.5);
    const Vector3 centre = random_vector(random, 1.0);
    const double outside = point_to_box(centre, half);
    const double depth = outside > 0.0 ? 0.3 - outside : 0.3 + (half - centre.cwiseAbs()).minCoeff();
    const Penetration found = penetration({ball, Pose{X_WB * centre, {}}}, {box, X_WB}, cache);
    ASSERT_EQ(found.valid, depth > 0.0);
    if (!found.valid) continue;
    ASSERT_NEAR(found.depth, depth, 1e-13) << "case " << i;
  }
}

struct Kind {
  Shape shape;
  std::function<double(const Vector3&)> reach;  // support value along a unit direction in the shape's frame
};

std::vector<Kind> kinds() {
  const Vector3 half(0.1, 0.2, 0.15);
  const Vector3 axes(0.08, 0.1, 0.15);
  return {{make_box(half), [=](const Vector3& n) { return n.cwiseAbs().dot(half); }},
          {make_capsule(0.05, 0.1), [](const Vector3& n) { return 0.05 + 0.1 * std::abs(n.z()); }},
          {make_cylinder(0.1, 0.08),
           [](const Vector3& n) { return 0.1 * std::hypot(n.x(), n.y()) + 0.08 * std::abs(n.z()); }},
          {make_ellipsoid(axes), [=](const Vector3& n) { return axes.cwiseProduct(n).norm(); }}};
}

// All kinds here are symmetric about their centres, so the depth along n follows from the reach.
double depth_along(const Kind& a, const Pose& X_WA, const Kind& b, const Pose& X_WB, const Vector3& n) {
  return a.reach(X_WA.q.conjugate() * n) + b.reach(X_WB.q.conjugate() * n) - n.dot(X_WA.p - X_WB.p);
}

TEST(PenetrationCurved, NoDirectionOfAFineSearchIsBetter) {
  const std::vector<Kind> all = kinds();
  std::mt19937_64 random(3);
  int valid = 0;
  for (int i = 0; i < sweep_size(400); ++i) {
    const Kind& a = all[random() % all.size()];
    const Kind& b = all[random() % all.size()];
    const Pose X_WA = random_pose(random, 0.1);
    const Pose X_WB = random_pose(random, 0.1);
    ClosestPointsCache cache;
    const Penetration found = penetration({a.shape, X_WA}, {b.shape, X_WB}, cache);
    if (!found.valid) continue;
    ++valid;
    ASSERT_NEAR(depth_along(a, X_WA, b, X_WB, found.n_W), found.depth, 1e-12);
    double least = found.depth;
    for (int k = 0; k < 5000; ++k) {
      least = std::min(least, depth_along(a, X_WA, b, X_WB, random_unit(random)));
    }
    for (double width = 0.1; width > 1e-7; width *= 0.7) {
      for (int k = 0; k < 20; ++k) {
        const Vector3 n = (found.n_W + width * random_unit(random)).normalized();
        least = std::min(least, depth_along(a, X_WA, b, X_WB, n));
      }
    }
    ASSERT_GT(least, found.depth - 1e-9) << name_of(a.shape.kind) << " and " << name_of(b.shape.kind);
  }
  EXPECT_GT(valid, sweep_size(200));
}

}  // namespace
}  // namespace tegotae::test
