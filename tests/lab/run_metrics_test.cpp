// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/pose_penetration.hpp>
#include <tegotae/lab/run_metrics.hpp>
#include <tegotae/math/rotation.hpp>
#include <tegotae/render/render_types.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace tegotae {
namespace {

/// A cube of 0.2 m over the half-space z <= 0, beside a post of 0.1 m that stands at x = 1.
SceneGeometry cube_floor_and_post() {
  SceneGeometry scene;
  scene.tool.pieces = {make_box({0.1, 0.1, 0.1})};
  Body floor, post;
  floor.pieces = {make_plane()};
  post.pieces = {make_box({0.05, 0.05, 0.5})};
  post.X_WB.p = {1.0, 0.0, 0.5};
  scene.bodies = {floor, post};
  return scene;
}

Pose at(double x, double z, double tilt = 0.0) { return {{x, 0.0, z}, rotation_from_vector(tilt * Vector3::UnitY())}; }

TEST(PosePenetration, IsTheDepthOfTheDeepestPair) {
  const SceneGeometry scene = cube_floor_and_post();
  PosePenetration penetration(scene);
  EXPECT_EQ(penetration.at(at(0.0, 0.1 + 1e-6)), 0.0);
  EXPECT_NEAR(penetration.at(at(0.0, 0.1 - 2e-6)), 2e-6, 1e-12);
  EXPECT_NEAR(penetration.at(at(0.0, 0.1 * std::sqrt(2.0) - 3e-4, std::numbers::pi / 4.0)), 3e-4, 1e-12);
  EXPECT_NEAR(penetration.at(at(0.86, 0.4)), 0.01, 1e-12);
  EXPECT_NEAR(penetration.at(at(0.86, 0.08)), 0.02, 1e-12);  // the floor is deeper
  EXPECT_EQ(penetration.at(at(0.8, 0.4)), 0.0);
}

TEST(PosePenetration, LeavesOutWhatMovesAndWhatMayNotTouch) {
  SceneGeometry scene = cube_floor_and_post();
  scene.bodies[1].moving_index = 0;
  scene.bodies[0].pieces[0].contact_type = scene.bodies[0].pieces[0].contact_affinity = 2;
  PosePenetration penetration(scene);
  EXPECT_EQ(penetration.at(at(1.0, 0.0)), 0.0);
}

TEST(PosePenetration, OfAPoseThatIsNotFiniteIsInfinite) {
  const SceneGeometry scene = cube_floor_and_post();
  EXPECT_TRUE(std::isinf(PosePenetration(scene).at(at(std::numeric_limits<double>::quiet_NaN(), 0.0))));
}

TEST(RunMetrics, OfARunByHand) {
  const SceneGeometry scene = cube_floor_and_post();
  SessionSettings settings;
  settings.stiffness = 1000.0;
  // The hand rises by 1 mm under 2 N, which is more than a spring of 1000 N/m gives, and is then free.
  std::vector<TickRecord> records(3);
  records[0].X_WT = at(0.0, 0.099);
  records[0].wrench = Wrench{{0.0, 0.0, 2.0}, Vector3::Zero()};
  records[0].X_WP = at(0.0, 0.1 - 5e-6);
  records[0].tick_us = 7.0;
  records[1].X_WT = records[2].X_WT = at(0.0, 0.1);
  records[1].X_WP = records[2].X_WP = at(0.0, 0.1 + 1e-6);
  records[1].status = static_cast<std::uint8_t>(RenderStatus::kIterationLimit);
  for (TickRecord& record : records) record.displayed = Wrench{{0.0, 0.0, -50.0}, Vector3::Zero()};  // of no account
  const RunMetrics metrics = run_metrics(records, scene, settings);
  EXPECT_NEAR(metrics.proxy_penetration, 5e-6, 1e-12);
  EXPECT_NEAR(metrics.energy_given, 2e-3, 1e-15);
  EXPECT_NEAR(metrics.energy_own, 0.5 * 1000.0 * 1e-6, 1e-15);
  EXPECT_NEAR(metrics.energy_excess, 1.5e-3, 1e-15);
  EXPECT_EQ(metrics.not_ok, 1);
  EXPECT_EQ(metrics.tick_times.count(), 3U);
  EXPECT_NEAR(metrics.tick_times.max(), 7e-6, 1e-12);
}

}  // namespace
}  // namespace tegotae
