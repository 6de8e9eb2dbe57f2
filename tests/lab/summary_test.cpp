// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/summary.hpp>
#include <tegotae/lab/summary_json.hpp>
#include <tegotae/render/render_types.hpp>

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <vector>

namespace tegotae {
namespace {

Experiment two_phases() {
  Experiment experiment;
  experiment.name = "two";
  experiment.phases = {{"a", "first", 0.0, 0.01}, {"b", "second", 0.01, 0.02}};
  experiment.force_axis = {"y", Vector3::UnitY()};
  experiment.torque_axis = {"z", Vector3::UnitZ()};
  return experiment;
}

// Force y is the tick's number, torque z its negative.
std::vector<TickRecord> numbered_ticks(int count) {
  std::vector<TickRecord> records;
  for (int i = 0; i < count; ++i) {
    TickRecord record;
    record.time = i * 1e-3;
    record.wrench = Wrench{{0.0, static_cast<double>(i), 0.0}, {0.0, 0.0, static_cast<double>(-i)}};
    record.active = i % 3;
    record.tick_us = 1.0 + i;
    record.safety_events = i < 5 ? 2U : 0U;
    record.status = static_cast<std::uint8_t>(i == 7 ? RenderStatus::kInfeasible : RenderStatus::kOk);
    record.dropped = i == 9 ? 4 : 0;
    records.push_back(record);
  }
  return records;
}

TEST(Summary, SplitsTheTicksIntoPhasesTheLastWithItsEnd) {
  const RunSummary summary = summarise(two_phases(), numbered_ticks(21), 1000.0);
  ASSERT_EQ(summary.phases.size(), 2U);
  EXPECT_EQ(summary.phases[0].ticks, 10U);
  EXPECT_EQ(summary.phases[1].ticks, 11U);
  EXPECT_EQ(summary.phases[0].reported_force.max, 9.0);
  EXPECT_EQ(summary.phases[1].reported_force.min, 10.0);
}

TEST(Summary, SpreadsAreLeastGreatestAndMean) {
  const RunSummary summary = summarise(two_phases(), numbered_ticks(21), 1000.0);
  const PhaseSummary& second = summary.phases[1];
  EXPECT_EQ(second.reported_force.max, 20.0);
  EXPECT_EQ(second.reported_force.mean, 15.0);
  EXPECT_EQ(second.reported_torque.min, -20.0);
  EXPECT_EQ(second.force[1].max, 20.0);
  EXPECT_EQ(second.force[0].max, 0.0);
  EXPECT_EQ(second.torque_norm.max, 20.0);
  EXPECT_EQ(second.contacts.max, 2.0);
  EXPECT_EQ(second.greatest_force_step, 1.0);
  EXPECT_EQ(second.greatest_torque_step, 1.0);
}

TEST(Summary, CountsStatusesEventsAndDroppedPoints) {
  const RunSummary summary = summarise(two_phases(), numbered_ticks(21), 1000.0);
  EXPECT_EQ(summary.statuses.at("ok"), 20U);
  EXPECT_EQ(summary.statuses.at("infeasible"), 1U);
  EXPECT_EQ(summary.safety_events.at("ramping"), 5U);
  EXPECT_EQ(summary.safety_events.at("stopped"), 0U);
  EXPECT_EQ(summary.dropped, 4U);
}

TEST(Summary, TickTimesAreThoseOfTheRecords) {
  const RunSummary summary = summarise(two_phases(), numbered_ticks(21), 1000.0);
  EXPECT_NEAR(summary.haptics.durations.median(), 11e-6, 0.1e-6);
  EXPECT_DOUBLE_EQ(summary.haptics.durations.max(), 21e-6);
  EXPECT_DOUBLE_EQ(summary.phases[0].tick_times.max(), 10e-6);
}

TEST(Summary, CountsPeriodsWithoutATick) {
  std::vector<TickRecord> records = numbered_ticks(21);
  EXPECT_EQ(summarise(two_phases(), records, 1000.0).haptics.missed_deadlines, 0U);
  records.erase(records.begin() + 13, records.begin() + 16);
  for (TickRecord& record : records) record.time += 2e-4;  // the whole run late
  records[4].time += 1e-4;                                 // one tick later than the others
  const RunSummary summary = summarise(two_phases(), records, 1000.0);
  EXPECT_EQ(summary.phases[0].missed_deadlines, 0U);
  EXPECT_EQ(summary.phases[1].missed_deadlines, 3U);
  EXPECT_EQ(summary.haptics.missed_deadlines, 3U);
}

TEST(Summary, CountsPeriodsMissedAcrossTheBoundaryOfPhasesInTheLater) {
  std::vector<TickRecord> records = numbered_ticks(21);
  records.erase(records.begin() + 8, records.begin() + 12);
  const RunSummary summary = summarise(two_phases(), records, 1000.0);
  EXPECT_EQ(summary.phases[0].missed_deadlines, 0U);
  EXPECT_EQ(summary.phases[1].missed_deadlines, 4U);
  EXPECT_EQ(summary.haptics.missed_deadlines, 4U);
}

TEST(Summary, OfAPhaseWithoutTicksIsEmpty) {
  const RunSummary summary = summarise(two_phases(), numbered_ticks(5), 1000.0);
  EXPECT_EQ(summary.phases[1].ticks, 0U);
  EXPECT_EQ(summary.phases[1].reported_force.max, 0.0);
}

TEST(SummaryJson, CarriesSettingsPhasesAndTimes) {
  const Experiment experiment = two_phases();
  ExperimentResult result;
  VariantResult variant;
  variant.variant.name = "only";
  variant.settings.stiffness = 9000.0;
  variant.samples_file = "somewhere/samples.csv";
  variant.summary = summarise(experiment, numbered_ticks(21), 1000.0);
  result.experiment = experiment;
  result.variants = {variant};

  const auto json = nlohmann::json::parse(summary_json(result));
  EXPECT_EQ(json["experiment"], "two");
  const auto& only = json["variants"][0];
  EXPECT_EQ(only["settings"]["stiffness_N_per_m"], 9000.0);
  EXPECT_EQ(only["samples"], "samples.csv");
  EXPECT_EQ(only["phases"][1]["force_N"]["y"]["max"], 20.0);
  EXPECT_EQ(only["phases"][0]["reported_force_at_end_N"], 9.0);
  EXPECT_EQ(only["phases"][1]["reported_torque_at_end_N_m"], -20.0);
  EXPECT_EQ(only["phases"][0]["reported_torque_N_m"]["min"], -9.0);
  EXPECT_NEAR(only["timing"]["tick_us"]["max"].get<double>(), 21.0, 1e-9);
  EXPECT_EQ(only["timing"]["time"], "simulated");
  EXPECT_TRUE(only["timing"]["missed_deadlines"].is_null());
}

TEST(SummaryJson, SaysHowTheRunInRealTimeWent) {
  ExperimentResult result;
  result.experiment = two_phases();
  result.variants.emplace_back();
  RealtimeReport report;
  report.haptics.add(2e-6, 0.05, 3);
  report.haptic_rights.explanation = "no rights";
  result.variants[0].real_time = report;
  const auto timing = nlohmann::json::parse(summary_json(result))["variants"][0]["timing"];
  EXPECT_EQ(timing["time"], "real");
  EXPECT_EQ(timing["missed_deadlines"], 3);
  EXPECT_NEAR(timing["model_age_ms"]["max"].get<double>(), 50.0, 1e-9);
  EXPECT_EQ(timing["haptic_rights"]["explanation"], "no rights");
}

}  // namespace
}  // namespace tegotae
