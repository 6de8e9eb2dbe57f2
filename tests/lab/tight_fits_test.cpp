// SPDX-License-Identifier: Apache-2.0
// What the proxy method shows between walls that oppose each other.
#include <tegotae/lab/tight_fits.hpp>
#include <tests/lab/performance.hpp>

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace tegotae
