// SPDX-License-Identifier: Apache-2.0
#include <tegotae/world/load_failure.hpp>

#include <tests/world/scene_files.hpp>

namespace tegotae {
namespace {

using test::kFloor;
using test::kTool;

class BadScene : public test::SceneFiles {
 protected:
  // One line that holds each of the parts.
  static void expect_says(const std::string& message, const std::vector<std::string>& parts) {
    for (const std::string& part : parts) EXPECT_NE(message.find(part), std::string::npos) << part << "\n  " << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
  std::string refusal_of_text(const std::string& text) const { return refusal_of(write("scene.xml", text)); }
};

TEST_F(BadScene, MissingFile) {
  expect_says(refusal_of(folder() / "none.xml"), {"none.xml", "no such scene file", "check the path"});
  expect_says(refusal_of(folder()), {"is a folder; name the scene file in it"});
}

TEST_F(BadScene, MalformedXml) {
  expect_says(refusal_of_text("<mujoco>\n<worldbody>\n<body>\n</worldbody></mujoco>"),
              {"scene.xml, line 3: malformed XML (mismatched element", "body", "correct the markup"});
  expect_says(refusal_of_text("hello"), {"scene.xml, line 1: malformed XML (parsing text"});
  expect_says(refusal_of_text(""), {"scene.xml: malformed XML (empty document)"});
}

TEST_F(BadScene, IncludedFileThatIsNotThere) {
  const std::string refused = refusal("<include file='gone.xml'/>");
  expect_says(refused, {"scene.xml", "gone.xml' of an <include> is not there", "correct its path"});
  EXPECT_EQ(refused.find("malformed"), std::string::npos) << refused;
}

TEST_F(BadScene, ElementsAttributesAndKeywordsOfNewerMujoco) {
  const std::string needs = "this scene needs a newer MuJoCo than 2.2.2: ";
  expect_says(refusal("<worldbody>\n<frame/>\n</worldbody>"),
              {"scene.xml, line 3: " + needs, "unrecognized element", "'frame'"});
  expect_says(refusal("<worldbody>\n<body gravcomp='1'/>\n</worldbody>"),
              {"scene.xml, line 3: " + needs, "unrecognized attribute: 'gravcomp'", "in element 'body'"});
  expect_says(refusal("<option integrator='implicitfast'/>"),
              {"scene.xml, line 2: " + needs, "invalid keyword: 'implicitfast'"});
  expect_says(refusal("<extension/>"), {"scene.xml, line 2: " + needs, "'extension'"});
  expect_says(refusal("<size memory='10M'/>"), {needs, "'memory'"});
}

TEST_F(BadScene, WhatNoMujocoKnows) {
  const std::string element = refusal("<worldbody>\n<bodyy/>\n</worldbody>");
  expect_says(element, {"scene.xml, line 3: MuJoCo 2.2.2 refuses the scene: unrecognized element", "'bodyy'"});
  EXPECT_EQ(element.find("newer"), std::string::npos);
  expect_says(refusal("<worldbody>\n<geom size='a'/>\n</worldbody>"), {"scene.xml, line 3", "size", "'geom'"});
  expect_says(refusal("<worldbody>\n<body name='b'><freejoint/></body>\n</worldbody>"),
              {"scene.xml, line 3", "mass and inertia of moving bodies", "object 'b'"});
}

TEST_F(BadScene, MeshFileThatIsNotThere) {
  expect_says(refusal("<asset><mesh name='a' file='gone.obj'/></asset><worldbody>" + kTool +
                      "<geom type='mesh' mesh='a'/></worldbody>"),
              {"scene.xml, line 2", "gone.obj", "; put the file there or correct its path"});
}

TEST_F(BadScene, MeshThatIsNotDefined) {
  expect_says(refusal("<worldbody>" + kTool + "<geom type='mesh' mesh='gone'/></worldbody>"),
              {"scene.xml, line 2", "mesh 'gone' not found", "unnamed object", "; define 'gone'", "<asset>"});
}

TEST_F(BadScene, PlanesOnMoreThanOneBody) {
  expect_says(refusal("<worldbody>" + kFloor +
                      "<body name='tool'><geom type='plane' size='1 1 1'/></body>"
                      "<body><freejoint/><geom size='0.1'/></body></worldbody>"),
              {"scene.xml", "only the world may have planes", "thin boxes"});
}

TEST_F(BadScene, NumbersThatAreNot) {
  expect_says(refusal("<worldbody>" + kTool + "<geom size='0.1' pos='nan 0 0'/></worldbody>"), {"scene.xml", "NaN"});
  expect_says(refusal("<option timestep='0'/><worldbody>" + kTool + kFloor + "</worldbody>"),
              {"scene.xml", "time step", "<option>"});
}

TEST_F(BadScene, UnknownToolListsTheBodies) {
  std::string bodies;
  for (int i = 0; i < 12; ++i) bodies += "<body name='b" + std::to_string(i) + "'><geom size='0.1'/></body>";
  const std::string refused = refusal("<worldbody>" + bodies + "</worldbody>", "hammer");
  expect_says(refused, {"scene.xml: there is no body 'hammer'", "the bodies are: 'b0', 'b1'", "'b9' and 2 more"});
  EXPECT_EQ(refused.find("b10"), std::string::npos);
  expect_says(refusal("<worldbody>" + kFloor + "</worldbody>", "hammer"), {"the bodies are: none"});
  expect_says(refusal("<worldbody>" + kTool + kFloor + "</worldbody>", "world"), {"the bodies are: 'tool'"});
  expect_says(refusal("<worldbody>" + kTool + kFloor + "</worldbody>", ""), {"no body ''"});
  expect_says(refusal("<worldbody><body><geom size='0.1'/></body>" + kFloor + "</worldbody>", "body 1"),
              {"the bodies are: body 1 (unnamed: give it a name)"});
}

TEST_F(BadScene, ToolWithJoints) {
  expect_says(refusal("<worldbody><body name='tool'><freejoint/><geom size='0.1'/></body></worldbody>"),
              {"tool body 'tool' has joints", ": remove its joints (mocap=\"true\" may be added then)"});
  const std::string carried = refusal(
      "<worldbody><body name='arm'><joint/><geom size='0.1'/><body name='tool'><geom size='0.1'/></body></body>"
      "</worldbody>");
  expect_says(carried, {"body 'arm', which carries the tool 'tool', has joints", ": remove its joints"});
  EXPECT_EQ(carried.find("mocap"), std::string::npos) << "only children of the world can be mocap bodies";
  expect_says(refusal("<worldbody><body name='tool'><geom size='0.1'/><body><body name='jaw'><joint/>"
                      "<geom size='0.1'/></body></body></body></worldbody>"),
              {"body 'jaw' on the tool 'tool' has joints", ": remove its joints"});
}

TEST_F(BadScene, ToolThatIsTied) {
  const std::string world = "<worldbody>" + kTool +
                            "<body name='b'><freejoint/><geom size='0.1'/>"
                            "<site name='on b'/></body><body name='fixed'><site name='on fixed'/></body></worldbody>";
  expect_says(refusal(world + "<equality><weld name='w' body1='b' body2='tool'/></equality>"),
              {"equality constraint 'w' holds the tool 'tool'", "remove it"});
  expect_says(refusal(world + "<equality><connect body1='tool' anchor='0 0 0'/></equality>"),
              {"equality constraint number 0"});
  EXPECT_EQ(refusal(world + "<equality><connect body1='b' anchor='0 0 0'/></equality>"), "");
  EXPECT_EQ(refusal(world + "<tendon><spatial><site site='on b'/><site site='on fixed'/></spatial></tendon>"), "");
  expect_says(refusal("<worldbody><body name='tool'><geom size='0.1'/><site name='s'/></body><body><freejoint/>"
                      "<geom size='0.1'/><site name='t'/></body></worldbody>"
                      "<tendon><spatial name='rope'><site site='t'/><site site='s'/></spatial></tendon>"),
              {"tendon 'rope' holds the tool"});
}

TEST_F(BadScene, NothingToTouchWith) {
  expect_says(refusal("<worldbody><body name='tool' mocap='true'/>" + kFloor + "</worldbody>"),
              {"the tool 'tool' has no contact geometry", "add a geom"});
  expect_says(
      refusal("<worldbody><body name='tool' mocap='true'><geom size='0.1' contype='0' conaffinity='0'/></body>" +
              kFloor + "</worldbody>"),
      {"the tool 'tool' has no contact geometry", "contype"});
  expect_says(refusal("<worldbody>" + kTool + "</worldbody>"), {"nothing but the tool has contact geometry"});
  expect_says(refusal("<worldbody><body><geom type='box' size='1 1 1'/></body>"
                      "<body name='tool'><geom name='p' type='plane' size='1 1 1'/></body>"
                      "</worldbody>"),
              {"geom 'p' of the tool is a plane", "thin box"});
}

TEST_F(BadScene, MoreMovingBodiesThanTheExchangeHolds) {
  const auto scene = [](int count) {
    std::string bodies;
    for (int i = 0; i < count; ++i) {
      bodies += "<body pos='" + std::to_string(i) + " 0 1'><joint/><geom size='0.1'/></body>";
    }
    return "<worldbody>" + kTool + bodies + "</worldbody>";
  };
  expect_says(refusal(scene(257)), {"257 moving bodies", "256 is the most", "remove joints"});
  EXPECT_EQ(refusal(scene(256)), "");
}

TEST_F(BadScene, HapticSettings) {
  const auto scene = [](const std::string& numeric) {
    return "<custom><numeric " + numeric + "/></custom><worldbody>" + kTool + kFloor + "</worldbody>";
  };
  expect_says(refusal(scene("name='tegotae_margin' data='1 2'")), {"'tegotae_margin' has 2 numbers", "give it one"});
  EXPECT_EQ(refusal(scene("name='others_setting' data='-1 2 3'")), "");
}

TEST_F(BadScene, HapticSettingsAreReadWithoutTheirPrefix) {
  const auto world = load(R"(<option gravity="1 2 3"/><custom><numeric name="tegotae_stiffness" data="1"/>
    <numeric name="others" data="7"/><numeric name="tegotae_damping" data="2"/></custom><worldbody>)" +
                          kTool + kFloor + "</worldbody>");
  const std::vector<HapticSettingInScene>& settings = world->haptic_settings();
  ASSERT_EQ(settings.size(), 2U);
  EXPECT_EQ(settings[0].name, "stiffness");
  EXPECT_EQ(settings[0].value, 1.0);
  EXPECT_EQ(settings[1].name, "damping");
  EXPECT_EQ(settings[1].value, 2.0);
  EXPECT_EQ(world->gravity(), Vector3(1.0, 2.0, 3.0));
}

TEST_F(BadScene, Options) {
  const std::string scene = "<worldbody>" + kTool + kFloor + "</worldbody>";
  MujocoWorldOptions options;
  options.max_substep = 0.0;
  EXPECT_THROW(load(scene, options), std::invalid_argument);
  options = {};
  options.max_contacts = 0;
  EXPECT_THROW(load(scene, options), std::invalid_argument);
}

TEST_F(BadScene, UrdfLinksThatCannotMoveNeedAWordToStay) {
  const auto urdf = [&](const std::string& compiler) {
    const std::string link = R"(<inertial><mass value="1"/><inertia ixx="1" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>
      </inertial><collision><geometry><box size="0.1 0.1 0.1"/></geometry></collision></link>)";
    return write("robot.urdf",
                 R"(<robot name="r">)" + compiler + R"(<link name="base">)" + link + R"(<link name="tool">)" + link +
                     R"(<joint name="j" type="fixed"><parent link="base"/><child link="tool"/></joint></robot>)");
  };
  expect_says(refusal_of(urdf("")), {"robot.urdf", "no body 'tool'", "fusestatic=\"false\""});
  const auto world = load_mujoco_world(urdf(R"(<mujoco><compiler fusestatic="false"/></mujoco>)"), "tool");
  EXPECT_EQ(world->geometry().tool.pieces.size(), 1U);
  EXPECT_EQ(world->geometry().tool.pieces[0].size, Vector3::Constant(0.05));
  EXPECT_EQ(world->geometry().bodies.size(), 1U);
}

// The first, a middle and the last word of each list, and words that only look like them.
TEST(LoadFailure, KnowsNewerMarkup) {
  const auto is_newer = [](const std::string& text) {
    return describe_load_failure("a.xml", "XML Error: " + text).find("needs a newer MuJoCo") != std::string::npos;
  };
  for (const char* element : {"attach", "flexcomp", "plugin", "tactile"}) {
    EXPECT_TRUE(is_newer("Schema violation: unrecognized element\n\nElement '" + std::string(element) + "', line 3\n"));
  }
  for (const char* attribute : {"actdim", "maxhullvert", "sleep"}) {
    EXPECT_TRUE(is_newer("Schema violation: unrecognized attribute: '" + std::string(attribute) + "'\n"));
  }
  for (const char* keyword : {"implicitfast", "sdf"}) {
    EXPECT_TRUE(is_newer("invalid keyword: '" + std::string(keyword) + "'\nElement 'option', line 2\n"));
  }
  for (const char* attribute : {"act", "dim", "", "pos", "plug in"}) {
    EXPECT_FALSE(is_newer("Schema violation: unrecognized attribute: '" + std::string(attribute) + "'\n"));
  }
}

TEST(LoadFailure, KeepsWhatItCannotRead) {
  EXPECT_EQ(describe_load_failure("a.xml", "Error: something odd"),
            "a.xml: MuJoCo 2.2.2 refuses the scene: something odd; correct it there");
}

}  // namespace
}  // namespace tegotae
