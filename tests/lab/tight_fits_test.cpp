// SPDX-License-Identifier: Apache-2.0
// What the proxy method shows between walls that oppose each other.
#include <tegotae/lab/tight_fits.hpp>
#include <tests/lab/performance.hpp>

#include <gtest/gtest.h>

namespace tegotae {
namespace {

TEST(SlotNarrow, KeepsToTheReferenceWithoutChatter) {
  const Experiment& experiment = find_experiment("slot-narrow");
  const Performance done = perform(experiment, experiment.reference);
  const Comparison comparison = compare_with_reference(done);
  EXPECT_GT(comparison.force.compared, 5000U);
  EXPECT_GT(comparison.force.peak, 1.9);
  EXPECT_LE(comparison.force.worst, 0.01 * comparison.force.peak) << comparison.force.worst_at;
  EXPECT_GT(comparison.torque.peak, 0.01);
  EXPECT_LE(comparison.torque.worst, 0.01 * comparison.torque.peak) << comparison.torque.worst_at;
  EXPECT_LE(comparison.force.jump, 0.04) << comparison.force.jump_at;
  EXPECT_LE(comparison.torque.jump, 2e-3) << comparison.torque.jump_at;
  EXPECT_LE(comparison.ghost, 2e-3);
  for (const double begin : {0.1, 2.6, 4.9}) EXPECT_LE(chatter_between(done, begin, begin + 0.35).force, 0.02) << begin;
}

// Held 0.02 mm off the middle, the hand is pulled to the middle.
TEST(SlotNarrow, PullsToTheMiddle) {
  const Experiment& experiment = find_experiment("slot-narrow");
  const Performance done = perform(experiment, experiment.reference);
  EXPECT_NEAR(at_time(done, 0.4).wrench.force.x, -2000.0 * 2e-5, 0.01 * 0.04);
  EXPECT_NEAR(at_time(done, 5.5).wrench.force.z, 2000.0 * 1.002e-3, 0.02);
}

}  // namespace
}  // namespace tegotae
