// SPDX-License-Identifier: Apache-2.0
// The local query: coherent from step to step, where the global one changes sides.
#include <tegotae/contact/penetration.hpp>

#include <tests/contact/support_plane.hpp>
#include <tests/random_shapes.hpp>
#include <tests/sweep_size.hpp>

#include <gtest/gtest.h>

namespace tegotae::test {
namespace {

TEST(PenetrationFrom, ThinPlateKeepsItsSideBeyondHalfItsThickness) {
  const Shape cube = make_box({0.1, 0.1, 0.1});
  const Shape plate = make_box({0.5, 0.5, 5e-4});
  ClosestPointsCache cache;
  Vector3 n = Vector3::UnitZ();
  for (double depth = 1e-5; depth < 0.05; depth += 1e-4) {
    const Pose X_WA = {{0.03, 0.02, 0.1005 - depth}, rotation_from_vector(Vector3(0.0, 0.0, 0.3))};
    const Penetration local = penetration_from({cube, X_WA}, {plate, Pose{}}, n, cache);
    ASSERT_TRUE(local.valid);
    ASSERT_NEAR(local.depth, depth, 1e-12);
    ASSERT_LT((local.n_W - Vector3::UnitZ()).norm(), 1e-12);
    n = local.n_W;
  }
  const Pose through = {{0.03, 0.02, -0.09}, {}};
  const Penetration global = penetration({cube, through}, {plate, Pose{}}, cache);
  ASSERT_TRUE(global.valid);
  EXPECT_NEAR(global.n_W.z(), -1.0, 1e-12);
}

// Started from the global minimum it stays; from anywhere it ends no deeper than it began, in a local minimum.
TEST(PenetrationFrom, NeverRisesAndEndsInALocalMinimum) {
  std::mt19937_64 random(2);
  for (int i = 0; i < sweep_size(1200); ++i) {
    const Shape a = make_hull(random_hull_points(random, 20, 0.3));
    const Shape b = make_box({0.3, 0.2, 0.1});
    const Pose X_WA = random_pose(random, 0.15);
    const Pose X_WB = random_pose(random, 0.15);
    ClosestPointsCache cache;
    const Penetration global = penetration({a, X_WA}, {b, X_WB}, cache);
    if (!global.valid) continue;
    const Penetration same = penetration_from({a, X_WA}, {b, X_WB}, global.n_W, cache);
    ASSERT_NEAR(same.depth, global.depth, 1e-13);
    const Vector3 start = random_unit(random);
    const Penetration local = penetration_from({a, X_WA}, {b, X_WB}, 3.0 * start, cache);
    ASSERT_TRUE(local.valid);
    ASSERT_GE(local.depth, global.depth - 1e-13);
    ASSERT_LE(local.depth, -support_plane_gap(a, X_WA, b, X_WB, start) + 1e-13);
    ASSERT_NEAR(local.depth, -support_plane_gap(a, X_WA, b, X_WB, local.n_W), 1e-12);
    for (int k = 0; k < 30; ++k) {
      const Vector3 beside = (local.n_W + 1e-5 * random_unit(random)).normalized();
      ASSERT_GT(-support_plane_gap(a, X_WA, b, X_WB, beside), local.depth - 1e-12) << "case " << i;
    }
  }
}

// A cube rolled over on a floor slab while it stays pressed in: depth and normal change continuously.
TEST(PenetrationFrom, DepthIsContinuousWhileTheToolRolls) {
  const Shape cube = make_box({0.1, 0.1, 0.1});
  const Shape slab = make_box({1.0, 1.0, 0.05});
  ClosestPointsCache cache;
  Vector3 n = Vector3::UnitZ();
  for (double angle = 0.0; angle < 3.2; angle += 1e-3) {
    const double reach = 0.1 * (std::abs(std::sin(angle)) + std::abs(std::cos(angle)));
    const Pose X_WA = {{0.1 * angle, 0.0, 0.05 + reach - 0.08}, rotation_from_vector(Vector3(0.0, angle, 0.0))};
    const Penetration found = penetration_from({cube, X_WA}, {slab, Pose{}}, n, cache);
    ASSERT_NEAR(found.depth, 0.08, 1e-12);
    ASSERT_NEAR(found.p_WB.z(), 0.05, 1e-12);
    n = found.n_W;
    ASSERT_LT((n - Vector3::UnitZ()).norm(), 1e-12);
  }
}

}  // namespace
}  // namespace tegotae::test
