// SPDX-License-Identifier: Apache-2.0
#include <tegotae/stream/scene_message.hpp>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <vector>

namespace tegotae {
namespace {

using Json = nlohmann::json;

SceneGeometry scene_of_message() {
  SceneGeometry scene;
  scene.tool.name = "tool";
  scene.tool.pieces.push_back(make_box({0.1, 0.2, 0.3}, {{0.0, 0.0, 1.0}, Quaternion::Identity()}));
  scene.tool.pieces[0].colour = {0.82F, 0.47F, 0.1F, 0.5F};
  scene.tool.mass = mass_properties(scene.tool.pieces[0], 1000.0);
  Body& floor = scene.bodies.emplace_back();
  floor.name = "floor";
  floor.pieces = {make_plane(), make_sphere(0.5)};
  Body& block = scene.bodies.emplace_back();
  block.name = "block \"1\"";
  block.moving_index = 0;
  block.X_WB.p = Vector3(1.0, 2.0, 3.0);
  const std::vector<Vector3> points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.5, 0.5, 1}};
  block.pieces = {make_hull(points)};
  scene.moving_count = 1;
  return scene;
}

SceneNames some_names() {
  SceneNames names;
  names.name = "table.xml";
  names.program = "tegotae test";
  names.scenes = {"table", "peg"};
  names.experiments = {{"edge-to-face", "An edge becomes a face."}};
  names.methods = {{"proxy", "The default."}, {"paper", "As published."}};
  return names;
}

TEST(SceneMessage, SaysWhatTheProtocolHas) {
  const Json scene = Json::parse(encode_scene(scene_of_message(), some_names()));
  EXPECT_EQ(scene["type"], "scene");
  EXPECT_EQ(scene["protocol"], 1);
  EXPECT_EQ(scene["mode"], "live");
  EXPECT_EQ(scene["name"], "table.xml");
  EXPECT_EQ(scene["program"], "tegotae test");
  EXPECT_EQ(scene["z_up"], Json::parse("[0,0,1]"));
  EXPECT_EQ(scene["interface"], "page");
  EXPECT_EQ(scene["scenes"], Json::parse(R"(["table", "peg"])"));
  EXPECT_EQ(scene["experiments"][0]["summary"], "An edge becomes a face.");
  EXPECT_EQ(scene["motions"], Json::array());
  EXPECT_EQ(scene["methods"][1]["name"], "paper");
  EXPECT_FALSE(scene.contains("duration"));
}

TEST(SceneMessage, SaysToolAndBodies) {
  const Json scene = Json::parse(encode_scene(scene_of_message(), some_names()));
  const Json& tool = scene["tool"];
  EXPECT_EQ(tool["name"], "tool");
  EXPECT_EQ(tool["centre_of_mass"], Json::parse("[0,0,1]"));
  EXPECT_NEAR(tool["gyration_length"], scene_of_message().tool.mass.gyration_length(), 1e-7);
  EXPECT_EQ(tool["shapes"], Json::parse(R"([{"kind": "box", "size": [0.1, 0.2, 0.3], "pose": [0, 0, 1, 1, 0, 0, 0],
                                             "colour": [0.82, 0.47, 0.1, 0.5]}])"));
  ASSERT_EQ(scene["bodies"].size(), 2U);
  EXPECT_EQ(scene["bodies"][0]["moving_index"], -1);
  EXPECT_EQ(scene["bodies"][0]["shapes"][0]["kind"], "plane");
  EXPECT_EQ(scene["bodies"][0]["shapes"][1]["size"], Json::parse("[0.5, 0, 0]"));
  EXPECT_FALSE(scene["bodies"][0]["shapes"][1].contains("vertices"));
  EXPECT_EQ(scene["bodies"][1]["name"], "block \"1\"");
  EXPECT_EQ(scene["bodies"][1]["moving_index"], 0);
  EXPECT_EQ(scene["bodies"][1]["pose"], Json::parse("[1,2,3,1,0,0,0]"));
}

// The divergence theorem: triangles that close a surface and run counter-clockwise from outside enclose its volume.
TEST(SceneMessage, TrianglesOfAHullEncloseIt) {
  const Json hull = Json::parse(encode_scene(scene_of_message(), some_names()))["bodies"][1]["shapes"][0];
  const auto numbers = hull["vertices"].get<std::vector<double>>();
  const auto corners = hull["triangles"].get<std::vector<std::size_t>>();
  ASSERT_EQ(numbers.size(), 15U);
  ASSERT_EQ(corners.size(), 18U);  // four sides and the square, of two
  const auto vertex = [&](std::size_t i) { return Vector3(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]); };
  const Vector3 inside(0.5, 0.5, 0.25);
  double volume = 0.0;
  for (std::size_t t = 0; t < corners.size(); t += 3) {
    const Vector3 a = vertex(corners[t]) - inside, b = vertex(corners[t + 1]) - inside,
                  c = vertex(corners[t + 2]) - inside;
    EXPECT_GT(a.dot(b.cross(c)), 0.0);
    volume += a.dot(b.cross(c)) / 6.0;
  }
  EXPECT_NEAR(volume, 1.0 / 3.0, 1e-6);
}

TEST(SceneMessage, SaysTheDurationOfAReplay) {
  SceneNames names = some_names();
  names.mode = "replay";
  names.duration = 12.5;
  const Json scene = Json::parse(encode_scene(scene_of_message(), names));
  EXPECT_EQ(scene["mode"], "replay");
  EXPECT_EQ(scene["duration"], 12.5);
}

TEST(SceneMessage, UpIsAgainstGravity) {
  EXPECT_EQ(up_axis({0.0, 0.0, -9.81}), Vector3::UnitZ());
  EXPECT_EQ(up_axis({0.0, -9.81, 0.0}), Vector3::UnitY());
  EXPECT_EQ(up_axis({0.0, -1.0, -9.0}), Vector3::UnitZ());
  EXPECT_EQ(up_axis(Vector3::Zero()), Vector3::UnitZ());
}

TEST(SettingsMessage, SaysEachSetting) {
  const std::vector<ShownSetting> settings = {
      {"stiffness", "Stiffness", "N/m", 1000.0, 1e-3, 1e6, false, false, true},
      {"friction", "Friction", "", std::nullopt, 0.0, 10.0, true, false, false}};
  EXPECT_EQ(Json::parse(encode_settings("paper", settings)), Json::parse(R"({
    "type": "settings", "method": "paper", "values": [
      {"name": "stiffness", "label": "Stiffness", "unit": "N/m", "value": 1000, "least": 0.001, "most": 1000000,
       "zero_too": false, "is_switch": false, "available": true},
      {"name": "friction", "label": "Friction", "unit": "", "value": null, "least": 0, "most": 10,
       "zero_too": true, "is_switch": false, "available": false}]})"));
}

}  // namespace
}  // namespace tegotae
