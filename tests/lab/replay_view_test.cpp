// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/recording_file.hpp>
#include <tegotae/lab/replay_view.hpp>

#include <tests/lab/program_run.hpp>
#include <tests/lab/temporary_folder.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace tegotae {
namespace {

using Json = nlohmann::json;
using ::testing::HasSubstr;

// Ten seconds, ten states a second; another scene from 5 s on, other settings from 8 s on.
std::filesystem::path a_recording_to_view(const TemporaryFolder& folder) {
  auto file = folder.path() / "a.mcap";
  RecordingFile recording(file, {}, 0.0);
  recording.write_scene(0.0, R"({"type":"scene","name":"first"})");
  recording.write_settings(0.0, R"({"type":"settings","method":"proxy"})");
  for (int i = 0; i <= 100; ++i) {
    const double time = 0.1 * i;
    if (i == 50) recording.write_scene(time, R"({"type":"scene","name":"second"})");
    if (i == 80) recording.write_settings(time, R"({"type":"settings","method":"paper"})");
    recording.write_state(time, Json{{"type", "state"}, {"t", time}, {"place", i}}.dump());
  }
  recording.close();
  EXPECT_EQ(recording.error(), "");
  return file;
}

// What a server would have been given.
struct Sent {
  std::vector<Json> states, to_all;
  std::vector<std::pair<ViewerId, Json>> to_one;
  std::vector<ViewerId> disconnected;
  std::size_t viewers = 0;

  ViewerOutput output() {
    return {[this](const SharedText& state) { states.push_back(Json::parse(*state)); },
            [this](ViewerId viewer, const SharedText& text) { to_one.emplace_back(viewer, Json::parse(*text)); },
            [this](const SharedText& text) { to_all.push_back(Json::parse(*text)); }, [this] { return viewers; },
            [this](ViewerId viewer, const std::string&) { disconnected.push_back(viewer); }};
  }
};

struct Replayed {
  TemporaryFolder folder;
  Sent sent;
  ReplayView view{a_recording_to_view(folder), sent.output()};

  void join(ViewerId viewer) {
    ++sent.viewers;
    view.inbox().joined(viewer);
    view.pass(0.0);
  }
};

TEST(ReplayView, GreetsWhoJoins) {
  Replayed replay;
  replay.join(7);
  ASSERT_EQ(replay.sent.to_one.size(), 3U);
  for (const auto& [viewer, message] : replay.sent.to_one) EXPECT_EQ(viewer, 7U);
  EXPECT_EQ(replay.sent.to_one[0].second, Json::parse(R"({"type":"welcome","viewer":7})"));
  EXPECT_EQ(replay.sent.to_one[1].second["mode"], "replay");
  EXPECT_EQ(replay.sent.to_one[1].second["name"], "first");
  EXPECT_EQ(replay.sent.to_one[2].second["method"], "proxy");
  ASSERT_EQ(replay.sent.states.size(), 1U);
  EXPECT_EQ(replay.sent.states[0]["place"], 0);
  EXPECT_EQ(replay.sent.states[0]["viewers"], 1);
}

TEST(ReplayView, TimeStandsStillWhileNobodyLooks) {
  Replayed replay;
  replay.view.pass(3.0);
  EXPECT_TRUE(replay.sent.states.empty());
  replay.join(1);
  replay.view.pass(1.0);
  EXPECT_EQ(replay.sent.states.back()["place"], 10);
}

TEST(ReplayView, ObeysAPage) {
  Replayed replay;
  replay.join(1);
  replay.view.inbox().received(1, R"({"type":"pause"})");
  replay.view.pass(1.0);
  EXPECT_EQ(replay.sent.states.back()["place"], 0);
  EXPECT_EQ(replay.sent.states.back()["paused"], true);
  replay.view.inbox().received(1, R"({"type":"seek","t":2.05})");
  replay.view.inbox().received(1, R"({"type":"play","speed":2})");
  replay.view.pass(1.0);
  EXPECT_EQ(replay.sent.states.back()["place"], 40);
  EXPECT_EQ(replay.sent.states.back()["paused"], false);
}

TEST(ReplayView, TellsAllWhenSceneOrSettingsChange) {
  Replayed replay;
  replay.join(1);
  replay.view.pass(4.0);
  EXPECT_TRUE(replay.sent.to_all.empty());
  replay.view.pass(2.0);
  ASSERT_EQ(replay.sent.to_all.size(), 1U);
  EXPECT_EQ(replay.sent.to_all[0]["name"], "second");
  replay.view.pass(2.5);
  ASSERT_EQ(replay.sent.to_all.size(), 2U);
  EXPECT_EQ(replay.sent.to_all[1]["method"], "paper");
}

// Somebody joins in the very round in which another goes to a time with another scene: both must know it.
TEST(ReplayView, WhoWasThereLearnsTheSceneThoughAnotherWasGreetedWithIt) {
  Replayed replay;
  replay.join(1);
  replay.view.inbox().received(1, R"({"type":"seek","t":7})");
  replay.join(2);
  EXPECT_EQ(replay.sent.to_one.at(4).second["name"], "second");
  ASSERT_EQ(replay.sent.to_all.size(), 1U);
  EXPECT_EQ(replay.sent.to_all[0]["name"], "second");
}

TEST(ReplayView, AnswersWhatItCannotDoToTheSenderAlone) {
  Replayed replay;
  replay.join(1);
  replay.join(2);
  replay.sent.to_one.clear();
  replay.view.inbox().received(2, R"({"type":"step"})");
  replay.view.inbox().received(2, "nonsense");
  replay.view.pass(0.0);
  ASSERT_EQ(replay.sent.to_one.size(), 2U);
  for (const auto& [viewer, message] : replay.sent.to_one) {
    EXPECT_EQ(viewer, 2U);
    EXPECT_EQ(message["type"], "notice");
  }
  EXPECT_THAT(replay.sent.to_one[0].second["text"].get<std::string>(), HasSubstr("This is a recording"));
  EXPECT_TRUE(replay.sent.to_all.empty());
}

TEST(ReplayView, DisconnectsWhoKeepsOnSendingNonsense) {
  Replayed replay;
  replay.join(1);
  replay.join(2);
  for (int i = 0; i < 40; ++i) replay.view.inbox().received(1, "nonsense");
  replay.view.pass(0.0);
  EXPECT_TRUE(replay.sent.disconnected.empty());
  for (int i = 0; i < 40; ++i) replay.view.inbox().received(1, "nonsense");
  replay.view.pass(0.0);
  EXPECT_THAT(replay.sent.disconnected, ::testing::Each(1U));
  EXPECT_FALSE(replay.sent.disconnected.empty());
}

TEST(ReplayView, OfACutRecordingWarns) {
  const TemporaryFolder folder;
  const auto file = a_recording_to_view(folder);
  std::filesystem::resize_file(file, std::filesystem::file_size(file) / 2);
  Sent sent;
  ReplayView view(file, sent.output());
  EXPECT_THAT(view.warning(), ::testing::AllOf(HasSubstr("was cut"), HasSubstr(" s.")));
  sent.viewers = 1;
  view.inbox().joined(1);
  view.pass(0.0);
  ASSERT_EQ(sent.to_one.size(), 4U);
  EXPECT_EQ(sent.to_one[3].second["level"], "warning");
  EXPECT_LT(view.session().duration(), 9.0);
}

TEST(ReplayView, RunsUntilItIsStopped) {
  Replayed replay;
  const std::atomic<bool> stop{true};
  replay.view.run(stop);
  EXPECT_TRUE(replay.sent.states.empty());
}

// SIGTERM, as Ctrl-C may be ignored where tests run; `timeout` gives back the program's own exit code.
TEST(ProgramReplay, EndsWellWhenItIsInterrupted) {
  const TemporaryFolder folder;
  const ProgramResult result =
      run_program({"replay", a_recording_to_view(folder).string(), "--port", "0"}, "timeout --preserve-status -k 60 2");
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, ::testing::AllOf(HasSubstr("a.mcap (10.0 s) at http://127.0.0.1:"), HasSubstr("stopped")));
  EXPECT_EQ(result.err, "");
}

TEST(ProgramReplay, BadInputIsAnsweredWithASentence) {
  const TemporaryFolder folder;
  const std::string none = (folder.path() / "none.mcap").string();
  ProgramResult result = run_program({"replay", none, "--port", "0"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("No such file"));
  result = run_program({"replay", folder.write("a.csv", "t,x\n"), "--port", "0"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("no MCAP recording"));
  const auto ticks_alone = folder.path() / "old.mcap";
  RecordingFile recording(ticks_alone, {}, 0.0);
  recording.write(TickRecord());
  recording.close();
  result = run_program({"replay", ticks_alone.string(), "--port", "0"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("render it again"));
  EXPECT_EQ(run_program({"replay"}).exit_code, 2);
}

}  // namespace
}  // namespace tegotae
