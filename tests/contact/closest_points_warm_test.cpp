// SPDX-License-Identifier: Apache-2.0
// A warm start changes the time, never the answer.
#include <tegotae/contact/closest_points.hpp>
#include <tegotae/contact/penetration.hpp>

#include <tests/allocation_counter.hpp>
#include <tests/random_shapes.hpp>
#include <tests/sweep_size.hpp>

#include <gtest/gtest.h>

#include <type_traits>

namespace tegotae::test {
namespace {

std::vector<Shape> all_bounded_kinds() {
  std::mt19937_64 random(1);
  return {make_box({0.1, 0.2, 0.15}),
          make_sphere(0.1),
          make_capsule(0.05, 0.1),
          make_cylinder(0.1, 0.08),
          make_ellipsoid({0.08, 0.1, 0.15}),
          make_hull(random_hull_points(random, 18, 0.2)),
          make_hull(random_hull_points(random, 230, 0.2))};
}

// One tick of about 0.1 m/s and 1 rad/s; now and then a jump to anywhere.
void step(Pose& X, std::mt19937_64& random) {
  if (random() % 100 == 0) {
    X = random_pose(random, 0.3);
    return;
  }
  X.p += 1e-4 * random_unit(random);
  X.q = (rotation_from_vector(Vector3(1e-3 * random_unit(random))) * X.q).normalized();
}

TEST(ClosestPointsWarm, SameAsColdAlongTrajectoriesWithJumps) {
  std::mt19937_64 random(2);
  const std::vector<Shape> shapes = all_bounded_kinds();
  int separated = 0;
  for (const Shape& a : shapes) {
    for (const Shape& b : shapes) {
      // Curved pairs end where rounding ends them, which depends a little on the way there.
      const bool smooth = a.kind == ShapeKind::kCylinder || b.kind == ShapeKind::kCylinder ||
                          a.kind == ShapeKind::kEllipsoid || b.kind == ShapeKind::kEllipsoid;
      const double tolerance = smooth ? 1e-10 : 1e-12;
      Pose X_WA = random_pose(random, 0.3);
      ClosestPointsCache warm;
      for (int tick = 0; tick < sweep_size(1000); ++tick) {
        step(X_WA, random);
        ClosestPointsCache cold;
        const ClosestPoints with = closest_points({a, X_WA}, {b, Pose{}}, warm);
        const ClosestPoints without = closest_points({a, X_WA}, {b, Pose{}}, cold);
        ASSERT_EQ(with.separation, without.separation);
        if (with.separation != Separation::kSeparated) continue;
        ++separated;
        ASSERT_NEAR(with.distance, without.distance, tolerance) << name_of(a.kind) << " and " << name_of(b.kind);
        if (with.distance > 1e-4) {
          ASSERT_LT((with.n_W - without.n_W).norm(), 1e-4);
        }
      }
    }
  }
  EXPECT_GT(separated, sweep_size(15000));
}

TEST(ClosestPointsWarm, CoherentMotionTakesFewerPassesThanColdStarts) {
  std::mt19937_64 random(3);
  const Shape a = make_hull(random_hull_points(random, 230, 0.2));
  const Shape b = make_box({0.1, 0.2, 0.15});
  Pose X_WA = {{0.0, 0.0, 0.5}, random_rotation(random)};
  ClosestPointsCache warm;
  closest_points({a, X_WA}, {b, Pose{}}, warm);
  int with = 0, without = 0;
  for (int tick = 0; tick < 1000; ++tick) {
    X_WA.p += 1e-4 * random_unit(random);
    X_WA.q = (rotation_from_vector(Vector3(1e-3 * random_unit(random))) * X_WA.q).normalized();
    ClosestPointsCache cold;
    with += closest_points({a, X_WA}, {b, Pose{}}, warm).iterations;
    without += closest_points({a, X_WA}, {b, Pose{}}, cold).iterations;
  }
  EXPECT_LT(with, 1300);
  EXPECT_GT(without, 3 * with);
}

TEST(ClosestPointsWarm, ForeignAndBrokenCachesDoNoHarm) {
  std::mt19937_64 random(4);
  const std::vector<Shape> shapes = all_bounded_kinds();
  ClosestPointsCache shared;
  for (int i = 0; i < sweep_size(20000); ++i) {
    const Shape& a = shapes[random() % shapes.size()];
    const Shape& b = shapes[random() % shapes.size()];
    const Pose X_WA = random_pose(random, 0.4);
    if (i % 3 == 0) {
      shared.vertex_count = static_cast<int>(random() % 11) - 3;
      for (int k = 0; k < 4; ++k) {
        shared.vertex_tool[static_cast<size_t>(k)] = static_cast<int>(random() % 400) - 50;
        shared.vertex_object[static_cast<size_t>(k)] = static_cast<int>(random() % 3);
      }
      shared.hint_tool = static_cast<int>(random() % 4000) - 2000;
      shared.hint_object = -1;
      shared.direction = i % 2 == 0 ? Vector3(Vector3::Constant(std::nan(""))) : Vector3(Vector3::Zero());
    }
    ClosestPointsCache cold;
    const ClosestPoints with = closest_points({a, X_WA}, {b, Pose{}}, shared);
    const ClosestPoints without = closest_points({a, X_WA}, {b, Pose{}}, cold);
    ASSERT_EQ(with.separation, without.separation);
    if (with.separation == Separation::kSeparated) {
      ASSERT_NEAR(with.distance, without.distance, 1e-10);
    }
    ClosestPointsCache copy = shared;
    const Penetration overlap = penetration({a, X_WA}, {b, Pose{}}, copy);
    ASSERT_EQ(with.separation == Separation::kNotSeparated, overlap.valid);
  }
}

TEST(ClosestPointsWarm, QueriesDoNotAllocate) {
  static_assert(std::is_trivially_destructible_v<ClosestPointsCache>);
  static_assert(noexcept(closest_points(std::declval<const PlacedShape&>(), std::declval<const PlacedShape&>(),
                                        std::declval<ClosestPointsCache&>())));
  std::mt19937_64 random(5);
  std::vector<Shape> shapes = all_bounded_kinds();
  shapes.push_back(make_plane());
  ClosestPointsCache cache;
  for (const Shape& a : shapes) {
    for (const Shape& b : shapes) {
      for (int i = 0; i < 20; ++i) {
        const PlacedShape tool(a, random_pose(random, 0.2));
        const PlacedShape object(b, random_pose(random, 0.2));
        const AllocationCounter counter;
        const ClosestPoints apart = closest_points(tool, object, cache);
        const Penetration global = penetration(tool, object, cache);
        const Penetration local = penetration_from(tool, object, Vector3::UnitX(), cache);
        ASSERT_EQ(counter.count(), 0U);
        if (apart.separation == Separation::kNotSeparated) {
          ASSERT_EQ(global.valid, local.valid);
        }
      }
    }
  }
}

}  // namespace
}  // namespace tegotae::test
