// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/experiment_run.hpp>
#include <tegotae/lab/recording_schemas.hpp>
#include <tegotae/lab/run_recording.hpp>
#include <tegotae/stream/mcap_reader.hpp>

#include <tests/lab/program_run.hpp>
#include <tests/lab/recorded_run.hpp>
#include <tests/lab/temporary_folder.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace tegotae {
namespace {

using Json = nlohmann::json;
using ::testing::HasSubstr;

struct Recorded {
  std::map<std::string, std::vector<Json>> messages;
  std::vector<std::string> topics;  // in the order of the file
  McapEnd end;

  const std::vector<Json>& of(const RecordingTopic& kind) { return messages[std::string(kind.topic)]; }
};

Recorded read(const std::filesystem::path& file) {
  Recorded recorded;
  recorded.end = read_mcap(file, [&](const McapMessage& message) {
    recorded.topics.emplace_back(message.topic);
    recorded.messages[recorded.topics.back()].push_back(Json::parse(message.data));
  });
  return recorded;
}

TEST(RunRecording, HoldsSceneSettingsTicksAndSixtyStatesASecond) {
  const TemporaryFolder folder;
  const std::vector<TickRecord> ticks = record_table(folder.path() / "a.mcap", 0.5);
  Recorded recorded = read(folder.path() / "a.mcap");
  EXPECT_TRUE(recorded.end.complete);
  ASSERT_EQ(ticks.size(), 501U);
  EXPECT_EQ(recorded.of(kTickTopic).size(), 501U);
  EXPECT_EQ(recorded.of(kStateTopic).size(), 31U);  // 0, 1/60, ... 30/60 s
  EXPECT_EQ(recorded.topics[0], kSessionTopic.topic);
  EXPECT_EQ(recorded.topics[1], kSceneTopic.topic);
  EXPECT_EQ(recorded.topics[2], kSettingsTopic.topic);
  const Json& scene = recorded.of(kSceneTopic).at(0);
  EXPECT_EQ(scene["name"], "table.xml");
  EXPECT_GT(scene["bodies"].size(), 3U);
  EXPECT_EQ(recorded.of(kSettingsTopic).at(0)["method"], "proxy");
}

TEST(RunRecording, StatesSayWhatTheTicksDid) {
  const TemporaryFolder folder;
  const std::vector<TickRecord> ticks = record_table(folder.path() / "a.mcap", 0.5);
  Recorded recorded = read(folder.path() / "a.mcap");
  const std::vector<Json>& states = recorded.of(kStateTopic);
  ASSERT_EQ(states.size(), 31U);
  for (std::size_t i = 0; i < states.size(); ++i) {
    const double time = states[i]["t"];
    EXPECT_NEAR(time, 2.0 + static_cast<double>(i) / 60.0, 1.001e-3);
    const TickRecord& tick = ticks[static_cast<std::size_t>(std::lround((time - 2.0) * 1000.0))];
    EXPECT_NEAR(states[i]["tool"][2], tick.X_WT.p.z, 1e-6);
    EXPECT_NEAR(states[i]["proxy"][2], tick.X_WP.p.z, 1e-6);
    EXPECT_NEAR(states[i]["wrench"][2], tick.displayed.force.z, 1e-6 * (1.0 + std::abs(tick.displayed.force.z)));
    EXPECT_EQ(states[i]["samples"].back()[0], time);
    EXPECT_EQ(states[i]["motion"], "press");
    EXPECT_EQ(states[i].contains("histogram"), i % 30 == 0);
  }
}

// The wrenches in the states, joined as a page joins them, are those of all ticks.
TEST(RunRecording, SamplesOfTheStatesJoinToAllTicks) {
  const TemporaryFolder folder;
  const std::vector<TickRecord> ticks = record_table(folder.path() / "a.mcap", 0.3);
  double last = -1.0;
  std::size_t count = 0;
  Recorded recorded = read(folder.path() / "a.mcap");
  for (const Json& state : recorded.of(kStateTopic)) {
    for (const Json& sample : state["samples"]) {
      if (sample[0].get<double>() <= last) continue;
      last = sample[0];
      ASSERT_LT(count, ticks.size());
      EXPECT_NEAR(last, 2.0 + ticks[count].time, 1e-6);
      EXPECT_NEAR(sample[3], ticks[count].displayed.force.z, 1e-6 * (1.0 + std::abs(ticks[count].displayed.force.z)));
      ++count;
    }
  }
  EXPECT_EQ(count, ticks.size());
}

TEST(RunRecording, StatesHaveBodiesAndContacts) {
  const TemporaryFolder folder;
  record_table(folder.path() / "a.mcap", 1.0);
  Recorded recorded = read(folder.path() / "a.mcap");
  const auto moving = static_cast<std::size_t>(table_session(0.1)->world().geometry().moving_count);
  ASSERT_GT(moving, 0U);
  bool contact = false;
  for (const Json& state : recorded.of(kStateTopic)) {
    EXPECT_EQ(state["bodies"].size(), moving);
    for (const Json& point : state["points"]) contact = contact || point[4].get<double>() > 0.0;
  }
  EXPECT_TRUE(contact) << "the tool was to touch something";
}

TEST(RunRecording, TheLastStateIsThatOfTheLastTick) {
  const TemporaryFolder folder;
  const std::vector<TickRecord> ticks = record_table(folder.path() / "a.mcap", 0.025);
  Recorded recorded = read(folder.path() / "a.mcap");
  ASSERT_EQ(recorded.of(kStateTopic).size(), 3U);
  EXPECT_NEAR(recorded.of(kStateTopic).back()["t"], 2.0 + ticks.back().time, 1e-6);
}

TEST(RunRecording, CutAtAnyByteItKeepsAllThatWasWholeBeforeTheCut) {
  const TemporaryFolder folder;
  record_table(folder.path() / "whole.mcap", 0.02);
  const Recorded whole = read(folder.path() / "whole.mcap");
  const std::string bytes = contents_of(folder.path() / "whole.mcap");
  const auto cut = folder.path() / "cut.mcap";
  std::filesystem::copy_file(folder.path() / "whole.mcap", cut);
  std::size_t least = whole.topics.size();
  for (std::size_t length = bytes.size(); length > 8; --length) {
    std::filesystem::resize_file(cut, length);
    std::size_t count = 0;
    const McapEnd end = read_mcap(cut, [&](const McapMessage& message) {
      ASSERT_LT(count, whole.topics.size());
      ASSERT_EQ(message.topic, whole.topics[count++]);
      ASSERT_EQ(bytes.compare(message.offset, message.data.size(), message.data), 0);
      ASSERT_LE(message.offset + message.data.size(), length);
    });
    ASSERT_LE(count, least) << length;
    // No message is lost before the cut has reached its last byte.
    if (count < least) {
      ASSERT_EQ(count + 1, least) << length;
      least = count;
    }
    ASSERT_EQ(end.messages, count);
  }
  EXPECT_EQ(least, 0U);
}

TEST(RunRecording, AFullDiskStopsTheRecordingAndNothingElse) {
  const std::vector<TickRecord> expected = [] {
    const TemporaryFolder folder;
    return record_table(folder.path() / "a.mcap", 0.2);
  }();
  const auto session = table_session(0.2);
  RunRecording recording("/dev/full", *session, {}, "table.xml", "");
  std::size_t ticks = 0;
  session->run_simulated(
      [&](const TickRecord& record) {
        recording.write(record);
        EXPECT_EQ(record.wrench.force.z, expected[ticks++].wrench.force.z);
        return true;
      },
      [](double) {});
  recording.close();
  EXPECT_EQ(ticks, expected.size());
  EXPECT_THAT(recording.error(), HasSubstr("No space left"));
}

TEST(RunRecording, OfARunInRealTimeHasItsContactsAndBodies) {
  const TemporaryFolder folder;
  const auto session = table_session(0.9);
  session->watch();
  RunRecording recording(folder.path() / "a.mcap", *session, {}, "table.xml", "");
  const std::atomic<bool> never{false};
  session->run_realtime(
      [&](const TickRecord& record) {
        recording.write(record);
        return true;
      },
      [](double) {}, never);
  recording.close();
  Recorded recorded = read(folder.path() / "a.mcap");
  ASSERT_GE(recorded.of(kStateTopic).size(), 2U);
  const Json& last = recorded.of(kStateTopic).back();
  EXPECT_EQ(last["bodies"].size(), static_cast<std::size_t>(session->world().geometry().moving_count));
  EXPECT_FALSE(last["points"].empty());
}

TEST(ProgramExperiment, RecordsItsFirstVariant) {
  const TemporaryFolder folder;
  const std::string file = (folder.path() / "a.mcap").string();
  const ProgramResult result =
      run_program({"experiment", "knurl", "--out", (folder.path() / "out").string(), "--record", file});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  Recorded recorded = read(file);
  EXPECT_TRUE(recorded.end.complete);
  ASSERT_FALSE(recorded.of(kStateTopic).empty());
  EXPECT_EQ(recorded.of(kStateTopic)[0]["motion"], "knurl");
  EXPECT_EQ(recorded.of(kSceneTopic).at(0)["tool"]["shapes"][0]["kind"], "hull");
}

TEST(ProgramRender, RefusesToRecordOverWhatItReads) {
  const TemporaryFolder folder;
  const std::string motion = folder.write("motion.csv", "t,x,y,z,qw,qx,qy,qz\n0,0,0.2,0,1,0,0,0\n");
  const std::string scene = std::string(TEGOTAE_SCENES) + "/paper-cube.xml";
  const std::string out = (folder.path() / "out.csv").string();
  const auto recording_to = [&](const std::string& file) {
    return run_program(
        {"render", "--scene", scene, "--tool", "tool", "--trajectory", motion, "--out", out, "--record", file});
  };
  EXPECT_EQ(recording_to(motion).exit_code, 2);
  EXPECT_EQ(recording_to(out).exit_code, 2);
  EXPECT_THAT(recording_to(motion).err, HasSubstr("--record"));
  EXPECT_THAT(recording_to((folder.path() / "none" / "a.mcap").string()).err, HasSubstr("make it first"));
}

}  // namespace
}  // namespace tegotae
