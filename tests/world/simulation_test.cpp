// SPDX-License-Identifier: Apache-2.0
#include <tests/world/scene_files.hpp>

#include <mujoco/mujoco.h>

#include <cmath>

namespace tegotae {
namespace {

using test::kFloor;
using test::kTool;
using test::no_impulses;
using test::states_of;

class Simulated : public test::SceneFiles {
 protected:
  // `count` boxes side by side on the floor: 4 contacts each.
  static std::string boxes(int count) {
    std::string text = "<worldbody>" + kTool + kFloor;
    for (int i = 0; i < count; ++i) {
      const int row = i / 10, place = i % 10;
      text += "<body pos='" + std::to_string(0.3 * place) + " " + std::to_string(0.3 * row) +
              " 0.0999'><freejoint/><geom type='box' size='0.1 0.1 0.1'/></body>";
    }
    return text + "</worldbody>";
  }
  static double lowest(const MujocoWorld& world) {
    double z = 1.0;
    for (const BodyState& state : states_of(world)) z = std::min(z, state.X_WB.p.z());
    return z;
  }
};

TEST_F(Simulated, RoomIsMadeForEveryContact) {
  const auto world = load(boxes(100));  // 400 contacts; MuJoCo's own list holds 100
  for (int i = 0; i < 20; ++i) world->advance(0.01, {}, no_impulses(*world));
  const WorldDiagnostics& diagnostics = world->diagnostics();
  EXPECT_TRUE(diagnostics.is_healthy()) << diagnostics.last_message;
  EXPECT_GE(diagnostics.enlargements, 1U);
  EXPECT_GE(diagnostics.contact_capacity, 400);
  EXPECT_GT(lowest(*world), 0.0985);
}

// The step that found no room is done again from its start: the run is the one that would have been with room from the
// first, bit for bit.
TEST_F(Simulated, MakingRoomLeavesNoTrace) {
  const auto grown = load(boxes(80));
  const auto roomy = load("<size nconmax='1000' njmax='4000'/>" + boxes(80));
  for (int i = 0; i < 10; ++i) {
    grown->advance(0.01, {}, no_impulses(*grown));
    roomy->advance(0.01, {}, no_impulses(*roomy));
  }
  EXPECT_GE(grown->diagnostics().enlargements, 1U);
  EXPECT_EQ(roomy->diagnostics().enlargements, 0U);
  const auto a = states_of(*grown), b = states_of(*roomy);
  for (size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].X_WB.p, b[i].X_WB.p);
    EXPECT_EQ(a[i].V_WB.angular, b[i].V_WB.angular);
  }
  EXPECT_EQ(grown->time(), roomy->time());
}

TEST_F(Simulated, ContactsThatFindNoRoomAreCounted) {
  MujocoWorldOptions options;
  options.max_contacts = 100;
  const auto world = load(boxes(40), options);
  world->advance(0.1, {}, no_impulses(*world));
  EXPECT_GE(world->diagnostics().dropped_contacts, 50U);
  EXPECT_EQ(world->diagnostics().contact_capacity, 100);
  EXPECT_FALSE(world->diagnostics().is_healthy());
  EXPECT_NE(world->diagnostics().last_message.find("nconmax"), std::string::npos) << world->diagnostics().last_message;
  EXPECT_LT(lowest(*world), 0.09);
}

// An impulse that no simulation survives: the body is stopped where it was, and that is counted; the others go on.
TEST_F(Simulated, DivergenceStopsTheBodiesAndIsCounted) {
  const auto world = load("<option gravity='0 0 0'/><worldbody>" + kTool +
                          "<body pos='1 2 3'><freejoint/><geom size='0.1'/></body></worldbody>");
  world->advance(0.01, {}, std::vector<BodyImpulse>{{{1e14, 0.0, 0.0}, Vector3::Zero()}});
  EXPECT_EQ(world->diagnostics().diverged, 5U);
  EXPECT_FALSE(world->diagnostics().last_message.empty());
  const BodyState state = states_of(*world)[0];
  EXPECT_EQ(state.X_WB.p, Vector3(1.0, 2.0, 3.0));
  EXPECT_EQ(state.V_WB.linear, Vector3::Zero());
  EXPECT_NEAR(world->time(), 0.01, 1e-15);
  world->advance(0.01, {}, std::vector<BodyImpulse>{{{1.0, 0.0, 0.0}, Vector3::Zero()}});
  EXPECT_EQ(world->diagnostics().diverged, 5U);
  EXPECT_GT(states_of(*world)[0].V_WB.linear.x(), 0.1);
}

// MuJoCo's own errors cannot be had at will: a callback raises them.
int errors_to_raise = 0;
const char* error_to_raise = "";
void raise_errors(const mjModel* /*model*/, mjData* /*data*/) {
  if (errors_to_raise-- > 0) mju_error(error_to_raise);
}

class SimulatedErrors : public Simulated {
 protected:
  void raise(const char* text, int count) {
    error_to_raise = text;
    errors_to_raise = count;
    mjcb_passive = raise_errors;
  }
  ~SimulatedErrors() override { mjcb_passive = nullptr; }
};

TEST_F(SimulatedErrors, StopTheBodiesAndAreCounted) {
  const auto world =
      load("<worldbody>" + kTool + "<body pos='1 2 3'><freejoint/><geom size='0.1'/></body></worldbody>");
  raise("broken", 2);
  world->advance(0.006, {}, no_impulses(*world));
  EXPECT_EQ(world->diagnostics().engine_errors, 2U);
  EXPECT_EQ(world->diagnostics().enlargements, 0U);
  EXPECT_EQ(world->diagnostics().last_message, "broken");
  EXPECT_NEAR(states_of(*world)[0].V_WB.linear.z(), -9.81 * 0.002, 1e-12);
  EXPECT_NEAR(world->time(), 0.006, 1e-15);
}

TEST_F(SimulatedErrors, WantOfStackIsCured) {
  const auto world =
      load("<worldbody>" + kTool + "<body pos='1 2 3'><freejoint/><geom size='0.1'/></body></worldbody>");
  raise("Stack overflow", 2);
  world->advance(0.006, {}, no_impulses(*world));
  EXPECT_EQ(world->diagnostics().enlargements, 2U);
  EXPECT_TRUE(world->diagnostics().is_healthy());
  EXPECT_NEAR(states_of(*world)[0].V_WB.linear.z(), -9.81 * 0.006, 1e-12);
}

// Both forms of the tool follow the hand.
TEST_F(Simulated, TheToolFollowsTheHandInMujoco) {
  for (const char* mocap : {"mocap='true'", ""}) {
    const std::string tool_body = "<body name='tool' " + std::string(mocap) + " pos='0 0 1'><geom size='0.05'/></body>";
    const bool nested = *mocap == '\0';
    const auto world =
        load("<worldbody>" + kFloor +
             (nested ? "<body pos='1 1 0' euler='0 0 90'>" + tool_body + "</body>" : tool_body) + "</worldbody>");
    EXPECT_LT((world->geometry().tool.X_WT.p - (nested ? Vector3(1, 1, 1) : Vector3(0, 0, 1))).norm(), 1e-14);
    ToolState tool;
    tool.X_WT = {{0.3, -0.2, 0.7}, Quaternion(0.6, 0.0, 0.8, 0.0)};
    for (int i = 0; i < 3; ++i) {
      world->advance(0.01, tool, {});
      const Pose seen = world->tool_pose();
      EXPECT_LT((seen.p - tool.X_WT.p).norm(), 1e-14);
      EXPECT_LT(seen.q.angularDistance(tool.X_WT.q), 1e-7);
      tool.X_WT.p.x() += 0.1;
    }
  }
}

TEST_F(Simulated, AToolPoseThatIsNotFiniteIsNotTaken) {
  const auto world = load("<worldbody>" + kTool + kFloor + "</worldbody>");
  ToolState tool;
  tool.X_WT.p.x() = std::nan("");
  world->advance(0.01, tool, {});
  EXPECT_EQ(world->tool_pose().p, Vector3(0.0, 0.0, 5.0));
  EXPECT_TRUE(world->diagnostics().is_healthy());
}

TEST_F(Simulated, MeasuringTheStepTimeLeavesTheStateAlone) {
  const auto world = load(boxes(10));
  world->advance(0.01, {}, no_impulses(*world));
  const auto before = states_of(*world);
  const double time = world->time();
  EXPECT_GT(world->measure_step_time(), 0.0);
  const auto after = states_of(*world);
  for (size_t i = 0; i < before.size(); ++i) EXPECT_EQ(before[i].X_WB.p, after[i].X_WB.p);
  EXPECT_EQ(world->time(), time);
  EXPECT_EQ(world->max_substep(), 0.002);
}

// Warnings, refusals and divergence: all that makes MuJoCo write its log, were it not kept from it.
TEST_F(Simulated, LeavesNoFileBehind) {
  const auto here = std::filesystem::current_path();
  std::filesystem::create_directories(folder() / "cwd");
  std::filesystem::current_path(folder() / "cwd");
  refusal("<worldbody><geom size='nan'/></worldbody>");
  refusal("<worldbody>");
  MujocoWorldOptions options;
  options.max_contacts = 10;
  const auto world = load(boxes(10), options);
  std::vector<BodyImpulse> impulses(10);
  impulses[0].linear.x() = 1e14;
  world->advance(0.01, {}, impulses);
  EXPECT_FALSE(world->diagnostics().is_healthy());
  EXPECT_TRUE(std::filesystem::is_empty(folder() / "cwd"));
  std::filesystem::current_path(here);
}

}  // namespace
}  // namespace tegotae
