// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/input_error.hpp>
#include <tegotae/lab/live_messages.hpp>
#include <tegotae/lab/live_session.hpp>
#include <tegotae/stream/mcap_reader.hpp>

#include <tests/file_size_limit.hpp>
#include <tests/lab/temporary_folder.hpp>
#include <tests/sweep_size.hpp>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <functional>
#include <iterator>
#include <map>
#include <mutex>
#include <random>
#include <string>
#include <thread>
#include <vector>

// A session as pages see it: what they are sent for what they say. Each test waits for what must come, and fails where
// it has not come within a minute.
namespace tegotae {
namespace {

using Json = nlohmann::json;

LiveScene scene_of(const std::string& file) { return {file, std::filesystem::path(TEGOTAE_SCENES) / file}; }

// A session on a thread of its own, with all that it sends kept.
class Pages {
 public:
  explicit Pages(LiveSessionOptions options) : session_(std::move(options), output(), [](NoticeLevel, const auto&) {}) {
    thread_ = std::thread([this] { session_.run(stop_); });
  }
  ~Pages() { stop(); }

  void stop() {
    stop_ = true;
    if (thread_.joinable()) thread_.join();
  }

  LiveInbox& inbox() { return session_.inbox(); }
  void say(ViewerId viewer, const Json& message) { inbox().received(viewer, message.dump()); }

  // The newest state for which `holds` is true.
  Json state(const std::function<bool(const Json&)>& holds) {
    return wait([&]() -> Json {
      const Json newest = Json::parse(state_.empty() ? "{}" : state_);
      return !newest.empty() && holds(newest) ? newest : Json();
    });
  }
  // The first message of a type for which `holds` is true, sent to `viewer` or to all. It and those before are gone.
  Json message(
      ViewerId viewer, const std::string& type,
      const std::function<bool(const Json&)>& holds = [](const Json&) { return true; }) {
    return wait([&]() -> Json {
      auto& mail = mail_[viewer];
      for (size_t i = 0; i < mail.size(); ++i) {
        Json one = Json::parse(mail[i]);
        if (one["type"] != type || !holds(one)) continue;
        mail.erase(mail.begin(), mail.begin() + static_cast<long>(i) + 1);
        return one;
      }
      return {};
    });
  }

  ViewerId disconnected() {
    return wait([&]() -> Json { return disconnected_.empty() ? Json() : Json(disconnected_.front()); });
  }

 private:
  ViewerOutput output() {
    return {[this](const SharedText& text) { with_lock([&] { state_ = *text; }); },
            [this](ViewerId viewer, const SharedText& text) { with_lock([&] { mail_[viewer].push_back(*text); }); },
            [this](const SharedText& text) {
              with_lock([&] {
                for (auto& [viewer, mail] : mail_) mail.push_back(*text);
              });
            },
            [] { return std::size_t{2}; },
            [this](ViewerId viewer, const std::string&) { with_lock([&] { disconnected_.push_back(viewer); }); }};
  }
  void with_lock(const std::function<void()>& what) {
    const std::lock_guard lock(mutex_);
    what();
  }
  Json wait(const std::function<Json()>& look) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(1);
    while (std::chrono::steady_clock::now() < deadline) {
      Json found;
      with_lock([&] { found = look(); });
      if (!found.is_null()) return found;
      std::this_thread::sleep_for(std::chrono::milliseconds(2));
    }
    ADD_FAILURE() << "it has not come";
    return Json::object();
  }

  std::mutex mutex_;
  std::string state_;
  std::vector<ViewerId> disconnected_;
  std::map<ViewerId, std::vector<std::string>> mail_;
  std::atomic<bool> stop_{false};
  LiveSession session_;
  std::thread thread_;
};

LiveSessionOptions table() {
  LiveSessionOptions options;
  options.scene = scene_of("table.xml");
  options.scenes = {scene_of("table.xml"), scene_of("cube-on-floor.xml")};
  return options;
}

double force(const Json& state) {
  const auto& w = state["wrench"];
  return Vector3(w[0].get<double>(), w[1].get<double>(), w[2].get<double>()).norm();
}

Json hand_message_at(double z) { return {{"type", "hand"}, {"pose", {0.0, -0.02, z, 1.0, 0.0, 0.0, 0.0}}}; }

TEST(LiveSession, GreetsWhoComesWithNumberSceneAndSettings) {
  Pages pages(table());
  pages.inbox().joined(7);
  EXPECT_EQ(pages.message(7, "welcome")["viewer"], 7);
  const Json shown = pages.message(7, "scene");
  EXPECT_EQ(shown["name"], "table.xml");
  EXPECT_EQ(shown["mode"], "live");
  EXPECT_EQ(shown["scenes"].size(), 2u);
  EXPECT_GE(shown["experiments"].size(), 20u);
  EXPECT_GE(shown["motions"].size(), 3u);
  const Json settings = pages.message(7, "settings");
  EXPECT_EQ(settings["method"], "proxy");
  const Json state = pages.state([](const Json& s) { return s["n"] > 3; });
  EXPECT_EQ(state["bodies"].size(), 6u);
  EXPECT_EQ(state["viewers"], 2);
  EXPECT_TRUE(state["hand"].is_null());
}

TEST(LiveSession, ThePageIsTheHandUntilItLetsGo) {
  Pages pages(table());
  pages.inbox().joined(1);
  pages.inbox().joined(2);
  pages.say(1, hand_message_at(0.455));
  const Json pressed = pages.state([](const Json& s) { return force(s) > 1.0; });
  EXPECT_EQ(pressed["hand"], 1);
  EXPECT_NEAR(pressed["proxy"][2].get<double>(), 0.465, 1e-4);
  EXPECT_LT(pressed["tool"][2].get<double>(), 0.465);
  pages.say(1, hand_message_at(0.455));
  pages.say(2, hand_message_at(0.6));
  pages.say(1, {{"type", "release"}});
  pages.state([](const Json& s) { return s["hand"].is_null(); });
  EXPECT_GT(force(pages.state([](const Json& s) { return !s["target"].is_null(); })), 1.0) << "it stays where it was";
  pages.say(2, hand_message_at(0.6));
  pages.state([](const Json& s) { return s["hand"] == 2 && force(s) == 0.0; });
  pages.inbox().left(2);
  pages.state([](const Json& s) { return s["hand"].is_null(); });
}

TEST(LiveSession, ASettingIsToldToAllAndARefusalToOne) {
  Pages pages(table());
  pages.inbox().joined(1);
  pages.inbox().joined(2);
  const auto value = [](const Json& settings, const char* name) {
    for (const Json& one : settings["values"]) {
      if (one["name"] == name) return one["value"].get<double>();
    }
    return -1.0;
  };
  pages.say(1, {{"type", "set"}, {"name", "stiffness"}, {"value", 800.0}});
  pages.message(2, "settings", [&](const Json& s) { return value(s, "stiffness") == 800.0; });
  pages.say(2, {{"type", "set"}, {"name", "stiffness"}, {"value", -3.0}});
  EXPECT_NE(pages.message(2, "notice", [](const Json& n) { return n["level"] == "error"; })["text"], "");
  EXPECT_EQ(value(pages.message(2, "settings"), "stiffness"), 800.0) << "what holds is shown again";
  pages.say(1, {{"type", "method"}, {"name", "ortega"}});
  const Json settings = pages.message(2, "settings", [](const Json& s) { return s["method"] == "ortega"; });
  // What is said to be the most can be set.
  for (const Json& one : settings["values"]) {
    if (one["name"] != "stiffness") continue;
    pages.say(1, {{"type", "set"}, {"name", "stiffness"}, {"value", one["most"]}});
    pages.message(2, "settings", [&](const Json& s) { return value(s, "stiffness") == one["most"].get<double>(); });
  }
}

TEST(LiveSession, StandsStillWhilePausedAndStartsAnewWhenResetEvenThen) {
  Pages pages(table());
  pages.inbox().joined(1);
  pages.state([](const Json& s) { return s["t"] > 0.3; });
  pages.say(1, {{"type", "step"}});
  EXPECT_EQ(pages.message(1, "notice", [](const Json& n) { return n["level"] == "error"; })["type"], "notice");
  pages.say(1, {{"type", "pause"}});
  const Json paused = pages.state([](const Json& s) { return s["paused"] == true; });
  const int n = paused["n"].get<int>();
  const double t = pages.state([&](const Json& s) { return s["n"] > n + 10; })["t"].get<double>();
  EXPECT_EQ(pages.state([&](const Json& s) { return s["n"] > n + 30; })["t"].get<double>(), t);
  pages.say(1, {{"type", "step"}});
  pages.state([&](const Json& s) { return s["t"] > t + 1e-3; });
  pages.say(1, {{"type", "reset"}});
  pages.state([](const Json& s) { return s["t"] < 0.2 && s["paused"] == false; });
}

TEST(LiveSession, PlaysMotionsScenesAndExperiments) {
  Pages pages(table());
  pages.inbox().joined(1);
  pages.say(1, {{"type", "motion"}, {"name", "press"}});
  pages.state([](const Json& s) { return s["motion"] == "press" && force(s) > 0.5; });
  pages.say(1, {{"type", "stop"}});
  pages.state([](const Json& s) { return s["motion"].is_null(); });
  pages.say(1, {{"type", "scene"}, {"name", "cube-on-floor.xml"}});
  pages.message(1, "scene", [](const Json& s) { return s["name"] == "cube-on-floor.xml"; });
  pages.say(1, {{"type", "method"}, {"name", "paper"}});
  pages.say(1, {{"type", "experiment"}, {"name", "overhang"}});
  pages.message(1, "scene", [](const Json& s) { return s["name"] == "overhang"; });
  EXPECT_EQ(pages.message(1, "settings")["method"], "paper") << "the method that was chosen stays";
  const Json playing = pages.state([](const Json& s) { return s["motion"] == "overhang" && s["t"] > 0.1; });
  EXPECT_TRUE(playing["target"].is_null()) << "no hand means anything while an experiment plays";
  pages.say(1, hand_message_at(1.0));
  pages.state([](const Json& s) { return s["motion"].is_null() && !s["target"].is_null(); });
  pages.say(1, {{"type", "scene"}, {"name", "../../etc/passwd"}});
  const Json refusal = pages.message(1, "notice", [](const Json& s) { return s["level"] == "error"; });
  EXPECT_NE(refusal["text"].get<std::string>().find("there are: table.xml"), std::string::npos) << refusal["text"];
}

TEST(LiveSession, RecordsWhatThePagesSaw) {
  const TemporaryFolder folder;
  LiveSessionOptions options = table();
  options.recordings = folder.path();
  Pages pages(options);
  pages.inbox().joined(1);
  pages.say(1, {{"type", "record"}, {"on", true}});
  const Json recording =
      pages.state([](const Json& s) { return s["recording"] == true && s["recording_ticks"] > 500; });
  const std::filesystem::path file = recording["recording_file"].get<std::string>();
  EXPECT_EQ(file.parent_path(), folder.path());
  pages.say(1, {{"type", "set"}, {"name", "stiffness"}, {"value", 600.0}});
  pages.say(1, {{"type", "record"}, {"on", false}});
  pages.message(1, "notice",
                [](const Json& s) { return s["text"].get<std::string>().find("ticks recorded") != std::string::npos; });
  std::map<std::string, int> topics;
  const McapEnd end = read_mcap(file, [&](const McapMessage& message) { ++topics[std::string(message.topic)]; });
  EXPECT_TRUE(end.complete);
  EXPECT_EQ(topics["/tegotae/scene"], 1);
  EXPECT_EQ(topics["/tegotae/settings"], 2);
  EXPECT_GT(topics["/tegotae/state"], 10);
  EXPECT_GT(topics["/tegotae/tick"], 500);
}

TEST(LiveSession, DoesNotBeginWhereTheRecordingAskedForCannotBeWritten) {
  for (const std::string file : {"/no/such/folder/run.mcap", "/dev/full"}) {
    LiveSessionOptions options = table();
    options.file = file;
    try {
      Pages pages(options);
      FAIL() << file;
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find(file), std::string::npos) << error.what();
    }
  }
}

TEST(LiveSession, ARecordingGoesOnThroughScenesAndItsTimeNeverFalls) {
  const TemporaryFolder folder;
  LiveSessionOptions options = table();
  options.file = folder.path() / "run.mcap";
  {
    Pages pages(options);
    pages.inbox().joined(1);
    pages.state([](const Json& s) { return s["t"] > 0.3; });
    pages.say(1, {{"type", "reset"}});
    pages.state([](const Json& s) { return s["t"] < 0.2; });
    pages.state([](const Json& s) { return s["t"] > 0.3; });
    pages.say(1, {{"type", "scene"}, {"name", "cube-on-floor.xml"}});
    pages.message(1, "scene", [](const Json& s) { return s["name"] == "cube-on-floor.xml"; });
    pages.state([](const Json& s) { return s["t"] < 0.2; });
    pages.state([](const Json& s) { return s["t"] > 0.3 && s["recording"] == true; });
  }
  std::vector<std::string> scenes;
  std::map<std::string, double> before;
  read_mcap(*options.file, [&](const McapMessage& message) {
    const Json content = Json::parse(message.data);
    const std::string topic(message.topic);
    if (topic == "/tegotae/scene") scenes.push_back(content["name"]);
    if (!content.contains("t")) return;
    ASSERT_GT(content["t"].get<double>(), before.emplace(topic, -1.0).first->second) << topic;
    before[topic] = content["t"];
  });
  EXPECT_EQ(scenes, (std::vector<std::string>{"table.xml", "table.xml", "cube-on-floor.xml"}));
  EXPECT_GT(before["/tegotae/tick"], 0.9);
  EXPECT_GT(before["/tegotae/state"], 0.9);
}

TEST(LiveSession, RecordingsOfOneSecondDoNotReplaceEachOther) {
  const TemporaryFolder folder;
  LiveSessionOptions options = table();
  options.recordings = folder.path();
  Pages pages(options);
  pages.inbox().joined(1);
  constexpr int kRecordings = 4;
  for (int i = 0; i < 2 * kRecordings; ++i) pages.say(1, {{"type", "record"}, {"on", i % 2 == 0}});
  for (int i = 0; i < kRecordings; ++i) {
    pages.message(1, "notice", [](const Json& s) {
      return s["text"].get<std::string>().find("ticks recorded") != std::string::npos;
    });
  }
  const std::filesystem::directory_iterator files(folder.path());
  EXPECT_EQ(std::distance(begin(files), end(files)), kRecordings);
}

// As somebody edits the file while it is shown.
TEST(LiveSession, ASceneThatCanNoLongerBeLoadedIsWaitedFor) {
  const TemporaryFolder folder;
  const std::filesystem::path good = std::filesystem::path(TEGOTAE_SCENES) / "cube-on-floor.xml";
  const std::filesystem::path file = folder.path() / "edited.xml";
  std::filesystem::copy_file(good, file);
  LiveSessionOptions options = table();
  options.scene = {"edited.xml", file};
  Pages pages(options);
  pages.inbox().joined(1);
  pages.state([](const Json& s) { return s["t"] > 0.2; });
  std::ofstream(file) << "<mujoco><none/></mujoco>";
  pages.say(1, {{"type", "reset"}});
  const Json notice = pages.message(1, "notice", [](const Json& n) { return n["level"] == "error"; });
  EXPECT_NE(notice["text"].get<std::string>().find("edited.xml"), std::string::npos) << notice["text"];
  pages.inbox().joined(2);
  EXPECT_EQ(pages.message(2, "scene")["name"], "edited.xml") << "who comes meanwhile is greeted";
  std::filesystem::copy_file(good, file, std::filesystem::copy_options::overwrite_existing);
  pages.say(2, {{"type", "reset"}});
  pages.message(2, "scene");
  pages.state([](const Json& s) { return s["t"] < 0.2; });
  pages.state([](const Json& s) { return s["t"] > 0.2; });
}

TEST(LiveSession, ASceneThatCannotBeLoadedGivesWayToTheOneBefore) {
  const TemporaryFolder folder;
  LiveSessionOptions options = table();
  options.scenes.push_back({"gone.xml", folder.path() / "gone.xml"});
  Pages pages(options);
  pages.inbox().joined(1);
  pages.say(1, {{"type", "scene"}, {"name", "gone.xml"}});
  pages.message(1, "notice", [](const Json& n) { return n["level"] == "error"; });
  EXPECT_EQ(pages.message(1, "scene")["name"], "table.xml");
  pages.state([](const Json& s) { return s["t"] > 0.2; });
}

TEST(LiveSession, AFullDiskEndsTheRecordingAndNothingElse) {
  const TemporaryFolder folder;
  const test::FileSizeLimit disk(200'000);
  LiveSessionOptions options = table();
  options.file = folder.path() / "run.mcap";
  Pages pages(options);
  pages.inbox().joined(1);
  const Json notice = pages.message(1, "notice", [](const Json& n) { return n["level"] == "error"; });
  EXPECT_NE(notice["text"].get<std::string>().find("run.mcap"), std::string::npos) << notice["text"];
  const Json state = pages.state([](const Json& s) { return s["recording"] == false; });
  pages.state([&](const Json& s) { return s["t"] > state["t"].get<double>() + 0.5; });
  pages.stop();
  EXPECT_LE(std::filesystem::file_size(*options.file), 200'000U);
}

TEST(LiveSession, APageThatOnlyTalksNonsenseIsDisconnected) {
  Pages pages(table());
  pages.inbox().joined(4);
  pages.inbox().joined(5);
  pages.say(5, {{"type", "pause"}});
  for (int i = 0; i < 60; ++i) pages.inbox().received(4, "{]");
  EXPECT_EQ(pages.disconnected(), 4u);
  pages.say(5, {{"type", "resume"}});
  pages.state([](const Json& s) { return s["paused"] == false; });
}

TEST(LiveSession, WhatFramesSayNeverStopsIt) {
  Pages pages(table());
  pages.inbox().joined(1);
  const std::vector<std::string> types = {"hand",   "release", "set",    "method", "pause", "resume",
                                          "step",   "reset",   "motion", "stop",   "scene", "experiment",
                                          "record", "seek",    "play",   "?"};
  const std::vector<Json> values = {
      nullptr, true,    -1.0,        1e300,  "stiffness",   "physics_rate",         "proxy",
      "paper", "press", "table.xml", "../x", Json::array(), Json::array({1, 2, 3}), Json::object()};
  std::mt19937 random(20251);
  const auto any = [&](const auto& all) { return all[random() % all.size()]; };
  const int messages = test::sweep_size(3000);
  for (int i = 0; i < messages; ++i) {
    Json message = {{"type", any(types)}};
    // No recording here, and no scene that takes long to load each time.
    if (message["type"] == "record" || message["type"] == "experiment") continue;
    for (const char* member : {"name", "value", "pose", "on", "t", "speed"}) {
      if (random() % 2 == 0) message[member] = any(values);
    }
    std::string text = message.dump();
    if (random() % 4 == 0) text.resize(random() % (text.size() + 1));
    pages.inbox().received(1, text);
    if (i % 50 == 0) std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  pages.say(1, {{"type", "resume"}});
  const int n = pages.state([](const Json& s) { return s["n"] > 0; })["n"].get<int>();
  pages.state([&](const Json& s) { return s["n"] < n || s["n"] > n + 5; });
}

}  // namespace
}  // namespace tegotae
