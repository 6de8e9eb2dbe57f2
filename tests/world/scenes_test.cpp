// SPDX-License-Identifier: Apache-2.0
#include <tests/world/scene_files.hpp>

#include <cmath>

namespace tegotae {
namespace {

std::unique_ptr<MujocoWorld> shipped(const std::string& name) {
  return load_mujoco_world(std::filesystem::path(TEGOTAE_SCENES) / name, "tool");
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
  const HapticSettingsInScene& settings = world->haptic_settings();
  EXPECT_EQ(settings.stiffness, 9000.0);
  EXPECT_EQ(settings.damping, 0.0);
  EXPECT_EQ(settings.physics_rate, 20.0);
  EXPECT_EQ(settings.haptic_rate, 1000.0);
  EXPECT_FALSE(settings.margin.has_value());
  EXPECT_FALSE(settings.metric_length.has_value());
}

}  // namespace
}  // namespace tegotae
