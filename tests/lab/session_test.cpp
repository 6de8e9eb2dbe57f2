// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/experiment_run.hpp>
#include <tegotae/lab/input_error.hpp>
#include <tests/lab/cube_session.hpp>
#include <tests/lab/samples_table.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <string>
#include <vector>

namespace tegotae {
namespace {

Session cube_session(Trajectory motion) {
  auto world = load_mujoco_world(TEGOTAE_SCENES "/paper-cube.xml", "tool");
  const SessionSettings settings =
      decide_settings(settings_of(world->haptic_settings(), "scene"), world->geometry().tool);
  return {std::move(world), std::move(motion), settings};
}

Trajectory pressed(double duration) {
  return cube_motion(
      duration, [](double) { return kHalfEdge - 0.3e-3; }, [](double) { return 0.0; });
}

TEST(Session, TakesTheSettingsOfTheScene) {
  const Session session = cube_session(pressed(0.1));
  EXPECT_EQ(session.settings().stiffness, kStiffness);
  EXPECT_EQ(session.settings().physics_rate, 20.0);
  EXPECT_EQ(session.settings().metric_length, session.tool().mass.gyration_length());
  EXPECT_EQ(session.settings().gravity, Vector3(0.0, -9.81, 0.0));
  EXPECT_THAT(session.notes(), testing::IsSupersetOf({"tool: tool", "centre of mass in the tool's frame: 0 0 0 m"}));
}

TEST(Session, HoldsSettingsToWhatAnInterfaceIsRatedFor) {
  InterfaceCapability interface;
  SessionSettings wanted;
  wanted.stiffness = 5e3;
  wanted.damping = 1e4;
  wanted.metric_length = 0.5;
  wanted.transient = 1e4;
  EXPECT_EQ(held_to_rating(wanted, interface).lines(), wanted.lines()) << "what is not known bounds nothing";
  interface.max_stiffness = 1e3;
  interface.max_rotational_stiffness = 10.0;
  interface.max_damping = 50.0;
  interface.max_rotational_damping = 0.2;
  const SessionSettings held = held_to_rating(wanted, interface);
  EXPECT_EQ(held.stiffness, 1e3);
  EXPECT_NEAR(held.metric_length, 0.1, 1e-12);
  EXPECT_EQ(held.damping, 50.0);
  EXPECT_EQ(held.rotational_damping, 0.2) << "d l^2 would be 0.5";
  EXPECT_EQ(held.transient, 50.0);
  wanted.damping = 10.0;
  EXPECT_FALSE(held_to_rating(wanted, interface).rotational_damping.has_value()) << "d l^2 is 0.1";
  wanted.rotational_damping = 7.0;
  EXPECT_EQ(held_to_rating(wanted, interface).rotational_damping, 0.2);
}

TEST(Session, HoldsToTheRatingWhatIsFeltUnlessTheUserInsists) {
  InterfaceCapability interface;
  interface.max_stiffness = 1e3;
  interface.max_rotational_stiffness = 10.0;
  interface.max_damping = 50.0;
  SessionSettings wanted;
  wanted.stiffness = 5e3;
  wanted.damping = 1e3;
  wanted.metric_length = 0.5;
  wanted.workspace.translation_scale = 2.0;
  wanted.workspace.rotation_scale = 3.0;
  wanted.workspace.force_scale = 0.1;
  const SessionSettings held = held_to_rating(wanted, interface);
  EXPECT_NEAR(held.workspace.felt_stiffness(held.stiffness), 1e3, 1e-9) << "5000 N/m in the world";
  EXPECT_NEAR(held.stiffness, 5e3, 1e-9);
  EXPECT_NEAR(held.workspace.felt_stiffness(held.damping), 50.0, 1e-9);
  const double rotational = held.stiffness * held.metric_length * held.metric_length;
  EXPECT_NEAR(held.workspace.felt_rotational_stiffness(rotational), 10.0, 1e-9);
  wanted.beyond_rating = true;
  EXPECT_EQ(held_to_rating(wanted, interface).lines(), wanted.lines());
}

TEST(Session, LimitsAreForWhoHoldsTheInterface) {
  const Session session = cube_session(pressed(0.1));
  SessionSettings settings = session.settings();
  InterfaceCapability interface;
  const SafetyLimits in_hand = safety_limits_of(settings, interface, session.tool());
  EXPECT_EQ(in_hand.ramp_time, 2.0);
  EXPECT_EQ(in_hand.ramp_below_force, 0.2);
  EXPECT_TRUE(in_hand.energy_bound.on);
  interface.in_hand = false;
  const SafetyLimits played = safety_limits_of(settings, interface, session.tool());
  EXPECT_EQ(played.ramp_time, 0.2);
  EXPECT_TRUE(std::isinf(played.ramp_below_force) && std::isinf(played.max_speed));
  EXPECT_FALSE(played.energy_bound.on);
  interface.in_hand = true;
  settings.energy_bound = false;
  settings.dead_man_button = 3;
  settings.tool_weight = true;
  settings.workspace.force_scale = 0.5;
  const SafetyLimits chosen = safety_limits_of(settings, interface, session.tool());
  EXPECT_FALSE(chosen.energy_bound.on);
  EXPECT_EQ(chosen.dead_man_button, 3);
  EXPECT_NEAR(chosen.ramp_below_force, 0.2 + 0.5 * 9.81 * session.tool().mass.mass, 1e-9);
  EXPECT_NEAR(chosen.force_rate, 0.5 * in_hand.force_rate, 1e-9 * in_hand.force_rate);
}

TEST(Session, ASceneMayNotSetWhatIsTheHandsAlone) {
  for (const char* name : {"energy_bound", "beyond_rating", "dead_man_button", "clutch_button", "force_scale"}) {
    EXPECT_THROW(settings_of({{name, 1.0}}, "room.xml"), InputError) << name;
  }
}

TEST(Session, RefusesSettingsOfASceneThatAreUnknownOrOutOfRange) {
  const auto refusal = [](const std::string& name, double value) {
    try {
      settings_of({{name, value}}, "room.xml");
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  EXPECT_THAT(refusal("stifness", 1.0),
              testing::AllOf(testing::HasSubstr("room.xml: unknown haptic setting"),
                             testing::HasSubstr("tegotae_stifness"), testing::HasSubstr("tegotae_friction")));
  EXPECT_THAT(refusal("haptic_rate", 0.0), testing::HasSubstr("permitted are 10 to 20000 Hz"));
  EXPECT_THAT(refusal("damping", -1.0), testing::HasSubstr("room.xml: the setting 'tegotae_damping'"));
  EXPECT_THAT(refusal("friction", -0.5), testing::HasSubstr("permitted are 0 to 10"));
  EXPECT_EQ(refusal("metric_length", 0.0), "");
  EXPECT_EQ(settings_of({{"tool_weight", 1.0}}, "room.xml").tool_weight, 1.0);
}

TEST(Session, TellsItsProgressInOrder) {
  Session session = cube_session(pressed(3.5));
  std::vector<double> parts;
  session.run_simulated([](const TickRecord&) { return true; }, [&](double part) { parts.push_back(part); });
  ASSERT_EQ(parts.size(), 3U);
  EXPECT_TRUE(std::is_sorted(parts.begin(), parts.end()));
  EXPECT_LE(parts.back(), 1.0);
  EXPECT_EQ(session.trouble(), "");
}

TEST(Session, EndsWhereTheObserverSaysSo) {
  Session session = cube_session(pressed(1.0));
  int ticks = 0;
  session.run_simulated([&](const TickRecord&) { return ++ticks < 10; }, [](double) {});
  EXPECT_EQ(ticks, 10);
}

TEST(Session, RefusesAMotionWhoseTimeIsNotInSeconds) {
  const auto make = [] { cube_session(Trajectory({{0.0, Pose{}}, {1e9, Pose{}}})); };
  EXPECT_THAT(make, testing::ThrowsMessage<InputError>(testing::HasSubstr("seconds")));
}

TEST(Session, DisplaysTheSameForceInRealTime) {
  Session session = cube_session(pressed(0.5));
  std::vector<TickRecord> records;
  const std::atomic<bool> stop{false};
  const RealtimeReport report = session.run_realtime(
      [&](const TickRecord& record) {
        records.push_back(record);
        return true;
      },
      [](double) {}, stop);
  ASSERT_FALSE(records.empty());
  EXPECT_EQ(report.physics_error, "");
  EXPECT_GT(records.back().time, 0.1);
  EXPECT_EQ(report.haptics.count(), records.size() + report.dropped_records);
  for (const TickRecord& record : records) {
    // Started inside, the tool is brought out at a bounded speed; then it is held off by the skin.
    ASSERT_LT(record.wrench.force.y, kStiffness * 0.303e-3);
    if (record.time > 0.1) {
      ASSERT_GT(record.wrench.force.y, kStiffness * 0.3e-3);
    }
    ASSERT_LT(record.wrench.torque.vector().norm(), 1e-9);
  }
}

TEST(Session, InRealTimeStopsWhenTold) {
  Session session = cube_session(pressed(1000.0));
  std::atomic<bool> stop{false};
  double last = 0.0;
  session.run_realtime(
      [&](const TickRecord& record) {
        last = record.time;
        stop.store(true);
        return true;
      },
      [](double) {}, stop);
  EXPECT_LT(last, 1000.0);
}

TEST(ExperimentRun, InRealTimeKeepsTheReportAndTheSamples) {
  Experiment experiment = find_experiment("paper-cube");
  experiment.motion = [](const Tool&) { return pressed(0.3); };
  const TemporaryFolder folder;
  ExperimentRequest request;
  request.folder = folder.path();
  request.real_time = true;
  const ExperimentResult result = run_experiment(experiment, request, [](double) {});
  ASSERT_EQ(result.variants.size(), 2U);
  for (const VariantResult& variant : result.variants) {
    ASSERT_TRUE(variant.real_time.has_value());
    EXPECT_FALSE(variant.records.empty());
    EXPECT_EQ(read_samples(variant.samples_file).rows.size(), variant.records.size());
  }
  EXPECT_THAT(contents_of(result.summary_file), testing::HasSubstr("\"time\": \"real\""));
}

}  // namespace
}  // namespace tegotae
