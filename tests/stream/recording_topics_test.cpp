// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/child_process.hpp>
#include <tegotae/lab/recording_file.hpp>
#include <tegotae/stream/scene_message.hpp>
#include <tegotae/stream/view_frame.hpp>

#include <tests/lab/temporary_folder.hpp>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace tegotae {
namespace {

using Json = nlohmann::json;

SceneGeometry a_scene() {
  SceneGeometry scene;
  scene.tool.name = "tool";
  scene.tool.pieces = {make_box({0.1, 0.2, 0.3})};
  scene.tool.mass = mass_properties(scene.tool.pieces[0], 1000.0);
  return scene;
}

void record(const std::filesystem::path& file) {
  RecordingFile recording(file, {"a note"}, 5.0);
  recording.write_scene(5.0, encode_scene(a_scene(), {}));
  recording.write_settings(5.0, encode_settings("proxy", std::vector<ShownSetting>(1)));
  for (int i = 0; i < 40; ++i) {
    TickRecord tick;
    tick.time = 1e-3 * i;
    recording.write(tick);
    if (i % 16 != 0) continue;
    ViewFrame frame;
    frame.time = 5.0 + tick.time;
    frame.displayed.force = Vector3(0.0, 0.0, 0.25 * i);
    recording.write_state(frame.time, encode(frame));
  }
  recording.write_settings(5.04, encode_settings("paper", {}));
  recording.close();
  ASSERT_EQ(recording.error(), "");
}

// What the format's own library says of a whole recording: every topic, its schema, its times.
TEST(RecordingTopics, AreReadByTheReferenceLibrary) {
  const TemporaryFolder folder;
  record(folder.path() / "a.mcap");
  const std::string script = std::string(TEGOTAE_TESTS) + "/stream/read_with_mcap_core.js";
  const ChildResult result = run_child({"node", script, TEGOTAE_NPM_PACKAGES, (folder.path() / "a.mcap").string(),
                                        (folder.path() / "read.json").string()},
                                       folder.path());
  ASSERT_FALSE(result.not_found);
  ASSERT_EQ(result.exit_code, 0);
  const Json read = Json::parse(contents_of(folder.path() / "read.json"));
  EXPECT_TRUE(read["complete"]);
  EXPECT_EQ(read["statistics"], read["messages"].size());
  std::map<std::string, std::vector<Json>> of_schema;
  for (const Json& message : read["messages"]) {
    EXPECT_EQ(message["encoding"], "json");
    of_schema[message["topic"].get<std::string>() + " " + message["schema"].get<std::string>()].push_back(message);
  }
  ASSERT_EQ(of_schema.size(), 5U);
  EXPECT_EQ(of_schema["/tegotae/session tegotae.Session.v1"].at(0)["data"]["notes"], Json::parse(R"(["a note"])"));
  EXPECT_EQ(of_schema["/tegotae/scene tegotae.Scene.v1"].at(0)["data"]["tool"]["name"], "tool");
  const auto& settings = of_schema["/tegotae/settings tegotae.Settings.v1"];
  ASSERT_EQ(settings.size(), 2U);
  EXPECT_EQ(settings[1]["data"]["method"], "paper");
  const auto& states = of_schema["/tegotae/state tegotae.State.v1"];
  ASSERT_EQ(states.size(), 3U);
  EXPECT_EQ(states[2]["time"], 5032000000);
  EXPECT_EQ(states[2]["data"]["t"], 5.032);
  EXPECT_EQ(states[2]["data"]["wrench"], Json::parse("[0,0,8,0,0,0]"));
  EXPECT_EQ(of_schema["/tegotae/tick tegotae.Tick.v1"].size(), 40U);
}

}  // namespace
}  // namespace tegotae
