// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/recording_file.hpp>
#include <tegotae/lab/replay_session.hpp>
#include <tegotae/stream/mcap_reader.hpp>

#include <tests/lab/recorded_run.hpp>
#include <tests/lab/temporary_folder.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

namespace tegotae {
namespace {

using Json = nlohmann::json;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;
namespace command = viewer_command;

// Ten seconds from 100 s on, ten states a second; another scene from 105 s on.
std::filesystem::path a_recording_to_replay(const TemporaryFolder& folder) {
  auto file = folder.path() / "a.mcap";
  RecordingFile recording(file, {}, 0.0);
  recording.write_scene(100.0, R"({"type":"scene","mode":"live","name":"first"})");
  recording.write_settings(100.0, R"({"type":"settings","method":"proxy","values":[]})");
  for (int i = 0; i <= 100; ++i) {
    if (i == 50) recording.write_scene(105.0, R"({"type":"scene","mode":"live","name":"second"})");
    Json state = {{"type", "state"},
                  {"n", 1000 + i},
                  {"t", 100.0 + 0.1 * i},
                  {"made", 5.0},
                  {"wrench", {0, 0, i, 0, 0, 0}},
                  {"paused", true},
                  {"recording", true},
                  {"recording_file", "a.mcap"},
                  {"recording_ticks", i},
                  {"hand", 3},
                  {"viewers", 9}};
    state["samples"] = {{100.0 + 0.1 * i - 0.01, 1, 2, 3, 4, 5, 6}, {100.0 + 0.1 * i, 1, 2, 3, 4, 5, 6}};
    recording.write_state(100.0 + 0.1 * i, state.dump());
  }
  recording.close();
  EXPECT_EQ(recording.error(), "");
  return file;
}

Json shown(ReplaySession& replay) { return Json::parse(replay.state_message(2, 1700000000123.44)); }

TEST(ReplaySession, PlaysFromTheBeginningAndPausesAtTheEnd) {
  const TemporaryFolder folder;
  ReplaySession replay(a_recording_to_replay(folder));
  EXPECT_NEAR(replay.duration(), 10.0, 1e-9);
  EXPECT_FALSE(replay.is_paused());
  EXPECT_EQ(shown(replay)["wrench"][2], 0);
  replay.advance(2.55);
  EXPECT_EQ(shown(replay)["wrench"][2], 25);
  replay.advance(100.0);
  EXPECT_EQ(shown(replay)["wrench"][2], 100);
  EXPECT_TRUE(replay.is_paused());
}

TEST(ReplaySession, StatesAreAsRecordedButForWhatIsOfNow) {
  const TemporaryFolder folder;
  ReplaySession replay(a_recording_to_replay(folder));
  replay.advance(1.0);
  const Json state = shown(replay);
  EXPECT_EQ(state["type"], "state");
  EXPECT_EQ(state["n"], 1);
  EXPECT_EQ(state["t"], 1.0);
  EXPECT_EQ(state["made"], 1700000000123.4);
  EXPECT_EQ(state["samples"], Json::parse("[[0.99,1,2,3,4,5,6],[1.0,1,2,3,4,5,6]]"));
  EXPECT_EQ(state["wrench"], Json::parse("[0,0,10,0,0,0]"));
  EXPECT_EQ(state["paused"], false);
  EXPECT_EQ(state["recording"], false);
  EXPECT_FALSE(state.contains("recording_file"));
  EXPECT_FALSE(state.contains("recording_ticks"));
  EXPECT_TRUE(state["hand"].is_null());
  EXPECT_EQ(state["viewers"], 2);
  EXPECT_EQ(shown(replay)["n"], 2);
}

TEST(ReplaySession, TheSceneSaysThatItIsAReplay) {
  const TemporaryFolder folder;
  ReplaySession replay(a_recording_to_replay(folder));
  const Json scene = Json::parse(replay.scene_message());
  EXPECT_EQ(scene["mode"], "replay");
  EXPECT_EQ(scene["name"], "first");
  EXPECT_EQ(scene["duration"], 10.0);
  EXPECT_EQ(scene["start"], 100.0);
  EXPECT_EQ(Json::parse(replay.settings_message())["method"], "proxy");
}

TEST(ReplaySession, KnowsWhenTheSceneIsAnother) {
  const TemporaryFolder folder;
  ReplaySession replay(a_recording_to_replay(folder));
  const int first = replay.scene_number(), settings = replay.settings_number();
  replay.advance(4.0);
  EXPECT_EQ(replay.scene_number(), first);
  replay.advance(2.0);
  EXPECT_NE(replay.scene_number(), first);
  EXPECT_EQ(replay.settings_number(), settings);
  EXPECT_EQ(Json::parse(replay.scene_message())["name"], "second");
  replay.obey(command::Seek{1.0});
  EXPECT_EQ(replay.scene_number(), first);
  EXPECT_EQ(Json::parse(replay.scene_message())["name"], "first");
}

TEST(ReplaySession, ObeysPauseSeekSpeedAndReset) {
  const TemporaryFolder folder;
  ReplaySession replay(a_recording_to_replay(folder));
  EXPECT_EQ(replay.obey(command::Pause{}), "");
  replay.advance(1.0);
  EXPECT_EQ(replay.time(), 0.0);
  EXPECT_EQ(shown(replay)["paused"], true);
  EXPECT_EQ(replay.obey(command::Seek{3.25}), "");
  EXPECT_EQ(replay.time(), 3.25);
  EXPECT_EQ(shown(replay)["wrench"][2], 32);
  EXPECT_EQ(replay.obey(command::Resume{}), "");
  replay.advance(1.0);
  EXPECT_EQ(replay.time(), 4.25);
  EXPECT_EQ(replay.obey(command::Play{2.0}), "");
  replay.advance(1.0);
  EXPECT_EQ(replay.time(), 6.25);
  EXPECT_EQ(replay.obey(command::Reset{}), "");
  EXPECT_EQ(replay.time(), 0.0);
  replay.obey(command::Seek{1e8});
  EXPECT_NEAR(replay.time(), 10.0, 1e-9);
  replay.obey(command::Seek{-5.0});
  EXPECT_EQ(replay.time(), 0.0);
}

TEST(ReplaySession, PlayAtTheEndBeginsAgain) {
  const TemporaryFolder folder;
  ReplaySession replay(a_recording_to_replay(folder));
  for (const ViewerCommand& again : {ViewerCommand(command::Play{1.0}), ViewerCommand(command::Resume{})}) {
    replay.advance(100.0);
    ASSERT_TRUE(replay.is_paused());
    EXPECT_EQ(replay.obey(again), "");
    EXPECT_EQ(replay.time(), 0.0);
    EXPECT_FALSE(replay.is_paused());
  }
}

TEST(ReplaySession, RefusesWhatOnlyALiveRunCan) {
  const TemporaryFolder folder;
  ReplaySession replay(a_recording_to_replay(folder));
  replay.advance(1.0);
  for (const ViewerCommand& wanted :
       {ViewerCommand(command::Hand{}), ViewerCommand(command::Set{"stiffness", 1.0}), ViewerCommand(command::Step{}),
        ViewerCommand(command::Record{true}), ViewerCommand(command::SceneChoice{"table"})}) {
    EXPECT_THAT(replay.obey(wanted), HasSubstr("This is a recording"));
  }
  EXPECT_EQ(replay.time(), 1.0);
}

TEST(ReplaySession, TimeThatIsNoTimeDoesNothing) {
  const TemporaryFolder folder;
  ReplaySession replay(a_recording_to_replay(folder));
  replay.advance(-1.0);
  replay.advance(std::nan(""));
  EXPECT_EQ(replay.time(), 0.0);
}

TEST(ReplaySession, ShowsTheForcesOfTheRun) {
  const TemporaryFolder folder;
  const std::vector<TickRecord> ticks = record_table(folder.path() / "run.mcap", 0.8);
  ReplaySession replay(folder.path() / "run.mcap");
  double greatest = 0.0;
  for (int i = 0; i < 60; ++i) {
    const Json state = shown(replay);
    const auto tick = static_cast<std::size_t>(std::lround(state["t"].get<double>() * 1000.0));
    const double force = ticks.at(tick).displayed.force.z;
    EXPECT_NEAR(state["wrench"][2], force, 1e-6 * (1.0 + std::abs(force)));
    greatest = std::max(greatest, force);
    replay.advance(1.0 / 60.0);
  }
  EXPECT_GT(greatest, 0.1) << "the tool was to touch something";
}

TEST(ReplaySession, AStateThatIsNoJsonIsSaid) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "a.mcap";
  RecordingFile recording(file, {}, 0.0);
  recording.write_scene(0.0, "{}");
  recording.write_state(0.0, "{\"t\": ");
  recording.close();
  ReplaySession replay(file);
  EXPECT_THAT([&] { replay.state_message(1, 0.0); }, ThrowsMessage<RecordingError>(HasSubstr("damaged")));
}

}  // namespace
}  // namespace tegotae
