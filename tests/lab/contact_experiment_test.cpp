// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/contact_experiment.hpp>
#include <tegotae/lab/scene_file.hpp>
#include <tegotae/world/mujoco_world.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

namespace tegotae {
namespace {

using testing::HasSubstr;

TEST(ContactExperiment, HasTheToolsOwnMetricAndItsFriction) {
  const Experiment experiment = contact_experiment("name", "summary", "wedge.xml", 0.3);
  EXPECT_EQ(experiment.settings.friction, 0.3);
  EXPECT_EQ(experiment.settings.metric_length, 0.0);
  ASSERT_EQ(experiment.variants.size(), 1U);
  const auto world = load_mujoco_world(find_scene(experiment.scene), experiment.tool);
  const SessionSettings settings = decide_settings(experiment.settings, world->geometry().tool);
  EXPECT_EQ(settings.metric_length, world->geometry().tool.mass.gyration_length());
  EXPECT_EQ(settings.friction, 0.3);
}

TEST(ContactExperiment, FigureDrawsTheWayAndTheReportedAxes) {
  Experiment experiment = contact_experiment("name", "summary", "wedge.xml", 0.0);
  experiment.force_axis = {"x", Vector3::UnitX()};
  const Figure figure = wrench_over_time(experiment, "Title", {"z", Vector3::UnitZ()});
  ASSERT_EQ(figure.panels.size(), 3U);
  EXPECT_EQ(figure.panels[0].label, "z [m]");
  EXPECT_EQ(figure.panels[1].label, "f_x [N]");
  EXPECT_THAT(figure.panels[2].label, HasSubstr("_y [N m]"));
  TickRecord record;
  record.X_WT.p = Vector3(1.0, 2.0, 3.0);
  record.wrench.force = Vector3(4.0, 5.0, 6.0);
  record.wrench.torque = Vector3(7.0, 8.0, 9.0);
  const double expected[] = {3.0, 4.0, 8.0};
  for (size_t i = 0; i < 3; ++i) EXPECT_EQ(figure.panels[i].curves.at(0).quantity(record, {}), expected[i]);
}

struct FitCase {
  const char* scene;
  double clearance;  // m, between the tool and the two walls left and right of it, together
};

class Fit : public testing::TestWithParam<FitCase> {};

// What the names of the scenes promise, measured on the shapes: across x, at the height z = -1 mm.
TEST_P(Fit, IsThatOfTheName) {
  const auto world = load_mujoco_world(find_scene(GetParam().scene), "tool");
  const SceneGeometry& scene = world->geometry();
  double left = -1.0, right = 1.0;
  for (const Body& body : scene.bodies) {
    for (const Shape& wall : body.pieces) {
      const Pose X_WS = body.X_WB * wall.X_BS;
      const Vector3 inside = X_WS.q.conjugate() * (Vector3(0.0, 0.0, -1e-3) - X_WS.p);
      if (std::abs(inside.y()) > wall.size.y() || std::abs(inside.z()) > wall.size.z()) continue;
      if (X_WS.p.x() < 0.0)
        left = std::max(left, X_WS.p.x() + wall.size.x());
      else
        right = std::min(right, X_WS.p.x() - wall.size.x());
    }
  }
  EXPECT_NEAR(right - left - 2.0 * scene.tool.pieces.at(0).size.x(), GetParam().clearance, 1e-12);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Fit,
                         testing::Values(FitCase{"slot-narrow.xml", -1e-4}, FitCase{"slot-play.xml", 2e-5},
                                         FitCase{"peg-in-hole.xml", 1e-4}));

}  // namespace
}  // namespace tegotae
