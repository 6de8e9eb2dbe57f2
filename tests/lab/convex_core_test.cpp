// SPDX-License-Identifier: Apache-2.0
#include <tests/lab/reference_task.hpp>

#include <tegotae/lab/convex_core.hpp>

#include <tests/lab/placed_core.hpp>

#include <gtest/gtest.h>

namespace tegotae {
namespace {

TEST(ConvexCore, RoundShapesAreFewPointsAndARadius) {
  const ConvexCore ball = core_of(make_sphere(0.03, placed_at(1, 2, 3)));
  ASSERT_EQ(ball.vertices.size(), 1u);
  EXPECT_EQ(ball.vertices[0], Vector3(1, 2, 3));
  EXPECT_EQ(ball.radius, 0.03);
  const ConvexCore capsule = core_of(make_capsule(0.01, 0.2));
  ASSERT_EQ(capsule.vertices.size(), 2u);
  EXPECT_EQ((capsule.vertices[0] - capsule.vertices[1]).norm(), 0.4);
  EXPECT_EQ(core_of(make_box({1, 2, 3})).vertices.size(), 8u);
  EXPECT_EQ(core_of(make_box({1, 2, 3})).radius, 0.0);
}

TEST(ConvexCore, IsPlacedByTheShapeThenByTheBody) {
  const Shape shape = make_box({0.1, 0.2, 0.3}, placed_at(1, 0, 0, {0.0, 0.0, 90.0}));
  const ConvexCore core = test::placed_core(shape, placed_at(0, 0, 5, {90.0, 0.0, 0.0}));
  // Half edges along the body's axes: 0.2, 0.1, 0.3; in the world: 0.2, 0.3, 0.1.
  EXPECT_NEAR(core.box.lower.x(), 0.8, 1e-12);
  EXPECT_NEAR(core.box.upper.y(), 0.3, 1e-12);
  EXPECT_NEAR(core.box.upper.z(), 5.1, 1e-12);
  EXPECT_NEAR(greatest_along(core, Vector3::UnitZ()), 5.1, 1e-12);
  EXPECT_EQ(core.face_normals.size(), 6u);
}

TEST(ConvexCore, GapCountsRadiiOfBothSides) {
  const ConvexCore above = test::placed_core(make_sphere(0.02), placed_at(0, 0, 0.1));
  EXPECT_NEAR(gap_along(above, test::placed_core(make_sphere(0.03), Pose{}), Vector3::UnitZ()), 0.05, 1e-12);
  EXPECT_NEAR(gap_along(above, test::placed_core(make_sphere(0.03), Pose{}), Vector3::UnitX()), -0.05, 1e-12);
  EXPECT_NEAR(gap_along(above, test::placed_core(make_plane(placed_at(3, 4, 0.09)), Pose{}), Vector3::UnitZ()), -0.01,
              1e-12);
}

TEST(ConvexCore, BoxOfARoundShapeHasItsRadius) {
  const ConvexCore capsule = test::placed_core(make_capsule(0.01, 0.2), Pose{});
  EXPECT_NEAR(capsule.box.upper.z(), 0.21, 1e-12);
  EXPECT_NEAR(capsule.box.lower.x(), -0.01, 1e-12);
}

}  // namespace
}  // namespace tegotae
