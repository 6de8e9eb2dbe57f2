// SPDX-License-Identifier: Apache-2.0
#include <tegotae/world/scene_summary.hpp>

#include <tests/world/scene_files.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>

namespace tegotae {
namespace {

using test::no_impulses;
using test::states_of;

const std::filesystem::path kScenes = TEGOTAE_SCENES;

std::unique_ptr<MujocoWorld> shipped(const std::string& name) { return load_mujoco_world(kScenes / name, "tool"); }

// The vertices as the file has them, m.
std::vector<Vector3> vertices_in(const std::filesystem::path& obj) {
  std::vector<Vector3> vertices;
  std::ifstream file(obj);
  std::string line, mark;
  while (std::getline(file, line)) {
    std::istringstream words(line);
    Vector3 v;
    if (words >> mark && mark == "v" && words >> v.x() >> v.y() >> v.z()) vertices.push_back(v);
  }
  return vertices;
}

TEST(Scenes, PaperCube) {
  const auto world = shipped("paper-cube.xml");
  const SceneGeometry& scene = world->geometry();
  ASSERT_EQ(scene.tool.pieces.size(), 1U);
  EXPECT_EQ(scene.tool.pieces[0].kind, ShapeKind::kBox);
  EXPECT_EQ(scene.tool.pieces[0].size, Vector3::Constant(0.1));
  EXPECT_EQ(scene.tool.X_WT.p, Vector3(0.0, 0.3, 0.0));
  EXPECT_NEAR(scene.tool.mass.mass, 8.0, 1e-12);
  EXPECT_LT(scene.tool.mass.centre_of_mass.norm(), 1e-15);
  EXPECT_NEAR(scene.tool.mass.gyration_length(), 0.2 / std::sqrt(6.0), 1e-12);
  ASSERT_EQ(scene.bodies.size(), 1U);
  EXPECT_EQ(scene.bodies[0].name, "floor");
  EXPECT_EQ(scene.bodies[0].moving_index, -1);
  EXPECT_EQ(scene.moving_count, 0);
  const Shape& floor = scene.bodies[0].pieces[0];
  EXPECT_EQ((scene.bodies[0].X_WB * floor.X_BS * Vector3(0.0, floor.size.y(), 0.0)).y(), 0.0);
  EXPECT_TRUE(may_touch(scene.tool.pieces[0], floor));
  EXPECT_TRUE(world->warnings().empty());
}

TEST(Scenes, PaperCubeHoldsThePapersSettings) {
  const auto world = shipped("paper-cube.xml");
  std::map<std::string, double> settings;
  for (const auto& [name, value] : world->haptic_settings()) settings[name] = value;
  const std::map<std::string, double> expected = {
      {"stiffness", 9000.0}, {"damping", 0.0}, {"physics_rate", 20.0}, {"haptic_rate", 1000.0}};
  EXPECT_EQ(settings, expected);
}

class MeshTools : public ::testing::TestWithParam<const char*> {};

// MuJoCo holds meshes in single precision, about their centre of mass and along their principal axes: on the tool they
// must stand where the file says, every vertex and no other.
TEST_P(MeshTools, HaveTheVerticesOfTheirFile) {
  const std::string name = GetParam();
  const auto world = shipped(name + ".xml");
  EXPECT_TRUE(world->warnings().empty()) << world->warnings()[0];
  const std::vector<Vector3> expected = vertices_in(kScenes / "meshes" / (name + ".obj"));
  ASSERT_EQ(expected.size(), name == "tool-18" ? 18U : 230U);
  ASSERT_EQ(world->geometry().tool.pieces.size(), 1U);
  const Shape& hull = world->geometry().tool.pieces[0];
  ASSERT_EQ(hull.polytope->vertices.size(), expected.size());
  for (const Vector3& v : expected) {
    double nearest = 1.0;
    for (const Vector3& p_S : hull.polytope->vertices) nearest = std::min(nearest, (hull.X_BS * p_S - v).norm());
    EXPECT_LT(nearest, 2e-8) << name;
  }
  const MassProperties uniform = mass_properties(hull, 1000.0);
  const MassProperties& mass = world->geometry().tool.mass;
  EXPECT_NEAR(mass.mass, uniform.mass, 1e-5 * uniform.mass);
  EXPECT_LT((mass.centre_of_mass - uniform.centre_of_mass).norm(), 1e-6);
  EXPECT_NEAR(mass.gyration_length(), uniform.gyration_length(), 1e-5 * uniform.gyration_length());
}
INSTANTIATE_TEST_SUITE_P(Shipped, MeshTools, ::testing::Values("tool-18", "tool-230-round", "tool-230-flat"));

TEST(Scenes, TheFlatToolEndsInTwoFacesOf115Vertices) {
  const auto world = shipped("tool-230-flat.xml");
  const Polytope& hull = *world->geometry().tool.pieces[0].polytope;
  EXPECT_EQ(hull.faces.size(), 2U + 115U);
  EXPECT_EQ(std::count_if(hull.faces.begin(), hull.faces.end(), [](const auto& f) { return f.count == 115; }), 2);
  EXPECT_EQ(std::count_if(hull.faces.begin(), hull.faces.end(), [](const auto& f) { return f.count == 4; }), 115);
}

TEST(Scenes, TheRoundToolHasNoTwoTrianglesInOnePlane) {
  const auto world = shipped("tool-230-round.xml");
  EXPECT_EQ(world->geometry().tool.pieces[0].polytope->faces.size(), 2U * 230U - 4U);
}

TEST(Scenes, TheSmallToolIsDenserAtItsLowerEnd) {
  const auto world = shipped("tool-18.xml");
  const Shape& hull = world->geometry().tool.pieces[0];
  const auto below = [&](const Vector3& p_S) { return (hull.X_BS * p_S).z() < -0.05; };
  EXPECT_EQ(std::count_if(hull.polytope->vertices.begin(), hull.polytope->vertices.end(), below), 14);
}

TEST(Scenes, TheBoxesOnTheTableComeToRestWhereTheyStand) {
  const auto world = shipped("table.xml");
  EXPECT_TRUE(world->warnings().empty());
  EXPECT_EQ(world->geometry().moving_count, 6);
  EXPECT_EQ(world->geometry().bodies.size(), 8U);
  ToolState tool;
  tool.X_WT = world->geometry().tool.X_WT;
  for (int i = 0; i < 200; ++i) world->advance(0.01, tool, no_impulses(*world));
  EXPECT_TRUE(world->diagnostics().is_healthy()) << world->diagnostics().last_message;
  for (const Body& body : world->geometry().bodies) {
    if (body.moving_index < 0) continue;
    const BodyState state = states_of(*world)[static_cast<size_t>(body.moving_index)];
    EXPECT_LT((state.X_WB.p - body.X_WB.p).norm(), 1e-3) << body.name;
    EXPECT_LT(state.V_WB.linear.norm(), 1e-3) << body.name;
  }
}

TEST(Scenes, AllRepeatBitForBit) {
  for (const char* name : {"paper-cube.xml", "tool-18.xml", "tool-230-round.xml", "tool-230-flat.xml", "table.xml"}) {
    const auto first = shipped(name), second = shipped(name);
    for (int i = 0; i < 50; ++i) {
      for (const auto& world : {first.get(), second.get()}) {
        std::vector<BodyImpulse> impulses(static_cast<size_t>(world->geometry().moving_count));
        for (auto& impulse : impulses) impulse.linear.x() = 0.01 * std::sin(i);
        world->advance(0.0123, {}, impulses);
      }
    }
    const auto a = states_of(*first), b = states_of(*second);
    for (size_t i = 0; i < a.size(); ++i) {
      EXPECT_EQ(a[i].X_WB.p, b[i].X_WB.p);
      EXPECT_EQ(a[i].X_WB.q.coeffs(), b[i].X_WB.q.coeffs());
      EXPECT_EQ(a[i].V_WB.linear, b[i].V_WB.linear);
      EXPECT_EQ(a[i].V_WB.angular, b[i].V_WB.angular);
    }
  }
}

TEST(SceneSummary, NamesToolAndWorld) {
  EXPECT_EQ(
      scene_summary(shipped("paper-cube.xml")->geometry()),
      "tool 'tool': 1 box (8 vertices); 8 kg, gyration length 0.08165 m\nworld: 1 bodies, 0 of them moving; 1 box\n");
  const std::string table = scene_summary(shipped("table.xml")->geometry());
  EXPECT_NE(table.find("1 capsule; "), std::string::npos) << table;
  EXPECT_NE(table.find("8 bodies, 6 of them moving; 11 box, 1 plane"), std::string::npos) << table;
}

}  // namespace
}  // namespace tegotae
