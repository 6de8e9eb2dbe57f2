// SPDX-License-Identifier: Apache-2.0
// What the proxy method shows between walls that oppose each other.
#include <tegotae/lab/tight_fits.hpp>
#include <tests/lab/performance.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tegotae {
namespace {

constexpr double kNoTorque = 0.0;

TEST(SlotNarrow, KeepsToTheReferenceWithoutChatter) {
  const Performance done = perform(find_experiment("slot-narrow"));
  expect_kept_to_reference(done, kNoTorque);
  EXPECT_GT(done.metrics.force.peak, 1.9);
  EXPECT_GT(done.metrics.torque.peak, 0.01);
  EXPECT_LE(done.metrics.force.worst, 0.01 * done.metrics.force.peak);
  for (const double begin : {0.1, 2.6, 4.9}) EXPECT_LE(chatter_between(done, begin, begin + 0.35).force, 0.02) << begin;
}

// Held 0.02 mm off the middle, the hand is pulled to the middle; on the rims it is carried by them.
TEST(SlotNarrow, PullsToTheMiddle) {
  const Performance done = perform(find_experiment("slot-narrow"));
  EXPECT_NEAR(at_time(done, 0.4).wrench.force.x, -2000.0 * 2e-5, 0.01 * 0.04);
  EXPECT_NEAR(at_time(done, 5.5).wrench.force.z, 2000.0 * 1.002e-3, 0.02);
}

class TightFit : public testing::TestWithParam<const char*> {};

TEST_P(TightFit, KeepsToTheReferenceWithinAHundredth) {
  const Performance done = perform(find_experiment(GetParam()));
  expect_kept_to_reference(done, kNoTorque);
  EXPECT_GT(done.metrics.force.peak, 0.3);
  EXPECT_GT(done.metrics.torque.peak, 5e-3);
  EXPECT_LE(done.metrics.force.worst, 0.01 * done.metrics.force.peak) << done.metrics.force.worst_time;
}

INSTANTIATE_TEST_SUITE_P(All, TightFit, testing::Values("slot-play", "wedge", "peg-in-hole"));

TEST(SlotPlay, HeldAtRestDoesNotChatter) {
  const Performance done = perform(find_experiment("slot-play"));
  EXPECT_LE(chatter_between(done, 3.31, 4.2).force, 0.02);
  // From the middle the block has 10 um less the skin.
  EXPECT_NEAR(at_time(done, 1.5).wrench.force.x, -2000.0 * (2e-4 - 8e-6), 0.004);
}

// Two walls at 5 degrees, the block on its lower edges: it is lifted to where it fits, the skin off both walls.
TEST(Wedge, HeldAtRestDoesNotChatterAndFits) {
  const Performance done = perform(find_experiment("wedge"));
  EXPECT_LE(chatter_between(done, 3.01, 3.8).force, 0.02);
  EXPECT_NEAR(at_time(done, 1.0).wrench.force.z, 2000.0 * (0.6e-3 + 2e-6 / std::sin(5.0 * std::numbers::pi / 180.0)),
              0.012);
}

TEST(PegInHole, SeatsAndFollowsTheWobbleWithoutSteps) {
  const Performance done = perform(find_experiment("peg-in-hole"));
  EXPECT_NEAR(at_time(done, 3.1).X_WP.p.z, 2e-6, 1e-6) << "30 mm deep, its half height";
  EXPECT_NEAR(at_time(done, 3.1).wrench.force.z, 2000.0 * 2.502e-3, 0.05);
  const Chatter entering = chatter_between(done, 0.9, 2.5), wobbled = chatter_between(done, 3.0, 5.4);
  EXPECT_LE(entering.torque, 5e-3);
  EXPECT_LE(wobbled.torque, 5e-3);
  for (const TickRecord& record : done.records) {
    ASSERT_LT((Vector3(record.X_WP.p) - Vector3(record.X_WT.p)).norm(), 3e-3) << record.time;
  }
}

}  // namespace
}  // namespace tegotae
