// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/display_summary.hpp>
#include <tegotae/math/rotation.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace tegotae {
namespace {

TickRecord displayed(const Wrench& commanded, const Wrench& error, bool falls_short) {
  TickRecord record;
  record.displayed = commanded;
  record.interface_wrench = commanded + error;
  record.falls_short = falls_short;
  return record;
}

TEST(DisplaySummary, SpreadsTheDifferenceAndKeepsShortfallsApart) {
  const Wrench commanded{{0.0, 4.0, 3.0}, {0.0, 0.5, 0.0}};
  std::vector<TickRecord> records = {displayed(commanded, {{3e-3, 0.0, 4e-3}, {1e-3, 0.0, 0.0}}, false),
                                     displayed(commanded, {}, false),
                                     displayed(commanded, {{0.0, -2.0, 0.0}, {0.0, -0.1, 0.0}}, true)};
  records[1].X_WT = Pose{{0.0, 0.0, 0.1}, Quaternion::Identity()};
  records[1].X_WH = Pose{{0.0, 0.0, 0.106}, rotation_from_vector({0.2, 0.0, 0.0})};
  const DisplaySummary summary = display_summary(records);
  EXPECT_EQ(summary.all.ticks, 3);
  EXPECT_EQ(summary.reachable.ticks, 2);
  EXPECT_EQ(summary.shortfalls, 1);
  EXPECT_NEAR(summary.reachable.force_rms, 5e-3 / std::sqrt(2.0), 1e-12);
  EXPECT_NEAR(summary.reachable.force_max, 5e-3, 1e-12);
  EXPECT_NEAR(summary.reachable.torque_max, 1e-3, 1e-12);
  EXPECT_NEAR(summary.all.force_max, 2.0, 1e-12);
  EXPECT_NEAR(summary.all.torque_rms, std::sqrt((1e-6 + 1e-2) / 3.0), 1e-12);
  EXPECT_EQ(summary.greatest_force, 5.0);
  EXPECT_EQ(summary.greatest_torque, 0.5);
  EXPECT_NEAR(summary.hand_way, 6e-3, 1e-12);
  EXPECT_NEAR(summary.hand_angle, 0.2, 1e-12);
}

TEST(DisplaySummary, OfNothingIsZero) {
  const DisplaySummary summary = display_summary({});
  EXPECT_EQ(summary.all.ticks, 0);
  EXPECT_EQ(summary.all.force_rms, 0.0);
}

}  // namespace
}  // namespace tegotae
