// SPDX-License-Identifier: Apache-2.0
#include <tegotae/math/rotation.hpp>
#include <tegotae/runtime/simulated_session.hpp>

#include <tests/free_body_world.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <vector>

namespace tegotae {
namespace {

// A hand that holds a pose given by a function of time.
class ScriptedInterface : public HapticInterface {
 public:
  explicit ScriptedInterface(std::function<Pose(double)> pose) : pose_(std::move(pose)) {}
  InterfaceCapability capability() const override { return {}; }
  InterfaceStatus read(double time, InterfaceState& state) noexcept override {
    state = {};
    state.time = time;
    state.X_WT = pose_(time);
    return InterfaceStatus::kOk;
  }
  InterfaceStatus write(const InterfaceCommand& command) noexcept override {
    commands.push_back(command);
    return InterfaceStatus::kOk;
  }

  std::vector<InterfaceCommand> commands;

 private:
  std::function<Pose(double)> pose_;
};

std::vector<TickRecord> run(test::FreeBodyWorld& world, HapticInterface& interface, double duration,
                            double physics_period = 0.05) {
  PhysicsLoop physics(world, {physics_period, 0.01}, ModelNeeds{});
  MethodSettings settings;
  settings.stiffness = 500.0;
  const Tool& tool = world.geometry().tool;
  HapticTick tick(make_method("paper", settings, world.geometry()), tool, without_hand({}), 1e-3);
  std::vector<TickRecord> records;
  run_simulated(physics, tick, interface, 1e-3, duration, [&](const TickRecord& record) {
    records.push_back(record);
    return true;
  });
  return records;
}

Pose pressed_into(double depth) { return {{0.0, 0.1 - depth, 0.0}, Quaternion::Identity()}; }

TEST(SimulatedSession, TicksCoverTheDurationFromZeroToItsEnd) {
  test::FreeBodyWorld world(test::cube_over_floor());
  ScriptedInterface interface([](double) { return pressed_into(0.0); });
  const auto records = run(world, interface, 0.25);
  ASSERT_EQ(records.size(), 251u);
  EXPECT_EQ(records.front().time, 0.0);
  EXPECT_NEAR(records.back().time, 0.25, 1e-15);
  EXPECT_EQ(interface.commands.size(), records.size());
  EXPECT_EQ(world.steps, 6) << "at 0, 50, ... 250 ms";
}

TEST(SimulatedSession, AModelBecomesVisibleOnePeriodAfterItsState) {
  test::FreeBodyWorld world(test::cube_over_floor());
  ScriptedInterface interface([](double) { return pressed_into(0.0); });
  for (const TickRecord& record : run(world, interface, 0.2)) {
    EXPECT_GE(record.model_age, 0.05 - 1e-12);
    EXPECT_LT(record.model_age, 0.1);
  }
}

TEST(SimulatedSession, TheFirstModelIsThereFromTheStart) {
  test::FreeBodyWorld world(test::cube_over_floor());
  ScriptedInterface interface([](double) { return pressed_into(1e-3); });
  const auto records = run(world, interface, 0.01);
  EXPECT_NEAR(records.front().wrench.force.y, 0.5, 1e-4);
}

TEST(SimulatedSession, EachDisplayedImpulseReachesItsBodyOnceAndOnlyOnce) {
  SceneGeometry scene = test::cube_over_floor();
  scene.bodies[0].moving_index = 0;
  test::FreeBodyWorld world(std::move(scene), 40.0);
  ScriptedInterface interface([](double time) { return pressed_into(1e-3 * std::sin(20.0 * time)); });
  const auto records = run(world, interface, 1.0);
  // What was displayed before the last physics step (at 1.0 s) took its message.
  double displayed = 0.0;
  for (const TickRecord& record : records) {
    if (record.time < 1.0 - 1e-9) displayed += 1e-3 * record.displayed.force.y;
  }
  EXPECT_GT(displayed, 0.05);
  EXPECT_NEAR(world.received(0).linear.y(), -displayed, 1e-12);
  EXPECT_LT(world.body(0).V_WB.linear.y(), 0.0) << "the floor is pushed away";
}

// The torque on a body is about where its centre of mass is when physics applies it.
TEST(SimulatedSession, AngularImpulseIsAboutTheBodysPresentCentre) {
  SceneGeometry scene = test::cube_over_floor();
  scene.bodies[0].moving_index = 0;
  test::FreeBodyWorld world(std::move(scene), 1e9);
  world.body(0).V_WB.linear.x() = 0.2;
  ScriptedInterface interface([](double) { return pressed_into(1e-3); });
  run(world, interface, 1.0);
  // Pushed down at x = 0 while the centre slides to x = 0.2 m: (0 - x) x f summed over the second, f = 0.5 N.
  double expected = 0.0;
  for (int i = 0; i < 1000; ++i) expected += 1e-3 * 0.5 * (1e-3 * i * 0.2);
  EXPECT_NEAR(world.received(0).angular.z(), expected, 0.1 * expected);
}

TEST(SimulatedSession, PhysicsFasterThanHapticsKeepsUp) {
  test::FreeBodyWorld world(test::cube_over_floor());
  ScriptedInterface interface([](double) { return pressed_into(0.0); });
  const auto records = run(world, interface, 0.1, 2e-4);
  EXPECT_EQ(world.steps, 501);
  EXPECT_LT(records.back().model_age, 1e-3);
}

TEST(SimulatedSession, AnInterfaceThatCannotBeCommandedIsLost) {
  class Deaf : public ScriptedInterface {
   public:
    using ScriptedInterface::ScriptedInterface;
    InterfaceStatus write(const InterfaceCommand& command) noexcept override {
      ScriptedInterface::write(command);
      return InterfaceStatus::kLost;
    }
  };
  test::FreeBodyWorld world(test::cube_over_floor());
  Deaf interface([](double) { return pressed_into(1e-3); });
  for (const TickRecord& record : run(world, interface, 0.5)) {
    if (record.time > 0.0) {
      ASSERT_EQ(Vector3(record.displayed.force).norm(), 0.0);
    }
  }
}

// A tool set down between two free blocks, both inside it: the hand feels nothing of it, and they are not shot away.
TEST(SimulatedSession, BlocksThatSqueezeTheToolStay) {
  SceneGeometry scene = test::cube_over_floor();
  scene.bodies.clear();
  for (const double side : {-1.0, 1.0}) {
    Body block;
    block.pieces = {make_box(Vector3(0.05, 0.05, 0.05))};
    block.X_WB.p = Vector3(side * 0.148, 0.1, 0.0);
    block.moving_index = static_cast<int>(scene.bodies.size());
    scene.bodies.push_back(block);
  }
  test::FreeBodyWorld world(std::move(scene), 0.8);
  ScriptedInterface interface([](double) { return pressed_into(0.0); });
  run(world, interface, 1.0);
  for (int i = 0; i < 2; ++i) EXPECT_LT(world.body(i).V_WB.linear.norm(), 0.1);
}

TEST(SimulatedSession, RepeatsBitForBit) {
  const auto once = [] {
    SceneGeometry scene = test::cube_over_floor();
    scene.bodies[0].moving_index = 0;
    test::FreeBodyWorld world(std::move(scene), 40.0);
    ScriptedInterface interface([](double time) {
      return Pose{{0.01 * std::sin(time), 0.1 + 0.002 * std::cos(30.0 * time), 0.0},
                  rotation_from_vector({0.02 * std::sin(7.0 * time), 0.0, 0.03 * std::sin(11.0 * time)})};
    });
    return run(world, interface, 1.0, 0.013);
  };
  const auto a = once(), b = once();
  ASSERT_EQ(a.size(), b.size());
  for (size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(Vector3(a[i].wrench.force), Vector3(b[i].wrench.force));
    EXPECT_EQ(Vector3(a[i].displayed.torque), Vector3(b[i].displayed.torque));
    EXPECT_EQ(a[i].X_WP.w, b[i].X_WP.w);
    EXPECT_EQ(a[i].model_sequence, b[i].model_sequence);
  }
}

TEST(SimulatedSession, TheObserverEndsTheRun) {
  test::FreeBodyWorld world(test::cube_over_floor());
  ScriptedInterface interface([](double) { return pressed_into(0.0); });
  PhysicsLoop physics(world, {0.05, 0.01}, ModelNeeds{});
  HapticTick tick(make_method("paper", {}, world.geometry()), world.geometry().tool, without_hand({}), 1e-3);
  int seen = 0;
  run_simulated(physics, tick, interface, 1e-3, 10.0, [&](const TickRecord&) { return ++seen < 7; });
  EXPECT_EQ(seen, 7);
}

TEST(PhysicsLoop, RefusesWhatItCannotRun) {
  test::FreeBodyWorld world(test::cube_over_floor());
  EXPECT_THROW(PhysicsLoop(world, {0.0, 0.01}, ModelNeeds{}), std::invalid_argument);
  EXPECT_THROW(PhysicsLoop(world, {0.05, -1.0}, ModelNeeds{}), std::invalid_argument);
  SceneGeometry crowded = test::cube_over_floor();
  for (int i = 0; i <= kMaxMovingBodies; ++i) {
    Body body;
    body.pieces = {make_sphere(0.01)};
    body.moving_index = i;
    crowded.bodies.push_back(body);
  }
  test::FreeBodyWorld too_many(std::move(crowded));
  EXPECT_THROW(PhysicsLoop(too_many, {0.05, 0.01}, ModelNeeds{}), std::invalid_argument);
}

}  // namespace
}  // namespace tegotae
