// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/facing.hpp>

#include <tests/random_shapes.hpp>
#include <tests/sweep_size.hpp>

#include <gtest/gtest.h>

#include <vector>

namespace tegotae::test {
namespace {

Shape random_shape(std::mt19937_64& random, int kind) {
  const Vector3 size = Vector3(0.02, 0.02, 0.02) + random_vector(random, 0.015);
  switch (kind % 6) {
    case 0:
      return make_box(size);
    case 1:
      return make_sphere(size.x());
    case 2:
      return make_capsule(size.x(), size.y());
    case 3:
      return make_cylinder(size.x(), size.y());
    case 4:
      return make_ellipsoid(size);
    default:
      return make_hull(random_hull_points(random, 40, 0.03));
  }
}

// A few of each kind, as making them takes most of the time.
const Shape& some_shape(int i) {
  static const std::vector<Shape> shapes = [] {
    std::mt19937_64 random(30);
    std::vector<Shape> made;
    for (int k = 0; k < 36; ++k) made.push_back(random_shape(random, k));
    return made;
  }();
  return shapes[static_cast<size_t>(i) % shapes.size()];
}

TEST(Facing, AlongAnyDirectionTheGapIsALowerBoundOfTheDistance) {
  std::mt19937_64 random(31);
  int separated = 0;
  for (int i = 0; i < sweep_size(4000); ++i) {
    const Shape &a = some_shape(i), &b = some_shape(i / 36);
    const PlacedShape tool(a, random_pose(random, 0.08)), object(b, random_pose(random, 0.08));
    ClosestPointsCache cache, fresh;
    const Facing along = facing_along(tool, object, i % 5 == 0 ? Vector3::Zero() : random_unit(random), cache);
    EXPECT_TRUE(along.by_plane);
    EXPECT_NEAR(along.n_W.norm(), 1.0, 1e-12);
    EXPECT_NEAR(along.gap, along.n_W.dot(along.p_WA - along.p_WB), 1e-15);
    const ClosestPoints closest = closest_points(tool, object, fresh);
    if (closest.separation != Separation::kSeparated) {
      EXPECT_LT(along.gap, 1e-9) << i;
      continue;
    }
    ++separated;
    EXPECT_LE(along.gap, closest.distance + 1e-12) << i;
  }
  EXPECT_GT(separated, sweep_size(1000));
}

TEST(Facing, AlongTheMeasuredNormalItIsTheMeasuredGap) {
  std::mt19937_64 random(32);
  for (int i = 0; i < sweep_size(2000); ++i) {
    const Shape &a = some_shape(i), &b = some_shape(i / 36);
    const PlacedShape tool(a, random_pose(random, 0.06)), object(b, random_pose(random, 0.06));
    ClosestPointsCache cache;
    const Facing measured = measured_facing(tool, object, Vector3::Zero(), cache);
    EXPECT_FALSE(measured.by_plane);
    EXPECT_EQ(measured.separated, measured.gap > 0.0) << i;
    const Facing along = facing_along(tool, object, measured.n_W, cache);
    EXPECT_NEAR(along.gap, measured.gap, 1e-3 * std::abs(measured.gap) + 1e-9) << i;
  }
}

TEST(Facing, APlateIsLeftOnTheSideOfTheLastNormal) {
  const Shape tool_shape = make_box({0.02, 0.02, 0.02}), plate_shape = make_box({0.2, 0.2, 0.001});
  const PlacedShape tool(tool_shape, {{0.0, 0.0, -0.005}, Quaternion::Identity()}), plate(plate_shape, {});
  ClosestPointsCache cache;
  const Facing up = measured_facing(tool, plate, Vector3::UnitZ(), cache);
  EXPECT_NEAR(up.n_W.z(), 1.0, 1e-12);
  EXPECT_NEAR(up.gap, -0.026, 1e-12);
  EXPECT_NEAR(measured_facing(tool, plate, Vector3::Zero(), cache).gap, -0.016, 1e-12);
}

TEST(Facing, AHalfSpaceIsSupportedByItsOwnPlane) {
  const Shape ball = make_sphere(0.01), ground = make_plane({{0.0, 0.0, 0.1}, Quaternion::Identity()});
  const PlacedShape tool(ball, {{3.0, 2.0, 0.15}, Quaternion::Identity()}), object(ground, {});
  ClosestPointsCache cache;
  const Facing facing = facing_along(tool, object, Vector3::Zero(), cache);
  EXPECT_NEAR(facing.gap, 0.04, 1e-12);
  EXPECT_NEAR(facing.n_W.z(), 1.0, 1e-15);
}

}  // namespace
}  // namespace tegotae::test
