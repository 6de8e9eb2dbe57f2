// SPDX-License-Identifier: Apache-2.0
#include <tegotae/runtime/haptic_tick.hpp>
#include <tegotae/runtime/physics_loop.hpp>

#include <tests/free_body_world.hpp>

#include <gtest/gtest.h>

#include <memory>

namespace tegotae {
namespace {

constexpr double kHeldPeriod = 1e-3;
constexpr double kHeldPhysicsPeriod = 0.05;

// The greatest change of force in a tick while the floor comes up under a held cube in steps of the physics.
double greatest_step(std::string_view method, double& last) {
  SceneGeometry scene = test::cube_over_floor();
  scene.bodies[0].moving_index = 0;
  test::FreeBodyWorld world(scene);
  PhysicsLoop physics(world, {kHeldPhysicsPeriod, 0.01}, ModelNeeds{});
  SafetyLimits limits;
  const Tool& tool = world.geometry().tool;
  MethodSettings settings;
  settings.stiffness = 9000.0;
  HapticTick tick(make_method(method, settings, world.geometry()), tool, limits, kHeldPeriod);
  const Pose held{{0.0, 0.1, 0.0}, Quaternion::Identity()};
  auto model = std::make_unique<IntermediateRepresentation>();
  TickRecord record;
  double greatest = 0.0;
  last = 0.0;
  for (int i = 0; i < 200; ++i) {
    const bool fresh = i % 50 == 0;
    if (fresh) {
      const int models = i / 50 + 1;
      world.body(0).X_WB.p.y() = -0.1 + 1e-4 * models;
      physics.build(i * kHeldPeriod, {held, {}}, *model);
    }
    InterfaceState state;
    state.time = i * kHeldPeriod;
    state.X_WT = held;
    tick(state, fresh ? model.get() : nullptr, {}, record);
    const double force = record.wrench.force.y;
    if (i >= 50) greatest = std::max(greatest, std::abs(force - last));
    last = force;
  }
  return greatest;
}

TEST(HeldModel, TheEarlierMethodsStepWithThePhysicsWhereThePaperInterpolates) {
  double last = 0.0;
  EXPECT_LT(greatest_step("paper", last), 0.9 / 40.0);
  for (const char* method : {"adachi", "ortega"}) {
    EXPECT_NEAR(greatest_step(method, last), 0.9, 0.01) << method << ": 0.1 mm at 9000 N/m at once";
    EXPECT_NEAR(last, 3.6, 0.01) << method;
  }
  EXPECT_NEAR(greatest_step("berkelman", last), 4 * 0.9, 0.04);
}

TEST(HeldModel, OnlyMethodsThatSayItHoldTheirModel) {
  const SceneGeometry scene = test::cube_over_floor();
  EXPECT_FALSE(holds_model(make_method("paper", {}, scene)));
  for (const char* name : {"adachi", "berkelman", "otaduy-lin", "ortega"}) {
    EXPECT_TRUE(holds_model(make_method(name, {}, scene))) << name;
  }
}

}  // namespace
}  // namespace tegotae
