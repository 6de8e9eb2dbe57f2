// SPDX-License-Identifier: Apache-2.0
// The friction of pairs as loaded from a scene, against what MuJoCo says of the same contact.
#include <tegotae/render/friction_rule.hpp>

#include <tests/world/scene_files.hpp>

#include <fmt/format.h>
#include <mujoco/mujoco.h>

#include <memory>

namespace tegotae {
namespace {

struct Surface {
  double friction;
  int condim, priority;
};

class FrictionRuleScene : public test::SceneFiles {
 protected:
  // A ball sunk into a floor; `motion` says how the ball's body is held.
  static std::string scene(const Surface& ball, const Surface& floor, const std::string& attribute,
                           const std::string& joint) {
    return fmt::format(
        R"(<worldbody>
        <geom type="plane" size="1 1 1" friction="{}" condim="{}" priority="{}"/>
        <body name="tool" pos="0 0 0.09" {}>{}<geom size="0.1" friction="{}" condim="{}" priority="{}"/></body>
        </worldbody>)",
        floor.friction, floor.condim, floor.priority, attribute, joint, ball.friction, ball.condim, ball.priority);
  }

  mjContact contact_of_mujoco(const Surface& ball, const Surface& floor) const {
    const auto file = write("free.xml", "<mujoco>" + scene(ball, floor, "", "<freejoint/>") + "</mujoco>");
    char error[1000] = "";
    const std::unique_ptr<mjModel, void (*)(mjModel*)> model(mj_loadXML(file.c_str(), nullptr, error, sizeof error),
                                                             mj_deleteModel);
    EXPECT_NE(model, nullptr) << error;
    if (!model) return {};
    const std::unique_ptr<mjData, void (*)(mjData*)> data(mj_makeData(model.get()), mj_deleteData);
    mj_forward(model.get(), data.get());
    EXPECT_EQ(data->ncon, 1);
    return data->contact[0];
  }
};

TEST_F(FrictionRuleScene, IsThatOfMujocoForAllCombinations) {
  int frictionless = 0;
  for (const int condim : {1, 3, 4, 6}) {
    for (const int other : {1, 3}) {
      for (const auto& [priority, other_priority] : {std::pair(0, 0), {2, 2}, {1, 0}, {-1, 0}, {-3, 5}}) {
        for (const auto& [friction, other_friction] : {std::pair(0.3, 0.8), {1.5, 0.2}}) {
          const Surface ball{friction, condim, priority}, floor{other_friction, other, other_priority};
          const auto world = load(scene(ball, floor, R"(mocap="true")", ""));
          const SceneFriction ours =
              scene_friction(world->geometry().tool.pieces[0], world->geometry().bodies[0].pieces[0]);
          const mjContact theirs = contact_of_mujoco(ball, floor);
          EXPECT_DOUBLE_EQ(ours.coefficient, theirs.friction[0])
              << condim << other << " " << priority << other_priority;
          EXPECT_EQ(ours.frictionless, theirs.dim == 1) << condim << other << " " << priority << other_priority;
          frictionless += ours.frictionless ? 1 : 0;
        }
      }
    }
  }
  EXPECT_GT(frictionless, 0);
}

}  // namespace
}  // namespace tegotae
