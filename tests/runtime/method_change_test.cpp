// SPDX-License-Identifier: Apache-2.0
#include <tegotae/runtime/haptic_tick.hpp>
#include <tegotae/runtime/physics_loop.hpp>

#include <tests/free_body_world.hpp>

#include <gtest/gtest.h>

#include <memory>
#include <string>

// Methods and settings that change while the tool presses on the floor.
namespace tegotae {
namespace {

constexpr double kChangePeriod = 1e-3;
constexpr double kPressDepth = 1e-3;  // m

Pose pressed_by(double depth) { return {{0.0, 0.1 - depth, 0.0}, Quaternion::Identity()}; }

struct ChangeRig {
  explicit ChangeRig(const char* method) : world(test::cube_over_floor()), physics(world, {0.05, 0.01}, {true, false}) {
    limits = without_hand(limits);
    limits.ramp_time = kChangePeriod;
    limits.force_rate = limits.torque_rate = 1e9;
    limits.max_force = 1e3;
    tick = std::make_unique<HapticTick>(make(method), world.geometry().tool, limits, kChangePeriod);
    physics.build(0.0, {pressed_by(-0.5e-3), {}}, *model);
  }

  RenderingMethod make(const char* method, double stiffness = 1000.0) const {
    MethodSettings settings;
    settings.stiffness = stiffness;
    return make_method(method, settings, world.geometry());
  }

  void run(int ticks, double depth) {
    for (int i = 0; i < ticks; ++i, ++count) {
      InterfaceState state;
      state.time = kChangePeriod * count;
      state.X_WT = pressed_by(depth);
      (*tick)(state, count == 0 ? model.get() : nullptr, {}, record);
    }
  }

  // From above the floor to below it, so that methods with a proxy have it on top.
  void press() {
    run(1, -0.5e-3);
    run(200, kPressDepth);
  }

  void change(RenderingMethod method) {
    HapticUpdate update{std::make_unique<RenderingMethod>(std::move(method)), limits};
    tick->adopt(update);
    ASSERT_NE(update.method, nullptr) << "what is no longer used comes back to be freed";
  }

  double force() const { return record.wrench.force.y; }

  test::FreeBodyWorld world;
  PhysicsLoop physics;
  SafetyLimits limits;
  std::unique_ptr<HapticTick> tick;
  std::unique_ptr<IntermediateRepresentation> model = std::make_unique<IntermediateRepresentation>();
  TickRecord record;
  int count = 0;
};

TEST(MethodChange, AnotherStiffnessIsFeltInTheNextTickByEveryMethod) {
  for (const MethodName& method : method_names()) {
    SCOPED_TRACE(method.name);
    const std::string name(method.name);
    ChangeRig rig(name.c_str());
    rig.press();
    const double before = rig.force();
    ASSERT_GT(before, 0.5);
    rig.change(rig.make(name.c_str(), 2000.0));
    rig.run(1, kPressDepth);
    // A simulated tool with mass takes some ticks.
    if (name == "otaduy-lin") rig.run(500, kPressDepth);
    EXPECT_NEAR(rig.force(), 2.0 * before, 0.02 * before);
  }
}

TEST(MethodChange, EveryMethodGoesOnFromWhereTheOtherLeftTheTool) {
  for (const MethodName& from : method_names()) {
    for (const MethodName& to : method_names()) {
      SCOPED_TRACE(std::string(from.name) + " to " + std::string(to.name));
      const std::string first(from.name), second(to.name);
      ChangeRig rig(first.c_str()), alone(second.c_str());
      rig.press();
      alone.press();
      rig.change(rig.make(second.c_str()));
      double least = 1e300, greatest = 0.0;
      for (int i = 0; i < 300; ++i) {
        rig.run(1, kPressDepth);
        least = std::min(least, rig.force());
        greatest = std::max(greatest, rig.force());
      }
      EXPECT_NEAR(rig.force(), alone.force(), 0.02 * alone.force()) << "it comes to what it renders alone";
      EXPECT_GT(least, -1e-9) << "it never pulls into the floor";
      // A simulated tool that starts below the floor, without damping, is thrown out by its contact springs.
      const double bounce = second == "otaduy-lin" ? 2.5 : 1.2;
      EXPECT_LT(greatest, bounce * std::max(alone.force(), rig.force())) << "nor kicks";
    }
  }
}

TEST(MethodChange, TheProxyStaysOnItsSideOfThePlate) {
  ChangeRig rig("ortega");
  rig.press();
  const double height = rig.record.X_WP.p.y;
  rig.change(rig.make("proxy"));
  rig.run(1, kPressDepth);
  EXPECT_NEAR(rig.record.X_WP.p.y, height, 1e-5);
  EXPECT_GT(rig.force(), 0.9 * 1000.0 * kPressDepth);
}

TEST(MethodChange, FrictionChangesForWhatIsTouchedAlready) {
  ChangeRig rig("proxy");
  rig.press();
  MethodSettings slippery;
  slippery.friction = 0.0;
  rig.change(make_method("proxy", slippery, rig.world.geometry()));
  const auto pull = [&](double x) {
    InterfaceState state;
    state.time = kChangePeriod * rig.count++;
    state.X_WT = pressed_by(kPressDepth);
    state.X_WT.p.x() = x;
    (*rig.tick)(state, nullptr, {}, rig.record);
  };
  for (int i = 0; i < 50; ++i) pull(1e-5 * i);
  EXPECT_NEAR(rig.record.wrench.force.x, 0.0, 1e-6);
  MethodSettings rough;
  rough.friction = 0.5;
  rig.change(make_method("proxy", rough, rig.world.geometry()));
  for (int i = 50; i < 600; ++i) pull(1e-5 * i);
  EXPECT_NEAR(rig.record.wrench.force.x, -0.5 * rig.force(), 0.01 * rig.force());
}

TEST(ContactViewOfTick, ShowsPlanePointsAndWhatTheyPush) {
  for (const MethodName& method : method_names()) {
    SCOPED_TRACE(method.name);
    const std::string name(method.name);
    ChangeRig rig(name.c_str());
    ContactView view;
    rig.tick->view(view);
    EXPECT_EQ(view.plane_count + view.point_count, 0) << "before the first tick";
    rig.press();
    rig.tick->view(view);
    ASSERT_EQ(view.plane_count, 1);
    EXPECT_NEAR(view.used_planes()[0].n_W.y, 1.0, 1e-9);
    EXPECT_NEAR(view.used_planes()[0].p_W.y, 0.0, 1e-9) << "a point of the object";
    EXPECT_GE(view.point_count, 4);
    EXPECT_EQ(view.time, rig.record.time);
    double pushed = 0.0;
    for (const ViewedPoint& point : view.used_points()) {
      EXPECT_LT(std::abs(point.p_W.y), 2.0 * kPressDepth + 0.2);
      pushed += point.force;
    }
    EXPECT_NEAR(pushed, rig.force(), 0.02 * rig.force());
    EXPECT_EQ(view.anchor_count, name == "proxy" ? 1 : 0);
  }
}

TEST(ContactViewOfTick, HoldsWhatFitsAndNoMore) {
  ContactView view;
  for (int i = 0; i < 1000; ++i) {
    view.add(ViewedPlane{});
    view.add(ViewedPoint{});
    view.add(ViewedAnchor{});
  }
  EXPECT_EQ(view.used_planes().size(), static_cast<std::size_t>(kMaxViewedPlanes));
  EXPECT_EQ(view.used_points().size(), static_cast<std::size_t>(kMaxViewedPoints));
  EXPECT_EQ(view.used_anchors().size(), static_cast<std::size_t>(kMaxViewedAnchors));
}

}  // namespace
}  // namespace tegotae
