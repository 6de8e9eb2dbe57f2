// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/recording_schemas.hpp>
#include <tegotae/lab/samples_file.hpp>
#include <tegotae/stream/scene_message.hpp>
#include <tegotae/stream/view_frame.hpp>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <set>
#include <string>
#include <string_view>

namespace tegotae {
namespace {

using Json = nlohmann::json;

// What Foxglove's reader of JSON schemas takes; for anything else it refuses the channel.
void expect_plottable(const Json& schema, const std::string& where) {
  static const std::set<std::string> kPlain = {"boolean", "string", "number", "integer"};
  ASSERT_EQ(schema.at("type"), "object") << where;
  ASSERT_TRUE(schema.at("properties").is_object()) << where;
  for (const auto& [name, property] : schema.at("properties").items()) {
    const std::string here = std::string(where).append(".").append(name);
    ASSERT_TRUE(property.at("type").is_string()) << here;
    const Json& value = property.at("type") == "array" ? property.at("items") : property;
    if (value.at("type") == "object") {
      expect_plottable(value, here);
    } else {
      EXPECT_TRUE(kPlain.contains(value.at("type").get<std::string>())) << here;
    }
  }
}

// Members of a message that its schema declares are of the kind declared; null stands for what is not there.
void expect_described(const Json& message, const Json& schema, const std::set<std::string>& only_described) {
  for (const auto& [name, value] : message.items()) {
    if (only_described.contains(name)) {
      EXPECT_FALSE(schema["properties"].contains(name)) << name;
      continue;
    }
    ASSERT_TRUE(schema["properties"].contains(name)) << name;
    const std::string type = schema["properties"][name]["type"];
    const bool fits = (type == "number" && value.is_number()) || (type == "integer" && value.is_number_integer()) ||
                      (type == "string" && value.is_string()) || (type == "boolean" && value.is_boolean()) ||
                      (type == "array" && value.is_array()) || (type == "object" && value.is_object());
    EXPECT_TRUE(fits || value.is_null()) << name << " is no " << type;
    if (value.is_object()) expect_described(value, schema["properties"][name], {});
  }
}

TEST(RecordingSchemas, AreJsonSchemasThatFoxgloveReads) {
  expect_plottable(Json::parse(schema_of_session()), "session");
  expect_plottable(Json::parse(schema_of_scene()), "scene");
  expect_plottable(Json::parse(schema_of_settings()), "settings");
  expect_plottable(Json::parse(schema_of_state()), "state");
  expect_plottable(Json::parse(schema_of_tick()), "tick");
}

TEST(RecordingSchemas, BearTheNamesOfTheirTopics) {
  EXPECT_EQ(Json::parse(schema_of_session())["title"], kSessionTopic.schema);
  EXPECT_EQ(Json::parse(schema_of_scene())["title"], kSceneTopic.schema);
  EXPECT_EQ(Json::parse(schema_of_settings())["title"], kSettingsTopic.schema);
  EXPECT_EQ(Json::parse(schema_of_state())["title"], kStateTopic.schema);
  EXPECT_EQ(Json::parse(schema_of_tick())["title"], kTickTopic.schema);
}

TEST(RecordingSchemas, DescribeTheMessages) {
  ViewFrame frame;
  frame.histogram = ViewedHistogram{{0.0, 1.0}, {3}};
  frame.recording = ViewedRecording{"a.mcap", 1};
  frame.motion = "press";
  frame.hand = 1;
  frame.target = PlainPose();
  expect_described(Json::parse(encode(frame)), Json::parse(schema_of_state()),
                   {"bodies", "planes", "points", "anchors", "samples"});
  expect_described(Json::parse(encode_settings("proxy", std::vector<ShownSetting>(1))),
                   Json::parse(schema_of_settings()), {});
  expect_described(Json::parse(encode_scene({}, {})), Json::parse(schema_of_scene()),
                   {"tool", "bodies", "experiments", "motions", "methods"});
}

TEST(RecordingSchemas, GiveUnitsOfEveryTickColumnThatHasOne) {
  const Json properties = Json::parse(schema_of_tick())["properties"];
  for (const auto& column : sample_columns(0.0)) {
    ASSERT_TRUE(properties.contains(column.name));
    EXPECT_EQ(properties[column.name].contains("description"), !column.unit.empty()) << column.name;
  }
}

}  // namespace
}  // namespace tegotae
