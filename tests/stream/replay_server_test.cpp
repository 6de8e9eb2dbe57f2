// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/recording_file.hpp>
#include <tegotae/lab/replay_view.hpp>
#include <tegotae/stream/short_messages.hpp>
#include <tegotae/stream/viewer_server.hpp>

#include <tests/lab/temporary_folder.hpp>
#include <tests/stream/web_client.hpp>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <atomic>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <utility>

namespace tegotae {
namespace {

using Json = nlohmann::json;

std::filesystem::path a_recording(const TemporaryFolder& folder) {
  auto file = folder.path() / "a.mcap";
  RecordingFile recording(file, {}, 0.0);
  recording.write_scene(0.0, R"({"type":"scene","name":"table.xml"})");
  for (int i = 0; i <= 6000; ++i) {
    const double time = static_cast<double>(i) / 60.0;
    recording.write_state(time, Json{{"type", "state"}, {"t", time}, {"place", i}}.dump());
  }
  recording.close();
  EXPECT_EQ(recording.error(), "");
  return file;
}

/// A replay on a thread of its own, and a server for it, as the command `replay` has them.
class ServedReplay {
 public:
  ServedReplay() : server_(options()), view_(a_recording(folder_), output()) {
    server_.start({[this](ViewerId viewer) { view_.inbox().joined(viewer); },
                   [this](ViewerId viewer, std::string_view text) { view_.inbox().received(viewer, text); },
                   [this](ViewerId viewer) { view_.inbox().left(viewer); }});
    thread_ = std::thread([this] { view_.run(stop_); });
  }
  ServedReplay(const ServedReplay&) = delete;
  ServedReplay& operator=(const ServedReplay&) = delete;
  ~ServedReplay() { end(); }

  void end() {
    if (!thread_.joinable()) return;
    stop_ = true;
    thread_.join();
    server_.stop(std::make_shared<const std::string>(encode_end("enough.")));
  }
  std::uint16_t port() const { return server_.port(); }

 private:
  static ViewerServerOptions options() {
    ViewerServerOptions options;
    options.port = 0;
    return options;
  }
  ViewerOutput output() {
    return {[this](const SharedText& state) { server_.publish(state); },
            [this](ViewerId viewer, SharedText text) { server_.send(viewer, std::move(text)); },
            [this](const SharedText& text) { server_.send_all(text); }, [this] { return server_.viewer_count(); },
            [this](ViewerId viewer, std::string why) { server_.disconnect(viewer, std::move(why)); }};
  }

  TemporaryFolder folder_;
  ViewerServer server_;
  ReplayView view_;
  std::atomic<bool> stop_{false};
  std::thread thread_;
};

Json next(test::WebSocketClient& client) {
  const std::optional<std::string> text = client.read();
  return text ? Json::parse(*text) : Json{{"type", "closed"}};
}

// The first state from here on that `is_wanted`; fails where a minute's worth of them has none.
template <class Wanted>
Json state_where(test::WebSocketClient& client, const Wanted& is_wanted) {
  for (int i = 0; i < 3600; ++i) {
    Json message = next(client);
    if (message["type"] == "closed") break;
    if (message["type"] == "state" && is_wanted(message)) return message;
  }
  ADD_FAILURE() << "no such state came";
  return {};
}

TEST(ReplayServer, AViewerPlaysPausesAndGoesToATime) {
  ServedReplay served;
  test::WebSocketClient client(served.port());
  ASSERT_EQ(client.status(), 101U);
  EXPECT_EQ(next(client)["type"], "welcome");
  const Json scene = next(client);
  EXPECT_EQ(scene["type"], "scene");
  EXPECT_EQ(scene["mode"], "replay");
  EXPECT_EQ(scene["duration"], 100.0);
  state_where(client, [](const Json& state) { return state["place"] > 0; });
  client.send(R"({"type":"pause"})");
  const Json paused = state_where(client, [](const Json& state) { return state["paused"] == true; });
  EXPECT_EQ(next(client)["place"], paused["place"]);
  client.send(R"({"type":"seek","t":50})");
  const Json later = state_where(client, [&](const Json& state) { return state["place"] != paused["place"]; });
  EXPECT_EQ(later["place"], 3000);
  EXPECT_EQ(later["t"], 50.0);
  client.send(R"({"type":"play","speed":100})");
  state_where(client, [](const Json& state) { return state["place"] == 6000 && state["paused"] == true; });
}

TEST(ReplayServer, SaysTheEndToAllThatLook) {
  ServedReplay served;
  test::WebSocketClient first(served.port()), second(served.port());
  for (test::WebSocketClient* client : {&first, &second}) {
    state_where(*client, [](const Json& state) { return state["viewers"] == 2; });
  }
  served.end();
  for (test::WebSocketClient* client : {&first, &second}) {
    Json message = next(*client), last;
    while (message["type"] != "closed") last = std::exchange(message, next(*client));
    EXPECT_EQ(last, Json::parse(R"({"type":"end","text":"enough."})"));
  }
}

}  // namespace
}  // namespace tegotae
