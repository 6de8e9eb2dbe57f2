// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/spidar_presets.hpp>
#include <tegotae/lab/experiment_run.hpp>
#include <tegotae/lab/input_error.hpp>
#include <tegotae/runtime/safety.hpp>
#include <tests/lab/cube_session.hpp>
#include <tests/lab/samples_table.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace tegotae {
namespace {

ExperimentResult performed(const Experiment& experiment, const InterfaceRequest& interface,
                           const std::filesystem::path& folder, bool real_time = false) {
  ExperimentRequest request;
  request.folder = folder;
  request.interface = interface;
  request.real_time = real_time;
  return run_experiment(experiment, request, [](double) {});
}

// The X3R with encoders of a nanometre: what is left between command and display is the driver's and the motors' own.
InterfaceRequest finely_encoded() {
  InterfaceRequest request = interface_request("spidar-g6:x3r,simulated", "moderate");
  for (SpidarString& string : std::get<SpidarGeometry>(request.choice.model).strings) {
    string.metres_per_pulse = std::copysign(1e-9, string.metres_per_pulse);
  }
  return request;
}

constexpr std::uint32_t kLimited = 1U << static_cast<unsigned>(SafetyEvent::kForceSaturated) |
                                   1U << static_cast<unsigned>(SafetyEvent::kTorqueSaturated);

TEST(ExperimentInterface, ThePapersCubeIsDisplayedAsCommandedAllAlong) {
  const TemporaryFolder folder;
  const ExperimentResult result = performed(find_experiment("paper-cube"), finely_encoded(), folder.path());
  ASSERT_EQ(result.variants.size(), 2U);
  for (const VariantResult& variant : result.variants) {
    long compared = 0;
    double greatest = 0.0;
    for (const TickRecord& record : variant.records) {
      if (record.falls_short || (record.safety_events & kLimited) != 0) continue;
      const Wrench error = Wrench(record.interface_wrench) - Wrench(record.displayed);
      ASSERT_LT(error.force.norm(), 1e-6) << record.time;
      ASSERT_LT(error.torque.norm(), 1e-6) << record.time;
      greatest = std::max(greatest, Wrench(record.displayed).force.norm());
      ++compared;
    }
    EXPECT_GT(compared, 5900) << variant.variant.name;
    EXPECT_GT(greatest, 3.0) << "the paper's force is pressed with";
  }
}

TEST(ExperimentInterface, WithItsOwnEncodersTheDifferenceIsTheirRounding) {
  const TemporaryFolder folder;
  const ExperimentResult result =
      performed(find_experiment("paper-cube"), interface_request("spidar-g6:x3r,simulated", "moderate"), folder.path());
  for (const VariantResult& variant : result.variants) {
    ASSERT_TRUE(variant.display.has_value());
    // 15 um and 0.07 degree of strings of 0.1 m and knots of 22 mm are half a percent of the wrench at most.
    EXPECT_GT(variant.display->reachable.force_rms, 1e-5);
    EXPECT_LT(variant.display->reachable.force_max, 0.02);
    EXPECT_LT(variant.display->reachable.torque_max, 1e-3);
    EXPECT_LT(variant.display->shortfalls, 30) << "of 6001";
    EXPECT_LT(variant.display->hand_way, 8e-3);
  }
  // 1 m is 9000 N m/rad: held to the rating, and said.
  EXPECT_NEAR(result.variants[0].settings.metric_length, 0.11, 0.001);
  EXPECT_EQ(result.variants[1].display->shortfalls, 0);
  EXPECT_THAT(result.warnings, testing::Contains(testing::AllOf(
                                   testing::HasSubstr("one-metre: spidar-g6:x3r,simulated in a moderate hand is rated"),
                                   testing::HasSubstr("metric length of 0.11"))));
}

TEST(ExperimentInterface, WhatIsWrittenTellsOfIt) {
  const TemporaryFolder folder;
  const ExperimentResult result =
      performed(find_experiment("wedge"), interface_request("spidar-g6:x4r,simulated", "firm"), folder.path());
  const SamplesTable samples = read_samples(folder.path() / "samples.csv");
  const std::vector<TickRecord>& records = result.variants[0].records;
  ASSERT_EQ(samples.rows.size(), records.size());
  for (const size_t row : {size_t{0}, records.size() / 2, records.size() - 1}) {
    EXPECT_EQ(samples.at(row, "ifz"), records[row].interface_wrench.force.z);
    EXPECT_EQ(samples.at(row, "ity"), records[row].interface_wrench.torque.y);
    EXPECT_EQ(samples.at(row, "hz"), records[row].X_WH.p.z);
    EXPECT_EQ(samples.at(row, "hqw"), records[row].X_WH.w);
    EXPECT_EQ(samples.at(row, "falls_short"), records[row].falls_short ? 1.0 : 0.0);
  }
  EXPECT_EQ(samples.names.back(), "tick_us");
  EXPECT_THAT(samples.comments, testing::IsSupersetOf({testing::HasSubstr("interface: spidar-g6:x4r,simulated"),
                                                       testing::HasSubstr("middle of the SPIDAR's frame"),
                                                       testing::HasSubstr("ifx to itz")}));
  const auto summary = nlohmann::json::parse(contents_of(result.summary_file));
  EXPECT_EQ(summary["interface"]["name"], "spidar-g6:x4r,simulated");
  EXPECT_EQ(summary["interface"]["hand"], "firm");
  const auto& display = summary["variants"][0]["display"];
  EXPECT_EQ(display["shortfall_ticks"], result.variants[0].display->shortfalls);
  EXPECT_EQ(display["displayed_less_commanded"]["ticks"], records.size());
  draw_figures(result, folder.path());
  for (const char* name : {"displayed-force.svg", "displayed-torque.png", "hand-and-tool.svg"}) {
    EXPECT_GT(std::filesystem::file_size(folder.path() / "figures" / name), 1000U) << name;
  }
}

TEST(ExperimentInterface, WhatTheInterfaceKeepsFromTheHandIsAWarning) {
  Experiment experiment = find_experiment("paper-cube");
  // 3 N are pressed with, and 0.1 N m: more than these motors have.
  InterfaceRequest weak = interface_request("simulated:page", "moderate");
  std::get<SimulatedDevice>(weak.choice.model).capability.max_force = 0.5;
  const TemporaryFolder folder;
  const ExperimentResult result = performed(experiment, weak, folder.path());
  EXPECT_THAT(result.warnings, testing::Contains(testing::AllOf(testing::HasSubstr("the force that simulated:page has"),
                                                                testing::HasSubstr("of 6001 ticks"))));
  EXPECT_LE(result.variants[0].display->greatest_force, 0.5);
  EXPECT_GT(result.variants[0].summary.safety_events.at("force_saturated"), 100U);
}

TEST(ExperimentInterface, RepeatsBitForBit) {
  const InterfaceRequest interface = interface_request("simulated:parallel", "relaxed");
  const TemporaryFolder folder;
  for (const char* name : {"first", "second"}) performed(find_experiment("wedge"), interface, folder.path() / name);
  EXPECT_EQ(without_last_column(folder.path() / "first" / "samples.csv"),
            without_last_column(folder.path() / "second" / "samples.csv"));
}

TEST(ExperimentInterface, InRealTimeEachTickHasItsOwnTruth) {
  Experiment experiment = find_experiment("paper-cube");
  experiment.motion = [](const Tool&) {
    return cube_motion(
        0.4, [](double time) { return kHalfEdge + 1e-3 - 4e-3 * time; }, [](double) { return 0.0; });
  };
  experiment.variants.resize(1);
  const TemporaryFolder folder;
  const ExperimentResult result =
      performed(experiment, interface_request("simulated:page", "moderate"), folder.path(), true);
  const VariantResult& variant = result.variants.front();
  ASSERT_TRUE(variant.real_time.has_value());
  ASSERT_GT(variant.records.size(), 10U);
  // It displays at once and without error what it is commanded: another tick's truth would differ.
  EXPECT_EQ(variant.display->all.force_max, 0.0);
  EXPECT_GT(variant.display->greatest_force, 0.1);
}

TEST(ExperimentInterface, AMotionOutOfReachIsRefusedBeforeAnythingIsWritten) {
  const TemporaryFolder folder;
  EXPECT_THAT(
      [&] {
        performed(find_experiment("thin-plate-strike"), interface_request("spidar-g6:x3r,simulated", "moderate"),
                  folder.path());
      },
      testing::ThrowsMessage<InputError>(testing::HasSubstr("leaves the workspace")));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "samples.csv"));
  EXPECT_THAT([] { interface_request("simulated:page", "iron"); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("relaxed")));
}

}  // namespace
}  // namespace tegotae
