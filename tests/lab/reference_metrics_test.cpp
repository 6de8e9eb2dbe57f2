// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/reference_metrics.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace tegotae {
namespace {

/// Ticks of 1 ms whose forces (along z) and torques (about x) are given, and the reference's.
struct HandMadeRun {
  std::vector<TickRecord> records;
  std::vector<ReferenceSample> reference;

  void add(double force, double reference_force, double torque = 0.0, double reference_torque = 0.0) {
    TickRecord record;
    record.time = 1e-3 * static_cast<double>(records.size());
    record.wrench = Wrench{{0.0, 0.0, force}, {torque, 0.0, 0.0}};
    record.displayed = Wrench{{0.0, 0.0, 1e3}, {1e3, 0.0, 0.0}};  // of no account
    records.push_back(record);
    ReferenceSample sample;
    sample.wrench = {{0.0, 0.0, reference_force}, {reference_torque, 0.0, 0.0}};
    sample.touches = reference_force != 0.0;
    reference.push_back(sample);
  }
  ReferenceMetrics metrics() const { return reference_metrics(records, reference); }
};

TEST(ReferenceMetrics, OfARunByHand) {
  HandMadeRun run;
  run.add(0.0, 0.0);
  run.add(3.0, 2.0, 0.1, 0.3);
  run.add(4.0, 4.0, 0.4, 0.4);
  run.add(2.0, 5.0, 0.5, 0.4);
  const ReferenceMetrics metrics = run.metrics();
  EXPECT_EQ(metrics.ticks, 4);
  EXPECT_EQ(metrics.defined, 4);
  EXPECT_EQ(metrics.judged, 4);
  EXPECT_DOUBLE_EQ(metrics.force.peak, 5.0);
  EXPECT_DOUBLE_EQ(metrics.force.rmse, std::sqrt((1.0 + 9.0) / 4.0));
  EXPECT_DOUBLE_EQ(metrics.force.relative_rmse(), std::sqrt(2.5) / 5.0);
  EXPECT_DOUBLE_EQ(metrics.force.worst, 3.0);
  EXPECT_DOUBLE_EQ(metrics.force.relative_worst(), 0.6);
  EXPECT_DOUBLE_EQ(metrics.force.worst_time, 3e-3);
  EXPECT_DOUBLE_EQ(metrics.force.change_beyond, 3.0);    // -2 where the reference has +1
  EXPECT_DOUBLE_EQ(metrics.force.greatest_change, 3.0);  // 0 to 3
  EXPECT_DOUBLE_EQ(metrics.torque.peak, 0.4);
  EXPECT_NEAR(metrics.torque.rmse, std::sqrt((0.04 + 0.01) / 4.0), 1e-15);
  EXPECT_NEAR(metrics.torque.worst, 0.2, 1e-15);
  EXPECT_DOUBLE_EQ(metrics.torque.worst_time, 1e-3);
  EXPECT_NEAR(metrics.torque.change_beyond, 0.2, 1e-15);
  EXPECT_NEAR(metrics.torque.greatest_change, 0.3, 1e-15);
}

TEST(ReferenceMetrics, AroundASnapOnlyTheRmseAndTheGreatestChangeCount) {
  // The reference drops at tick 10, the method four ticks later: ticks 10 to 13 are wrong, of which 7 to 13 are left
  // out.
  HandMadeRun run;
  for (int i = 0; i < 20; ++i) run.add(i < 14 ? 2.0 : 0.0, i < 10 ? 2.0 : 0.0, i < 14 ? 0.5 : 0.0, i < 10 ? 0.5 : 0.0);
  EXPECT_DOUBLE_EQ(run.metrics().force.worst, 2.0);
  run.reference[10].snaps = true;
  ReferenceMetrics metrics = run.metrics();
  EXPECT_EQ(metrics.snapping, 1);
  EXPECT_EQ(metrics.judged, 13);
  EXPECT_DOUBLE_EQ(metrics.force.rmse, std::sqrt(4.0 * 4.0 / 20.0));
  EXPECT_EQ(metrics.force.worst, 0.0);
  EXPECT_EQ(metrics.force.change_beyond, 0.0);  // 13 to 14: tick 13 is not judged
  EXPECT_DOUBLE_EQ(metrics.force.greatest_change, 2.0);
  EXPECT_EQ(metrics.spurious_torque, 0.0);
  EXPECT_EQ(metrics.ghost_run, 4);
  EXPECT_DOUBLE_EQ(metrics.ghost_force, 2.0);
  // A tick later yet is judged.
  run.records[14].wrench = run.records[13].wrench;
  metrics = run.metrics();
  EXPECT_DOUBLE_EQ(metrics.force.worst, 2.0);
  EXPECT_DOUBLE_EQ(metrics.force.worst_time, 14e-3);
  EXPECT_DOUBLE_EQ(metrics.force.change_beyond, 2.0);  // 14 to 15
  EXPECT_DOUBLE_EQ(metrics.spurious_torque, 0.5);
  EXPECT_EQ(metrics.ghost_run, 5);
}

TEST(ReferenceMetrics, NobodyIsHeldToWhatIsNotKnown) {
  HandMadeRun run;
  for (int i = 0; i < 5; ++i) run.add(1.0, 1.0);
  run.add(7.0, std::numeric_limits<double>::quiet_NaN());
  run.reference[5].defined = false;
  run.add(1.5, 1.0);
  const ReferenceMetrics metrics = run.metrics();
  EXPECT_EQ(metrics.defined, 6);
  EXPECT_DOUBLE_EQ(metrics.force.peak, 1.0);
  EXPECT_DOUBLE_EQ(metrics.force.worst, 0.5);
  EXPECT_EQ(metrics.force.change_beyond, 0.0);
  EXPECT_DOUBLE_EQ(metrics.force.rmse, std::sqrt(0.25 / 6.0));
}

TEST(ReferenceMetrics, SpuriousTorqueIsThatWhereTheReferenceHasNone) {
  HandMadeRun run;
  run.add(1.0, 1.0, 0.02, 0.0);
  run.add(1.0, 1.0, -0.03, 0.9e-9);
  run.add(1.0, 1.0, 0.5, 1.1e-9);
  EXPECT_DOUBLE_EQ(run.metrics().spurious_torque, 0.03);
}

TEST(ReferenceMetrics, AGhostIsFeltWhereNothingTouches) {
  HandMadeRun run;
  for (const double force : {5.0, 0.0, 0.041, 0.041, 0.039, 0.041}) run.add(force, 0.0);
  run.reference[0].touches = true;
  EXPECT_EQ(run.metrics().ghost_run, 2);
  EXPECT_DOUBLE_EQ(run.metrics().ghost_force, 0.041);
  run.reference[2].defined = false;
  EXPECT_EQ(run.metrics().ghost_run, 1);
}

TEST(ReferenceMetrics, AWrenchThatIsNotFiniteIsAnInfiniteError) {
  HandMadeRun run;
  run.add(1.0, 1.0);
  run.add(std::numeric_limits<double>::quiet_NaN(), 1.0);
  run.add(1.0, 1.0);
  const ReferenceMetrics metrics = run.metrics();
  EXPECT_TRUE(std::isinf(metrics.force.rmse));
  EXPECT_TRUE(std::isinf(metrics.force.worst));
  EXPECT_TRUE(std::isinf(metrics.force.change_beyond));
  EXPECT_TRUE(std::isinf(metrics.force.greatest_change));
  EXPECT_EQ(metrics.torque.rmse, 0.0);
}

TEST(ReferenceMetrics, WantsASampleATick) {
  HandMadeRun run;
  run.add(1.0, 1.0);
  run.reference.emplace_back();
  EXPECT_THROW(run.metrics(), std::invalid_argument);
}

TEST(ReferenceMetrics, OfNothingAreNothing) {
  const ReferenceMetrics metrics = reference_metrics({}, {});
  EXPECT_EQ(metrics.ticks, 0);
  EXPECT_TRUE(std::isnan(metrics.force.rmse));
}

}  // namespace
}  // namespace tegotae
