// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/comparison.hpp>
#include <tegotae/lab/comparison_json.hpp>
#include <tegotae/lab/comparison_markdown.hpp>
#include <tegotae/lab/paper_cube.hpp>
#include <tests/lab/temporary_folder.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <atomic>
#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

namespace tegotae {
namespace {

using testing::HasSubstr;

/// The paper's cube with its closed form as reference.
Experiment cube_with_reference() {
  Experiment experiment = paper_cube_experiment();
  experiment.settings.friction = 0.0;
  experiment.reference = [](const ReferenceTask& task, const Progress&) {
    std::vector<ReferenceSample> samples;
    for (const Pose& X_WT : task.X_WT) {
      const CubeOnFloor felt = cube_on_floor(0.1, X_WT.p.y(), 2.0 * std::atan2(X_WT.q.z(), X_WT.q.w()),
                                             task.settings.stiffness, task.settings.metric_length);
      ReferenceSample sample;
      sample.wrench = {{0.0, felt.force_y, 0.0}, {0.0, 0.0, felt.torque_z}};
      sample.touches = felt.force_y > 0.0;
      samples.push_back(sample);
    }
    return samples;
  };
  return experiment;
}

ComparisonRequest quick_request() {
  ComparisonRequest request;
  request.methods = {"paper", "proxy"};
  request.experiments = {cube_with_reference()};
  request.stability = false;
  return request;
}

nlohmann::json without_timing(const ComparisonResult& result) {
  nlohmann::json parsed = nlohmann::json::parse(comparison_json(result));
  for (auto& experiment : parsed["experiments"]) {
    for (auto& row : experiment["methods"]) row.erase("timing");
  }
  return parsed;
}

TEST(Comparison, HoldsEachMethodToTheReference) {
  const ComparisonResult result = run_comparison(quick_request(), [](double) {});
  ASSERT_EQ(result.experiments.size(), 1U);
  const ExperimentComparison& cube = result.experiments[0];
  EXPECT_EQ(cube.name, "paper-cube");
  ASSERT_EQ(cube.rows.size(), 2U);
  for (const ComparisonRow& row : cube.rows) {
    ASSERT_EQ(row.state, RowState::kDone) << row.failure;
    EXPECT_EQ(row.against_reference.ticks, 6001);
    EXPECT_NEAR(row.settings.metric_length, std::sqrt(0.04 / 6.0), 1e-12);
    EXPECT_EQ(row.settings.physics_rate, 20.0);
    EXPECT_NEAR(row.against_reference.force.peak, 3.286, 1e-3);
    EXPECT_EQ(row.of_run.tick_times.count(), 6001U);
  }
  // The closed form is that of the paper's constraints, which jump from edge to face, where all near points do not.
  const ReferenceMetrics& paper = cube.rows[0].against_reference;
  const ReferenceMetrics& proxy = cube.rows[1].against_reference;
  EXPECT_LT(paper.force.relative_worst(), 1e-3);
  EXPECT_LT(paper.torque.relative_worst(), 1e-3);
  EXPECT_GT(paper.force.greatest_change, 0.3);
  EXPECT_LT(proxy.force.relative_rmse(), 0.01);
  EXPECT_GT(proxy.force.change_beyond, 0.3);
  EXPECT_LT(proxy.force.greatest_change, 0.1);
  EXPECT_LT(cube.rows[1].of_run.proxy_penetration, 1e-9);
  EXPECT_FALSE(result.interrupted);
}

TEST(Comparison, RepeatsBitForBitOnAnyNumberOfThreads) {
  ComparisonRequest request = quick_request();
  const nlohmann::json alone = without_timing(run_comparison(request, [](double) {}));
  request.threads = 3;
  EXPECT_EQ(without_timing(run_comparison(request, [](double) {})), alone);
}

TEST(Comparison, AFailureIsToldInItsRowAndHindersNothingElse) {
  ComparisonRequest request = quick_request();
  request.methods = {"paper", "no-such"};
  request.experiments.push_back(cube_with_reference());
  request.experiments[1].name = "without";
  request.experiments[1].reference = [](const ReferenceTask&, const Progress&) -> std::vector<ReferenceSample> {
    throw std::runtime_error("no solution");
  };
  request.experiments.push_back(cube_with_reference());
  request.experiments[2].name = "short";
  request.experiments[2].reference = [](const ReferenceTask&, const Progress&) {
    return std::vector<ReferenceSample>(3);
  };
  const ComparisonResult result = run_comparison(request, [](double) {});
  const auto& rows = result.experiments[0].rows;
  EXPECT_EQ(rows[0].state, RowState::kDone);
  EXPECT_EQ(rows[1].state, RowState::kFailed);
  EXPECT_THAT(rows[1].failure, HasSubstr("there is no method 'no-such'"));
  EXPECT_EQ(result.experiments[1].rows[0].failure, "the reference failed: no solution");
  EXPECT_THAT(result.experiments[2].rows[0].failure, HasSubstr("3 samples, and the run 6001 ticks"));
  const std::string page = comparison_markdown(result);
  EXPECT_THAT(page, HasSubstr("| failed |"));
  EXPECT_THAT(page, HasSubstr("- no-such failed: there is no method"));
  const nlohmann::json parsed = nlohmann::json::parse(comparison_json(result));
  EXPECT_EQ(parsed["experiments"][1]["methods"][0]["state"], "failed");
  EXPECT_EQ(parsed["experiments"][1]["methods"][0]["failure"], "the reference failed: no solution");
}

TEST(Comparison, StoppedTellsWhatWasNotReached) {
  ComparisonRequest request = quick_request();
  std::atomic<bool> stop{false};
  request.stop = &stop;
  request.experiments.push_back(cube_with_reference());
  request.experiments[1].name = "second";
  request.experiments[1].motion = [&stop, motion = request.experiments[0].motion](const Tool& tool) {
    stop = true;
    return motion(tool);
  };
  const ComparisonResult result = run_comparison(request, [](double) {});
  EXPECT_TRUE(result.interrupted);
  for (const ComparisonRow& row : result.experiments[0].rows) EXPECT_EQ(row.state, RowState::kDone);
  for (const ComparisonRow& row : result.experiments[1].rows) EXPECT_EQ(row.state, RowState::kNotReached);
  EXPECT_THAT(comparison_markdown(result), HasSubstr("| second | not reached | not reached |"));
  EXPECT_THAT(comparison_markdown(result), HasSubstr("Interrupted"));
  EXPECT_EQ(nlohmann::json::parse(comparison_json(result))["experiments"][1]["methods"][1]["state"], "not reached");
}

TEST(Comparison, StabilityThatWasNotReachedFillsItsRow) {
  ComparisonResult result;
  result.stability.push_back({"proxy", {}, {}, ""});
  EXPECT_THAT(stability_table(result), HasSubstr("| proxy | – | – | – | – | – | – |\n"));
}

TEST(Comparison, DrawsAFigureAnExperiment) {
  const TemporaryFolder folder;
  ComparisonRequest request = quick_request();
  request.figures = folder.path();
  const ComparisonResult result = run_comparison(request, [](double) {});
  EXPECT_EQ(result.figure_failure, "");
  EXPECT_EQ(result.experiments[0].figure, "paper-cube");
  for (const char* name : {"paper-cube.svg", "paper-cube.png"}) {
    EXPECT_GT(std::filesystem::file_size(folder.path() / name), 1000U) << name;
  }
  const std::string data = contents_of(folder.path() / "paper-cube.dat");
  for (const char* curve : {"force along y [N]: paper", "torque about z [N m]: reference"}) {
    EXPECT_THAT(data, HasSubstr(curve));
  }
  // f_y of the reference runs from 0 to 3.286 N.
  EXPECT_THAT(contents_of(folder.path() / "paper-cube.gnuplot"), HasSubstr("set yrange [-1.64"));
}

TEST(Comparison, MeasuresTheStabilityOfEachMethod) {
  ComparisonRequest request;
  request.methods = {"berkelman"};
  request.threads = 2;
  const ComparisonResult result = run_comparison(request, [](double) {});
  ASSERT_EQ(result.stability.size(), 1U);
  const StabilityOfMethod& row = result.stability[0];
  EXPECT_EQ(row.failure, "");
  ASSERT_EQ(row.limits.size(), 3U);
  EXPECT_EQ(row.limits[2].contact, "face");
  EXPECT_NEAR(row.limits[2].ratio_to_linear(), 0.25, 0.02);  // four springs side by side
  ASSERT_TRUE(row.energy.has_value());
  EXPECT_THAT(stability_table(result), HasSubstr("| berkelman | "));
  const nlohmann::json parsed = nlohmann::json::parse(comparison_json(result));
  EXPECT_EQ(parsed["stability"]["largest_stable_stiffness"].size(), 3U);
  EXPECT_EQ(parsed["stability"]["energy_in_random_contact"].size(), 1U);
  EXPECT_TRUE(parsed["stability"]["failures"].empty());
}

TEST(Comparison, MetricsStandInTheJsonWithTheirUnits) {
  const nlohmann::json row = nlohmann::json::parse(
      comparison_json(run_comparison(quick_request(), [](double) {})))["experiments"][0]["methods"][0];
  for (const char* key : {"force_rmse_N", "force_rmse_of_peak", "torque_worst_N_m", "spurious_torque_N_m",
                          "torque_change_per_tick_beyond_reference_N_m", "force_greatest_change_per_tick_N",
                          "ghost_contact_ticks", "ghost_contact_force_N", "proxy_penetration_m", "energy_injected_J"}) {
    EXPECT_TRUE(row["metrics"][key].is_number()) << key;
  }
  EXPECT_EQ(row["timing"]["missed_deadlines"], 0);
  EXPECT_GT(row["timing"]["tick_us"]["p99_9"].get<double>(), 0.0);
}

TEST(ComparedSettings, TheExperimentsOwnButForTheMetricLength) {
  Experiment experiment;
  SettingsRequest settings = compared_settings(experiment, "proxy");
  EXPECT_EQ(settings.method, "proxy");
  EXPECT_EQ(settings.metric_length, 0.0);
  EXPECT_EQ(settings.physics_rate, 20.0);
  EXPECT_EQ(settings.haptic_rate, 1000.0);
  experiment.settings.physics_rate = 50.0;
  experiment.settings.metric_length = 1.0;
  experiment.settings.friction = 0.3;
  experiment.variants = metric_length_variants();
  experiment.variants[0].settings.constraint_set = ConstraintSet::kNearPoints;
  settings = compared_settings(experiment, "adachi");
  EXPECT_EQ(settings.physics_rate, 50.0);
  EXPECT_EQ(settings.metric_length, 0.0);
  EXPECT_EQ(settings.friction, 0.3);
  EXPECT_FALSE(settings.constraint_set.has_value());
  EXPECT_EQ(compared_settings(experiment, "paper").constraint_set, ConstraintSet::kNearPoints);
}

}  // namespace
}  // namespace tegotae
