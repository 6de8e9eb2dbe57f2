// SPDX-License-Identifier: Apache-2.0
#include <tegotae/math/rotation.hpp>
#include <tegotae/runtime/haptic_tick.hpp>
#include <tegotae/runtime/physics_loop.hpp>

#include <tests/allocation_counter.hpp>
#include <tests/free_body_world.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

namespace tegotae {
namespace {

constexpr double kTickPeriod = 1e-3;
constexpr HapticTick::Circumstances kLost{true, false, false, 0.0}, kEnding{false, true, false, 0.0};

// A tick over the paper's scene with its first model.
struct TickRig {
  explicit TickRig(SceneGeometry scene = test::cube_over_floor(), const WorkspaceSettings& workspace = {},
                   const char* name = "paper", const SafetyLimits& limits = full_wrench_at_once())
      : world(std::move(scene)), physics(world, {0.05, 0.01}, ModelNeeds{true, true}) {
    MethodSettings settings;
    settings.stiffness = 9000.0;
    tick = std::make_unique<HapticTick>(make_method(name, settings, world.geometry()), world.geometry().tool, limits,
                                        kTickPeriod, workspace);
  }

  static SafetyLimits full_wrench_at_once() {
    SafetyLimits limits = without_hand({});
    limits.ramp_time = kTickPeriod;
    limits.force_rate = limits.torque_rate = 1e9;
    return limits;
  }

  void make_model(double time, const Pose& X_WT) { physics.build(time, {X_WT, {}}, *model); }

  InterfaceCommand run(double time, const Pose& X_WT, bool fresh, const HapticTick::Circumstances& circumstances = {}) {
    InterfaceState state;
    state.time = time;
    state.X_WT = X_WT;
    return (*tick)(state, fresh ? model.get() : nullptr, circumstances, record);
  }

  test::FreeBodyWorld world;
  PhysicsLoop physics;
  std::unique_ptr<HapticTick> tick;
  std::unique_ptr<IntermediateRepresentation> model = std::make_unique<IntermediateRepresentation>();
  TickRecord record;
};

Pose pressed(double depth) { return {{0.0, 0.1 - depth, 0.0}, Quaternion::Identity()}; }

TEST(HapticTick, PressingAFaceIsFeltAndRecorded) {
  TickRig rig;
  rig.make_model(0.0, pressed(-1e-3));
  rig.run(0.0, pressed(-1e-3), true);
  EXPECT_EQ(rig.record.wrench.force.y, 0.0);
  const InterfaceCommand command = rig.run(kTickPeriod, pressed(1e-3), false);
  EXPECT_NEAR(command.wrench.force.y(), 9.0, 1e-3);
  EXPECT_NEAR(rig.record.wrench.force.y, 9.0, 1e-3);
  EXPECT_NEAR(rig.record.displayed.force.y, 9.0, 1e-3);
  EXPECT_NEAR(rig.record.deepest, 1e-3, 1e-12);
  EXPECT_EQ(rig.record.planes, 1);
  EXPECT_EQ(rig.record.active, 4);
  EXPECT_EQ(rig.record.model_sequence, 1u);
  EXPECT_NEAR(rig.record.model_age, kTickPeriod, 1e-15);
}

TEST(HapticTick, WithoutAModelThereIsNoForce) {
  TickRig rig;
  const InterfaceCommand command = rig.run(0.0, pressed(5e-3), false);
  EXPECT_EQ(command.wrench.force.norm(), 0.0);
  EXPECT_EQ(rig.record.status, static_cast<std::uint8_t>(RenderStatus::kNoModel));
}

TEST(HapticTick, ANonFinitePoseDisplaysNothingAndIsForgotten) {
  TickRig rig;
  rig.make_model(0.0, pressed(1e-3));
  rig.run(0.0, pressed(1e-3), true);
  const InterfaceCommand command = rig.run(kTickPeriod, {{0.0, std::nan(""), 0.0}, Quaternion::Identity()}, false);
  EXPECT_EQ(command.wrench.force.norm(), 0.0);
  EXPECT_EQ(rig.record.status, static_cast<std::uint8_t>(RenderStatus::kInvalidInput));
  const InterfaceCommand zero_quaternion = rig.run(2 * kTickPeriod, {{0.0, 0.099, 0.0}, Quaternion(0, 0, 0, 0)}, false);
  EXPECT_EQ(zero_quaternion.wrench.force.norm(), 0.0);
  ImpulseSums message;
  rig.tick->fill(message, 0);
  EXPECT_EQ(message.X_WT.p.y, 0.099) << "physics goes on with the last pose that was one";
  EXPECT_NEAR(rig.run(3 * kTickPeriod, pressed(1e-3), false).wrench.force.y(), 9.0, 1e-3);
}

TEST(HapticTick, TorqueIsGivenAboutTheGripAndRecordedAboutTheCentreOfMass) {
  SceneGeometry scene = test::cube_over_floor();
  // The same cube held 0.1 m beside its centre.
  scene.tool.pieces[0].X_BS.p = Vector3(0.1, 0.0, 0.0);
  scene.tool.mass = mass_properties(scene.tool.pieces[0], 1000.0);
  TickRig rig(std::move(scene));
  rig.make_model(0.0, pressed(5e-4));
  const InterfaceCommand command = rig.run(0.0, pressed(5e-4), true);
  EXPECT_NEAR(command.wrench.force.y(), 4.5, 1e-3);
  EXPECT_NEAR(command.wrench.torque.z(), 0.1 * 4.5, 1e-4);
  EXPECT_LT(Vector3(rig.record.wrench.torque).norm(), 1e-9);
  EXPECT_LT(Vector3(rig.record.displayed.torque).norm(), 1e-9);
}

TEST(HapticTick, BodiesReceiveWhatWasDisplayed) {
  SceneGeometry scene = test::cube_over_floor();
  scene.bodies[0].moving_index = 0;
  TickRig rig(std::move(scene));
  rig.make_model(0.0, pressed(1e-3));
  double displayed = 0.0;
  for (int i = 0; i < 10; ++i) {
    rig.run(i * kTickPeriod, pressed(1e-3), i == 0);
    displayed += kTickPeriod * rig.record.displayed.force.y;
  }
  ImpulseSums message;
  rig.tick->fill(message, 1);
  EXPECT_GT(displayed, 0.08);
  EXPECT_NEAR(message.bodies[0].linear.y, -displayed, 1e-14);
  EXPECT_EQ(message.sequence, 10u);
}

TEST(HapticTick, ALostInterfaceOrTheEndGivesZeroAtOnceAndBodiesReceiveNothing) {
  SceneGeometry scene = test::cube_over_floor();
  scene.bodies[0].moving_index = 0;
  TickRig rig(std::move(scene));
  rig.make_model(0.0, pressed(1e-3));
  EXPECT_EQ(rig.run(0.0, pressed(1e-3), true, kLost).wrench.force.norm(), 0.0);
  EXPECT_EQ(rig.run(kTickPeriod, pressed(1e-3), false, kEnding).wrench.force.norm(), 0.0);
  EXPECT_GT(rig.record.wrench.force.y, 8.0);
  ImpulseSums message;
  rig.tick->fill(message, 1);
  EXPECT_EQ(message.bodies[0].linear.y, 0.0);
}

// The pose that an interface reports while it is lost means nothing.
TEST(HapticTick, WhileTheInterfaceIsLostTheToolStaysWhereItWas) {
  TickRig rig;
  rig.make_model(0.0, pressed(1e-3));
  rig.run(0.0, pressed(1e-3), true);
  rig.run(kTickPeriod, {}, false, kLost);
  EXPECT_EQ(rig.record.X_WT.p.y, 0.099);
  EXPECT_EQ(rig.record.displayed.force.y, 0.0);
}

TEST(HapticTick, MissedTicksAreFeltByTheBodiesForAsLongAsByTheHand) {
  SceneGeometry scene = test::cube_over_floor();
  scene.bodies[0].moving_index = 0;
  TickRig rig(std::move(scene));
  rig.make_model(0.0, pressed(1e-3));
  double impulse = 0.0;
  for (int i = 0; i < 5; ++i) {
    rig.run(0.01 * i, pressed(1e-3), i == 0);
    impulse += (i == 0 ? kTickPeriod : 0.01) * rig.record.displayed.force.y;
  }
  ImpulseSums message;
  rig.tick->fill(message, 1);
  EXPECT_NEAR(message.bodies[0].linear.y, -impulse, 1e-12);
  EXPECT_GT(impulse, 0.3);
}

// A program that was stopped, say: what it displayed fades, and is not felt again while the hand presses.
TEST(HapticTick, AStandstillTakesTheForceAwayAtAnyRate) {
  for (const double period : {1e-3, 0.01, 0.1}) {
    TickRig rig;
    SafetyLimits limits;
    limits.period = limits.ramp_time = period;
    limits.force_rate = limits.torque_rate = 1e9;
    limits.max_model_age = 1e9;
    limits.energy_bound.on = false;
    MethodSettings settings;
    settings.stiffness = 9000.0;
    rig.tick = std::make_unique<HapticTick>(make_method("paper", settings, rig.world.geometry()),
                                            rig.world.geometry().tool, limits, period);
    rig.make_model(0.0, pressed(-1e-3));
    rig.run(0.0, pressed(-1e-3), true);
    EXPECT_NEAR(rig.run(period, pressed(1e-3), false).wrench.force.y(), 9.0, 1e-3) << period;
    double time = period + 10.0, force = rig.run(time, pressed(1e-3), false).wrench.force.y();
    for (const double end = time + limits.fade_time + period; time < end;) {
      force = rig.run(time += period, pressed(1e-3), false).wrench.force.y();
    }
    EXPECT_EQ(force, 0.0) << period;
  }
}

// A ball that turns about its centre on the floor, models made only now and then.
TEST(HapticTick, ATurningBallIsFeltAsABall) {
  SceneGeometry scene = test::cube_over_floor();
  scene.tool.pieces = {make_sphere(0.05)};
  scene.tool.mass = mass_properties(scene.tool.pieces[0], 1000.0);
  TickRig rig(std::move(scene));
  for (int i = 0; i < 200; ++i) {
    const Pose pose{{0.0, 0.0495, 0.0}, rotation_from_vector({2e-3 * i, 0.0, 5e-3 * i})};
    if (i % 50 == 0) rig.make_model(kTickPeriod * i, pose);
    rig.run(kTickPeriod * i, pose, i % 50 == 0);
    ASSERT_NEAR(rig.record.wrench.force.y, 4.5, 1e-3);
    ASSERT_LT(Vector3(rig.record.wrench.torque).norm(), 1e-9);
  }
}

// Twice as far in the world as at the grip, half the force at the grip.
TEST(HapticTick, ScalesAreBetweenTheToolAndTheGripAndBodiesTakeWhatWasDisplayed) {
  SceneGeometry scene = test::cube_over_floor();
  scene.bodies[0].moving_index = 0;
  WorkspaceSettings workspace;
  workspace.translation_scale = 2.0;
  workspace.force_scale = 0.5;
  TickRig rig(std::move(scene), workspace);
  // The workspaces coincide where the scene has the tool: y = 0.3.
  const Pose above{{0.0, 0.3 - 0.5 * 0.199, 0.0}, Quaternion::Identity()};
  const Pose pressed_grip{{0.0, 0.3 - 0.5 * 0.201, 0.0}, Quaternion::Identity()};
  rig.make_model(0.0, pressed(-1e-3));
  rig.run(0.0, above, true);
  EXPECT_NEAR(rig.record.X_WT.p.y, 0.101, 1e-12);
  const InterfaceCommand command = rig.run(kTickPeriod, pressed_grip, false);
  EXPECT_NEAR(rig.record.X_WT.p.y, 0.099, 1e-12);
  EXPECT_NEAR(rig.record.wrench.force.y, 9.0, 1e-3);
  EXPECT_NEAR(command.wrench.force.y(), 4.5, 1e-3);
  EXPECT_NEAR(rig.record.displayed.force.y, 9.0, 1e-3);
  ImpulseSums message;
  rig.tick->fill(message, 1);
  EXPECT_NEAR(message.bodies[0].linear.y, -kTickPeriod * 9.0, 1e-6);
}

TEST(HapticTick, TheSafetyStageActsInTheGripsUnits) {
  WorkspaceSettings workspace;
  workspace.force_scale = 10.0;
  TickRig rig(test::cube_over_floor(), workspace);
  rig.make_model(0.0, pressed(1e-3));
  const InterfaceCommand command = rig.run(0.0, pressed(1e-3), true);
  EXPECT_NEAR(command.wrench.force.norm(), 15.0, 1e-9) << "not 90";
  EXPECT_NEAR(rig.record.displayed.force.y, 1.5, 1e-9);
}

TEST(HapticTick, TheClutchButtonKeepsTheToolAndDisplaysNothing) {
  WorkspaceSettings workspace;
  workspace.clutch_button = 2;
  TickRig rig(test::cube_over_floor(), workspace);
  rig.make_model(0.0, pressed(1e-3));
  rig.run(0.0, pressed(1e-3), true);
  InterfaceState state;
  state.buttons = 1U << 2U;
  for (int i = 1; i <= 30; ++i) {
    state.time = i * kTickPeriod;
    state.X_WT = pressed(1e-3 + 1e-3 * i);
    (*rig.tick)(state, nullptr, {}, rig.record);
    ASSERT_EQ(rig.record.X_WT.p.y, 0.099);
  }
  EXPECT_EQ(rig.record.displayed.force.y, 0.0);
  rig.run(31 * kTickPeriod, pressed(31e-3 - 5e-4), false);
  EXPECT_NEAR(rig.record.X_WT.p.y, 0.0995, 1e-12) << "it goes on from where it was";
}

TEST(HapticTick, TheFirstPoseMayHoldTheToolWhereTheSceneHasIt) {
  WorkspaceSettings workspace;
  workspace.from_first_pose = true;
  TickRig rig(test::cube_over_floor(), workspace);
  InterfaceState state;
  state.X_WT = {{5.0, 6.0, 7.0}, rotation_from_vector({0.1, 0.2, 0.3})};
  const ToolState tool = rig.tick->begin(state, false);
  EXPECT_EQ(tool.X_WT.p, Vector3(0.0, 0.3, 0.0));
  state.X_WT.p.y() += 0.01;
  state.time = kTickPeriod;
  (*rig.tick)(state, nullptr, {}, rig.record);
  EXPECT_NEAR(rig.record.X_WT.p.y, 0.31, 1e-12);
  EXPECT_NEAR(rig.record.X_WT.w, 1.0, 1e-12);
}

// A proxy over the floor, the pose below it: nothing may be rendered there before the model knows of it.
TEST(HapticTick, AfterALeapTheMethodWaitsForAModelThatWasMadeThere) {
  SafetyLimits limits;
  TickRig rig(test::cube_over_floor(), {}, "proxy", limits);
  rig.make_model(0.0, pressed(-1e-3));
  for (int i = 0; i < 10; ++i) rig.run(i * kTickPeriod, pressed(-1e-3), i == 0);
  rig.run(10 * kTickPeriod, pressed(0.15), false);
  for (int i = 11; i < 80; ++i) {
    rig.run(i * kTickPeriod, pressed(0.15), false);
    ASSERT_EQ(rig.record.wrench.force.y, 0.0);
    ASSERT_NEAR(rig.record.X_WP.p.y, 0.101, 1e-9) << "where it was";
    if (i > 65) {
      ASSERT_NEAR(rig.record.X_WT.p.y, -0.05, 1e-12) << "but physics learns where the hand is";
    }
  }
  rig.make_model(80 * kTickPeriod, pressed(-1e-3));
  for (int i = 80; i < 110; ++i) rig.run(i * kTickPeriod, pressed(0.15), i == 80);
  EXPECT_NEAR(rig.record.X_WP.p.y, 0.1, 1e-4) << "on the floor";
  EXPECT_GT(rig.record.wrench.force.y, 1000.0);
  EXPECT_EQ(rig.record.displayed.force.y, 0.0) << "until the hand has come back";
}

TEST(HapticTick, AllocatesNothingEvenWhenModelsArrive) {
  TickRig rig;
  rig.make_model(0.0, pressed(1e-3));
  const test::AllocationCounter counter;
  for (int i = 0; i < 200; ++i) rig.run(i * kTickPeriod, pressed(1e-3 * std::sin(0.1 * i)), i % 50 == 0);
  EXPECT_EQ(counter.count(), 0u);
}

}  // namespace
}  // namespace tegotae
