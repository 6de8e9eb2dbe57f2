// SPDX-License-Identifier: Apache-2.0
// A hand among the free boxes of table.xml, in simulated time: nothing flies away, whatever is done and set.
#include <tegotae/lab/input_error.hpp>
#include <tests/lab/free_bodies_motions.hpp>
#include <tests/lab/free_bodies_rig.hpp>
#include <tests/sweep_size.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdio>
#include <limits>

namespace tegotae::test {
namespace {

// Of every run, whatever is set.
void expect_sane(const FreeBodiesOutcome& outcome, const std::string& what) {
  EXPECT_EQ(outcome.infinite, 0) << what;
  EXPECT_TRUE(outcome.healthy) << what << ": " << outcome.trouble;
  // A box that fell from the table sinks by some 20 mm into MuJoCo's soft ground before it is thrown back.
  EXPECT_GT(outcome.lowest_gap, -0.05) << what;
  EXPECT_LE(outcome.force, 12.0 + 1e-9) << what << ": the interface's strength";
}

void print(const std::string& name, const FreeBodiesOutcome& o) {
  std::printf("| %-34s | %5.2f | %5.2f | %5.2f | %6.3f | %6.3f | %5.1f | %6.3f |\n", name.c_str(), o.tool_speed,
              o.body_speed, o.excess_speed, o.given, o.injected, 1e3 * o.deepest, o.chatter);
}

FreeBodiesOutcome run(const SessionSettings& settings, const HandWay& way) {
  FreeBodiesRig rig(settings);
  return rig.run(way.duration(), [&way](double time) { return way(time); });
}

// docs/free-bodies.md has what this prints.
TEST(FreeBodies, WhatANewcomerDoesThrowsNothingAway) {
  const SessionSettings settings = table_settings();
  for (const auto& [name, way] : table_ways()) {
    const FreeBodiesOutcome outcome = run(settings, way);
    print(name, outcome);
    expect_sane(outcome, name);
    EXPECT_LT(outcome.excess_speed, 0.5) << name;
    EXPECT_LT(outcome.injected, 0.01) << name;
    EXPECT_LT(outcome.deepest, 0.01) << name;
    EXPECT_LT(outcome.chatter, 0.02) << name << ": the hand rests at the end";
    EXPECT_GT(outcome.force, 0.5) << name << ": something was touched";
  }
}

TEST(FreeBodies, TheStackIsPushedAndBoxSixToppledAndBoxesAreKnockedOffTheTable) {
  const auto ways = table_ways();
  const auto way_called = [&ways](const std::string& name) {
    return std::find_if(ways.begin(), ways.end(), [&name](const NamedWay& way) { return way.name == name; })->way;
  };
  const auto end_of = [](int box, const HandWay& way) {
    FreeBodiesRig rig(table_settings());
    rig.run(way.duration(), [&way](double time) { return way(time); });
    return rig.watched.states()[static_cast<size_t>(box - 1)].X_WB;
  };
  EXPECT_GT(end_of(1, way_called("push the stack at 0.1 m/s")).p.x(), -0.05) << "from -0.12";
  const Pose toppled = end_of(6, way_called("topple box 6"));
  EXPECT_LT(std::abs((toppled.q * Vector3::UnitZ()).z()), 0.2) << "it lies";
  EXPECT_NEAR(toppled.p.z(), 0.42, 0.01);
  FreeBodiesRig rig(table_settings());
  const HandWay way = way_called("knock boxes off");
  rig.run(way.duration(), [&way](double time) { return way(time); });
  const auto below = [](const BodyState& state) { return state.X_WB.p.z() < 0.35; };
  EXPECT_GE(std::count_if(rig.watched.states().begin(), rig.watched.states().end(), below), 1);
}

TEST(FreeBodies, RandomSweepsThroughAllBoxesThrowNothingAway) {
  const SessionSettings settings = table_settings();
  double given = 0.0;
  for (int seed = 0; seed < sweep_size(10); ++seed) {
    const FreeBodiesOutcome outcome = run(settings, random_way(seed, 5.0));
    expect_sane(outcome, "seed " + std::to_string(seed));
    EXPECT_LT(outcome.excess_speed, 0.5) << seed;
    EXPECT_LT(outcome.injected, 0.05) << seed;
    EXPECT_LT(outcome.deepest, 0.015) << seed;
    given += outcome.given;
  }
  EXPECT_GT(given, 0.1 * sweep_size(10)) << "J: the boxes were pushed";
}

// Every value that a live run lets hold, and the physics rates: the worst of the ways, and of random ones.
TEST(FreeBodies, NoSettingThatHoldsThrowsThemAway) {
  const auto world = load_mujoco_world(TEGOTAE_SCENES "/table.xml", "tool");
  const auto ways = table_ways();
  const auto try_out = [&](const std::string& what, const std::function<void(SessionSettings&)>& set) {
    SessionSettings settings = table_settings();
    settings.stiffness = 500.0;
    set(settings);
    settings = as_live(settings, world->geometry());
    FreeBodiesOutcome worst;
    const auto include = [&](const FreeBodiesOutcome& outcome) {
      expect_sane(outcome, what);
      EXPECT_LT(outcome.excess_speed, 2.0) << what;
      EXPECT_LT(outcome.injected, 1.5) << what;
      worst.tool_speed = std::max(worst.tool_speed, outcome.tool_speed);
      worst.body_speed = std::max(worst.body_speed, outcome.body_speed);
      worst.excess_speed = std::max(worst.excess_speed, outcome.excess_speed);
      worst.given = std::max(worst.given, outcome.given);
      worst.injected = std::max(worst.injected, outcome.injected);
      worst.deepest = std::max(worst.deepest, outcome.deepest);
      worst.chatter = std::max(worst.chatter, outcome.chatter);
    };
    for (const auto& [name, way] : ways) {
      if (name.find("the stack at") != name.npos || name.find("knock") == 0) include(run(settings, way));
    }
    include(run(settings, random_way(100, 4.0)));
    print(what, worst);
  };
  for (const double stiffness : {200.0, 1000.0, 4000.0}) {
    try_out("stiffness " + std::to_string(static_cast<int>(stiffness)),
            [&](SessionSettings& settings) { settings.stiffness = stiffness; });
  }
  for (const double rate : {20.0, 50.0, 100.0, 250.0}) {
    try_out("physics " + std::to_string(static_cast<int>(rate)) + " Hz",
            [&](SessionSettings& settings) { settings.physics_rate = rate; });
  }
  for (const char* method : {"paper", "adachi", "berkelman", "otaduy-lin", "ortega"}) {
    try_out(method, [&](SessionSettings& settings) {
      settings.method = method;
      settings.metric_length = default_metric_length(method, world->geometry().tool);
    });
  }
  try_out("friction 0", [](SessionSettings& settings) { settings.friction = 0.0; });
  try_out("friction 2", [](SessionSettings& settings) { settings.friction = 2.0; });
  try_out("damping 1000", [](SessionSettings& settings) { settings.damping = 1000.0; });
  try_out("metric length 0.2", [](SessionSettings& settings) { settings.metric_length = 0.2; });
}

// A person who turns all knobs while the tool goes through the boxes.
TEST(FreeBodies, SettingsChangedInContactThrowNothingAway) {
  for (int seed = 0; seed < sweep_size(8); ++seed) {
    const HandWay way = random_way(1000 + seed, 5.0);
    std::mt19937_64 random(static_cast<std::uint64_t>(seed));
    const auto between = [&random](double least, double most) {
      return least + (most - least) * static_cast<double>(random() >> 11) * 0x1.0p-53;
    };
    FreeBodiesRig rig(table_settings());
    const auto names = method_names();
    double next = 0.2;
    const auto turn_knobs = [&](double time, HapticTick& haptics, PhysicsLoop& physics) {
      if (time < next) return;
      next = time + between(0.02, 0.4);
      SessionSettings settings = table_settings();
      settings.method = std::string(names[random() % names.size()].name);
      settings.stiffness = std::pow(10.0, between(1.0, 6.0));
      settings.damping = between(0.0, 50.0);
      settings.metric_length = std::pow(10.0, between(-3.0, 0.0));
      settings.friction = between(0.0, 3.0);
      settings = as_live(settings, rig.watched.geometry());
      RenderingMethod method = settings.make_method(rig.watched.geometry());
      physics.change(physics.settings(), needs_of(method));
      HapticUpdate update{
          std::make_unique<RenderingMethod>(std::move(method)),
          with_short_ramp(safety_limits_of(settings, rig.device.capability, rig.watched.geometry().tool))};
      haptics.adopt(update);
    };
    const FreeBodiesOutcome outcome = rig.run(
        5.0, [&way](double time) { return way(time); }, turn_knobs);
    print("knobs, seed " + std::to_string(seed), outcome);
    expect_sane(outcome, "seed " + std::to_string(seed));
    EXPECT_LT(outcome.excess_speed, 1.5) << seed;
  }
}

TEST(FreeBodies, TheCouplingIsHeldToWhatTheLightestBears) {
  const auto world = load_mujoco_world(TEGOTAE_SCENES "/table.xml", "tool");
  const SceneGeometry& geometry = world->geometry();
  const CouplingLimits fast = coupling_limits_for_bodies(geometry, 500.0);
  EXPECT_NEAR(fast.stiffness, kStiffnessOfMass * 0.08 * 250e3, 1e-6) << "of box 3";
  EXPECT_NEAR(fast.damping, kDampingOfMass * 0.08 * 500.0, 1e-9);
  EXPECT_NEAR(coupling_limits_for_bodies(geometry, 250.0).stiffness, fast.stiffness / 4.0, 1e-6);
  SessionSettings settings = table_settings();
  settings.stiffness = 1e4;
  settings.damping = 1e3;
  settings.rotational_damping = 1e3;
  const SessionSettings held = held_to_bodies(settings, geometry);
  EXPECT_EQ(held.stiffness, fast.stiffness);
  EXPECT_EQ(held.damping, fast.damping);
  EXPECT_LE(*held.rotational_damping, fast.damping * settings.metric_length * settings.metric_length);
  EXPECT_NO_THROW(check_bodies_bear("stiffness", fast.stiffness, geometry, 500.0));
  EXPECT_NO_THROW(check_bodies_bear("friction", 1e9, geometry, 500.0));
  EXPECT_THAT([&] { check_bodies_bear("stiffness", 1000.0, geometry, 100.0); },
              ::testing::ThrowsMessage<InputError>(::testing::HasSubstr("at most 80 N/m with physics at 100 Hz")));
  EXPECT_THROW(check_bodies_bear("damping", 1000.0, geometry, 500.0), InputError);
}

TEST(FreeBodies, WithoutAnyTheCouplingIsFree) {
  const auto world = load_mujoco_world(TEGOTAE_SCENES "/paper-cube.xml", "tool");
  EXPECT_EQ(coupling_limits_for_bodies(world->geometry(), 20.0).stiffness, std::numeric_limits<double>::infinity());
  SessionSettings settings;
  settings.stiffness = 9000.0;
  EXPECT_EQ(held_to_bodies(settings, world->geometry()).stiffness, 9000.0);
  EXPECT_NO_THROW(check_bodies_bear("stiffness", 9000.0, world->geometry(), 20.0));
}

TEST(FreeBodies, TheSceneTellsTheirMasses) {
  const auto world = load_mujoco_world(TEGOTAE_SCENES "/table.xml", "tool");
  const double masses[] = {0.60, 0.25, 0.08, 0.80, 0.15, 0.30};
  for (const Body& body : world->geometry().bodies) {
    if (body.moving_index < 0) {
      EXPECT_EQ(body.mass, 0.0) << body.name;
      continue;
    }
    EXPECT_NEAR(body.mass, masses[body.moving_index], 1e-12) << body.name;
    const MassProperties own = mass_properties(body.pieces.front(), 1000.0);
    EXPECT_NEAR(body.gyration_length, own.gyration_length(), 1e-12) << body.name;
  }
}

}  // namespace
}  // namespace tegotae::test
