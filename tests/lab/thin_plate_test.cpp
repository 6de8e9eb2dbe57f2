// SPDX-License-Identifier: Apache-2.0
// What the proxy method shows on a plate of 1 mm.
#include <tegotae/lab/motion.hpp>
#include <tegotae/lab/thin_plate.hpp>
#include <tests/lab/performance.hpp>

#include <gtest/gtest.h>

#include <string>

namespace tegotae {
namespace {

class ThinPlate : public testing::TestWithParam<const char*> {
 protected:
  static double lowest(const Performance& done, const PlainPose& X) {
    const Pose pose = X.pose();
    return pose.p.z() + lowest_height(done.scene.tool, pose.q, Vector3::UnitZ());
  }
};

TEST_P(ThinPlate, KeepsToTheReference) {
  const Performance done = perform(find_experiment(GetParam()));
  expect_kept_to_reference(done, 0.0);
  EXPECT_NEAR(done.metrics.force.peak, 50.0, 0.1);
  EXPECT_GT(done.metrics.torque.peak, 0.1);
}

TEST_P(ThinPlate, IsNeverPoppedThrough) {
  const Performance done = perform(find_experiment(GetParam()));
  double deepest = 0.0;
  for (const TickRecord& record : done.records) {
    deepest = std::min(deepest, lowest(done, record.X_WT));
    ASSERT_GE(lowest(done, record.X_WP), 0.0) << record.time;
  }
  EXPECT_NEAR(deepest, -0.05, 1e-9) << "where the hand goes";
}

INSTANTIATE_TEST_SUITE_P(Both, ThinPlate, testing::Values("thin-plate-press", "thin-plate-strike"));

TEST(ThinPlateStrike, PassesThePlateAtOneMetreASecond) {
  const Performance done = perform(find_experiment("thin-plate-strike"));
  int strikes = 0;
  for (size_t i = 1; i < done.records.size(); ++i) {
    const auto below = [&](size_t tick) {
      const Pose X_WT = done.records[tick].X_WT.pose();
      return X_WT.p.z() + lowest_height(done.scene.tool, X_WT.q, Vector3::UnitZ()) <= 0.0;
    };
    if (below(i - 1) || !below(i)) continue;
    ++strikes;
    EXPECT_NEAR(done.records[i - 1].X_WT.p.z - done.records[i].X_WT.p.z, 1e-3, 1e-9);
  }
  EXPECT_EQ(strikes, 4);
}

}  // namespace
}  // namespace tegotae
