// SPDX-License-Identifier: Apache-2.0
// The force law of the proxy method: damping, the tool's own weight and inertia, the vibration of an impact.
#include <tegotae/render/rendering_method.hpp>

#include <tests/render/proxy_rig.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tegotae::test {
namespace {

ProxyRig block_over_floor() {
  ProxyRig rig({make_box({0.02, 0.02, 0.02})});
  rig.add_body(make_plane());
  return rig;
}

TEST(ProxyOptions, DampingActsOnTheChangeOfTheDifference) {
  ProxyRig rig = block_over_floor();
  rig.parameters.coupling.damping = 20.0;
  rig.tick(at(0.0, 0.0, 0.021));
  rig.hold(at(0.0, 0.0, 0.019), 3);
  EXPECT_NEAR(rig.output.wrench.force.z(), ProxyRig::kStiffness * 1.002e-3, 1e-3);
  rig.tick(at(0.0, 0.0, 0.0189));
  EXPECT_NEAR(rig.output.wrench.force.z(), ProxyRig::kStiffness * 1.102e-3 + 20.0 * 0.1, 1e-3);
}

TEST(ProxyOptions, WeightIsFeltInTheAirAndNotOnTheFloor) {
  ProxyRig rig = block_over_floor();
  rig.parameters.weight = true;
  const double weight = rig.scene.tool.mass.mass * 9.81;
  rig.hold(at(0.0, 0.0, 0.1), 5);
  EXPECT_NEAR(rig.output.wrench.force.z(), -weight, 1e-6);
  EXPECT_LT(rig.output.wrench.torque.norm(), 1e-9);
  // Held so that it just stands on the floor.
  rig.hold(at(0.0, 0.0, 0.02 + 2e-6), 5);
  EXPECT_NEAR(rig.output.wrench.force.z(), 0.0, 1e-3);
}

TEST(ProxyOptions, InertiaIsFeltAsMassTimesAcceleration) {
  ProxyRig rig = block_over_floor();
  rig.parameters.inertia = true;
  rig.parameters.coupling.damping = 30.0;
  const double mass = rig.scene.tool.mass.mass, acceleration = 2.0;
  for (int i = 0; i < 400; ++i) rig.tick(at(0.5 * acceleration * 1e-6 * i * i, 0.0, 0.5));
  EXPECT_NEAR(rig.output.wrench.force.x(), -mass * acceleration, 0.05 * mass * acceleration);
  for (int i = 0; i < 2000; ++i) rig.tick(at(0.0, 0.0, 0.5));
  EXPECT_LT(rig.output.wrench.force.norm(), 1e-3);
}

TEST(ProxyOptions, AnImpactRingsByItsSpeed) {
  const auto ring = [](double speed) {
    ProxyRig rig = block_over_floor();
    rig.parameters.transient = {10.0, 125.0, 60.0};
    double z = 0.022, greatest = 0.0;
    rig.tick(at(0.0, 0.0, z));
    for (int i = 0; i < 50; ++i) {
      z = std::max(0.0199, z - 1e-3 * speed);
      rig.tick(at(0.0, 0.0, z));
      const double elastic = ProxyRig::kStiffness * std::max(0.0, 0.020002 - z);
      greatest = std::max(greatest, rig.output.wrench.force.z() - elastic);
    }
    return greatest;
  };
  const double slow = ring(0.1), fast = ring(0.2);
  // A v exp(-b t) at a quarter of the period, 2 ms, or little later.
  EXPECT_NEAR(slow, 10.0 * 0.1 * std::exp(-60.0 * 0.002), 0.15);
  EXPECT_NEAR(fast, 2.0 * slow, 0.3 * slow);
}

TEST(ProxyOptions, SettingsOutOfRangeAreRefusedWithTheRange) {
  const ProxyRig rig = block_over_floor();
  const auto refused = [&rig](auto change) {
    MethodSettings settings;
    change(settings);
    try {
      make_method("proxy", settings, rig.scene);
    } catch (const std::invalid_argument& error) {
      return std::string(error.what()).find("out of range") != std::string::npos;
    }
    return false;
  };
  EXPECT_FALSE(refused([](MethodSettings&) {}));
  EXPECT_TRUE(refused([](MethodSettings& s) { s.stiffness = -1.0; }));
  EXPECT_TRUE(refused([](MethodSettings& s) { s.friction = -0.1; }));
  EXPECT_TRUE(refused([](MethodSettings& s) { s.friction_scale = 1e9; }));
  EXPECT_TRUE(refused([](MethodSettings& s) { s.kinetic_friction = 1.5; }));
  EXPECT_TRUE(refused([](MethodSettings& s) { s.contact_margin = 0.0; }));
  EXPECT_TRUE(refused([](MethodSettings& s) { s.viscous_friction = std::nan(""); }));
  const ModelNeeds needs = needs_of(make_method("proxy", {}, rig.scene));
  EXPECT_FALSE(needs.planes_and_points);
  EXPECT_TRUE(needs.about_proxy);
  EXPECT_TRUE(needs_of(make_method("paper", {}, rig.scene)).planes_and_points);
}

}  // namespace
}  // namespace tegotae::test
