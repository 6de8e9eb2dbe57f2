// SPDX-License-Identifier: Apache-2.0
#include <tests/world/scene_files.hpp>

#include <map>

namespace tegotae {
namespace {

using test::kFloor;
using test::kTool;
using test::no_impulses;
using test::states_of;

class ContactRules : public test::SceneFiles {
 protected:
  // Which bodies each piece of the tool may touch, by name.
  static std::vector<std::map<std::string, bool>> touches(const MujocoWorld& world) {
    std::vector<std::map<std::string, bool>> result;
    for (const Shape& tool : world.geometry().tool.pieces) {
      auto& row = result.emplace_back();
      for (const Body& body : world.geometry().bodies) row[body.name] = may_touch(tool, body.pieces[0]);
    }
    return result;
  }
};

const std::string kBodies = R"(<worldbody>
  <body name="tool" mocap="true" pos="0 0 9"><geom name="handle" size="0.1" contype="1" conaffinity="2"/>
    <body name="tip"><geom name="tip" size="0.1" contype="4" conaffinity="0"/></body></body>
  <body name="a"><geom name="a" size="0.1" contype="0" conaffinity="1"/></body>
  <body name="b"><geom name="b" size="0.1" contype="2" conaffinity="4"/></body>
  <body name="c"><geom name="c" size="0.1" contype="8" conaffinity="8"/></body>
  <body name="seen"><geom name="seen" size="0.1" contype="0" conaffinity="0"/></body></worldbody>)";

TEST_F(ContactRules, BitsDecide) {
  const auto world = load(kBodies);
  const std::vector<std::map<std::string, bool>> expected = {{{"a", true}, {"b", true}, {"c", false}},
                                                             {{"a", false}, {"b", true}, {"c", false}}};
  EXPECT_EQ(touches(*world), expected);
  EXPECT_EQ(world->geometry().tool.pieces[0].contact_type, 1);
  EXPECT_EQ(world->geometry().tool.pieces[1].contact_type, 4);
}

TEST_F(ContactRules, ExcludesOfTheToolHoldForThatPairOfBodiesAlone) {
  for (const char* exclude : {R"(<exclude body1="tool" body2="b"/>)", R"(<exclude body1="b" body2="tool"/>)"}) {
    const auto world = load(kBodies + "<contact>" + exclude + "</contact>");
    const std::vector<std::map<std::string, bool>> expected = {{{"a", true}, {"b", false}, {"c", false}},
                                                               {{"a", false}, {"b", true}, {"c", false}}};
    EXPECT_EQ(touches(*world), expected) << exclude;
  }
}

TEST_F(ContactRules, PairsOfTheToolHoldWhateverTheBitsSay) {
  const auto world = load(kBodies + R"(<contact><exclude body1="tip" body2="b"/><pair geom1="seen" geom2="tip"/>
                                       <pair geom1="handle" geom2="c"/></contact>)");
  const std::vector<std::map<std::string, bool>> expected = {
      {{"a", true}, {"b", true}, {"c", true}, {"seen", false}},
      {{"a", false}, {"b", false}, {"c", false}, {"seen", true}}};
  EXPECT_EQ(touches(*world), expected);
  ASSERT_EQ(world->warnings().size(), 1U);
  EXPECT_NE(world->warnings()[0].find("2 <pair> of the tool"), std::string::npos) << world->warnings()[0];
}

TEST_F(ContactRules, ExcludesAmongOtherBodiesLeaveTheBitsAlone) {
  const auto world = load(kBodies + R"(<contact><exclude body1="a" body2="b"/></contact>)");
  EXPECT_EQ(world->geometry().tool.pieces[1].contact_type, 4);
}

TEST_F(ContactRules, PairsAloneCountWhereTheSceneSaysSo) {
  const auto world =
      load("<option collision='predefined'/>" + kBodies + R"(<contact><pair geom1="handle" geom2="c"/></contact>)");
  ASSERT_EQ(world->geometry().tool.pieces.size(), 1U);
  const std::vector<std::map<std::string, bool>> expected = {{{"c", true}}};
  EXPECT_EQ(touches(*world), expected);
}

TEST_F(ContactRules, AToolThatMayTouchNothingIsSaid) {
  const auto world = load("<worldbody>" + kTool + R"(<geom size="0.1" contype="2" conaffinity="2"/></worldbody>)");
  ASSERT_EQ(world->warnings().size(), 1U);
  EXPECT_NE(world->warnings()[0].find("the tool 'tool' may touch nothing"), std::string::npos);
}

TEST_F(ContactRules, MoreToolGeomsThanBitsAreRefusedWhereRulesNameThem) {
  std::string geoms;
  for (int i = 0; i < 32; ++i) geoms += R"(<geom size="0.1"/>)";
  const std::string scene = R"(<worldbody><body name="tool" mocap="true">)" + geoms +
                            R"(</body><body name="a"><geom size="0.1"/></body></worldbody>)";
  EXPECT_EQ(refusal(scene), "");
  const std::string refused = refusal(scene + R"(<contact><exclude body1="tool" body2="a"/></contact>)");
  EXPECT_NE(refused.find("the tool has 32 contact geoms, and 31 at most"), std::string::npos) << refused;
}

// A ball lies on the floor inside the tool: neither the tool's bits nor a pair let MuJoCo push it away. A pair of other
// geoms goes on to work.
TEST_F(ContactRules, MujocoDoesNotCollideTheTool) {
  for (const char* mocap : {R"(mocap="true")", ""}) {
    const auto world = load("<worldbody>" + kFloor + R"(
      <geom name="low" type="box" size="1 1 0.1" pos="5 0 0.5" contype="0" conaffinity="0"/>
      <body name="free" pos="0.02 0 0.1"><freejoint/><geom name="ball" size="0.1"/></body>
      <body name="paired" pos="5 0 0.7"><freejoint/><geom name="paired" size="0.1" contype="4" conaffinity="8"/></body>
      <body name="tool" )" + std::string(mocap) +
                            R"( pos="0 0 0.1"><geom name="t" size="0.1"/></body></worldbody>
      <contact><pair geom1="ball" geom2="t"/><pair geom1="paired" geom2="low"/></contact>)");
    ToolState tool;
    tool.X_WT = world->geometry().tool.X_WT;
    for (int i = 0; i < 20; ++i) world->advance(0.05, tool, no_impulses(*world));
    const auto states = states_of(*world);
    EXPECT_NEAR(states[0].X_WB.p.x(), 0.02, 1e-6);
    EXPECT_NEAR(states[0].X_WB.p.z(), 0.1, 1e-3);
    EXPECT_NEAR(states[1].X_WB.p.z(), 0.7, 1e-3);
    EXPECT_TRUE(world->diagnostics().is_healthy());
  }
}

}  // namespace
}  // namespace tegotae
