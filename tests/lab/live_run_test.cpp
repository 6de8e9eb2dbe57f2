// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/experiment.hpp>
#include <tegotae/lab/free_body_stiffness.hpp>
#include <tegotae/lab/input_error.hpp>
#include <tegotae/lab/live_messages.hpp>
#include <tegotae/lab/live_run.hpp>
#include <tegotae/lab/scripted_motion.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <functional>
#include <memory>
#include <string>

// A run of two real threads, steered from this one. Nothing here says how long anything takes: each test goes on until
// the run has come to where it must come, or the test's own time is over.
namespace tegotae {
namespace {

LiveScene scene(const std::string& file) { return {file, std::filesystem::path(TEGOTAE_SCENES) / file}; }

// Performs `pass` every few milliseconds until it says that the run may end.
struct Steered {
  explicit Steered(const LiveScene& which, const SettingsRequest& wanted = {}, HapticInterface* device = nullptr)
      : run(which, wanted, device) {}

  void until(const std::function<bool()>& done) {
    report = run.run(
        stop,
        [&](const TickRecord& record) {
          // Not the last ones, which command zero.
          if (!ended) newest = record;
          ++ticks;
          return true;
        },
        [&] {
          if (ticks == 0 || ended || !done()) return;
          ended = true;
          run.end();
        });
  }

  LiveRun run;
  std::atomic<bool> stop{false};
  TickRecord newest;
  long ticks = 0;
  bool ended = false;
  RealtimeReport report;
};

double force(const TickRecord& record) { return Vector3(record.displayed.force).norm(); }

TEST(LiveRun, TheHandPressesTheToolOnTheTableAndTheTableStopsIt) {
  Steered steered(scene("table.xml"));
  Pose below = steered.run.geometry().tool.X_WT;
  below.p.z() = 0.43;  // the probe ends 65 mm lower, the table's top is at 0.4 m
  steered.run.guide(below);
  steered.until([&] { return force(steered.newest) > 2.0 && steered.run.contacts().plane_count > 0; });
  EXPECT_NEAR(steered.newest.X_WP.p.z, 0.465, 1e-4);
  EXPECT_LT(steered.newest.X_WT.p.z, 0.465) << "the hand goes on a little";
  EXPECT_NEAR(steered.run.contacts().used_planes()[0].p_W.z, 0.4, 1e-3) << "of the table's top";
}

TEST(LiveRun, AStiffnessActsWhileTheToolPresses) {
  Steered steered(scene("table.xml"));
  Pose below = steered.run.geometry().tool.X_WT;
  below.p.z() = 0.455;
  steered.run.guide(below);
  long changed = 0;  // tick
  steered.until([&] {
    constexpr double kRampDone = 2.5;  // s
    if (changed == 0 && force(steered.newest) > 1.0 && steered.newest.time > kRampDone) {
      steered.run.set("stiffness", 2000.0);
      changed = steered.ticks;
    }
    return changed > 0 && steered.ticks > changed + 1000;
  });
  EXPECT_EQ(steered.run.settings().stiffness, 2000.0);
  const double depth = steered.newest.X_WP.p.z - steered.newest.X_WT.p.z;
  EXPECT_NEAR(force(steered.newest) / depth, 2000.0, 100.0);
}

TEST(LiveRun, MethodsChangeOneAfterTheOther) {
  Steered steered(scene("cube-on-floor.xml"));
  size_t next = 0;
  long since = 0;
  steered.until([&] {
    if (steered.ticks < since + 50) return false;
    since = steered.ticks;
    if (next == method_names().size()) return true;
    steered.run.set_method(method_names()[next++].name);
    return false;
  });
  EXPECT_EQ(steered.run.settings().method, method_names().back().name);
  EXPECT_EQ(steered.newest.status, static_cast<std::uint8_t>(RenderStatus::kOk));
}

TEST(LiveRun, APausedRunStandsStillAndGoesOnByPeriods) {
  Steered steered(scene("table.xml"));
  long paused_at = -1, steps_given = 0, waited = 0;
  double time_paused = 0.0;
  steered.until([&] {
    if (paused_at < 0) {
      if (steered.ticks < 100) return false;
      steered.run.pause(true);
      // Ticks that are on their way still come.
      if (++waited < 20) return false;
      paused_at = steered.ticks;
      time_paused = steered.newest.time;
      waited = 0;
    }
    if (++waited < 20) return false;
    if (steps_given == 0) {
      EXPECT_EQ(steered.ticks, paused_at) << "nothing happens";
    }
    if (steps_given < 5) {
      for (int i = 0; i < 3; ++i) steered.run.step();  // in one breath: one step
      ++steps_given;
      waited = 0;
      return false;
    }
    return true;
  });
  const double period = 1.0 / steered.run.settings().physics_rate;
  // The run's last tick, which commands zero, comes after the steps.
  EXPECT_NEAR(steered.newest.time - time_paused, 5.0 * period, 1.5e-3);
  EXPECT_EQ(steered.ticks - paused_at - 1, std::lround(5.0 * period * 1000.0));
}

TEST(LiveRun, AScriptIsPlayedAndEnds) {
  Steered steered(scene("table.xml"));
  steered.run.play(find_scripted_motion("tap").motion(Vector3::UnitZ()));
  double lowest = 1.0;
  steered.until([&] {
    lowest = std::min(lowest, steered.newest.X_WT.p.z);
    return steered.newest.time > 0.5 && !steered.run.is_playing();
  });
  EXPECT_LT(lowest, 0.47) << "it went down to the table";
  EXPECT_GT(steered.newest.time, 1.4) << "not before its end";
}

TEST(LiveRun, AnExperimentIsPlayedExactlyThenTheHandTakesTheTool) {
  const Experiment& experiment = find_experiment("paper-cube");
  Steered steered(live_scene_of(experiment));
  EXPECT_TRUE(steered.run.is_playing_exactly());
  const Trajectory motion = experiment.motion(steered.run.geometry().tool);
  steered.until([&] {
    if (steered.newest.time < 0.5) return false;
    steered.run.stop_motion();
    return steered.newest.time > 0.6;
  });
  EXPECT_FALSE(steered.run.is_playing());
  const Pose expected = motion.at(motion.start() + 0.5);
  EXPECT_LT((Vector3(steered.newest.X_WT.p) - expected.p).norm(), 0.02) << "near where it was";
}

TEST(LiveRun, WhatIsRefusedChangesNothing) {
  LiveRun run(scene("table.xml"), {});
  const SessionSettings before = run.settings();
  EXPECT_THROW(run.set("stiffness", -1.0), InputError);
  EXPECT_THROW(run.set("stiffness", std::nan("")), InputError);
  EXPECT_THROW(run.set("colour", 1.0), InputError);
  EXPECT_THROW(run.set("haptic_rate", 2000.0), InputError);
  EXPECT_THROW(run.set("physics_rate", 1999.0), InputError);
  EXPECT_THROW(run.set("energy_bound", 0.0), InputError) << "nor may a page";
  EXPECT_THROW(run.set("beyond_rating", 1.0), InputError);
  EXPECT_THROW(run.set_method("magic"), InputError);
  run.set_method("paper");
  EXPECT_THROW(run.set("friction", 0.5), InputError) << "which this method does not have";
  run.set_method("proxy");
  EXPECT_EQ(run.settings().lines(), before.lines());
}

TEST(LiveRun, HoldsTheCouplingToWhatTheInterfaceIsRatedFor) {
  LiveRun run(scene("cube-on-floor.xml"), {});
  run.set("stiffness", 1e6);
  EXPECT_EQ(run.settings().stiffness, run.interface().max_stiffness);
  run.set_method("paper");
  const double rotational = run.settings().stiffness * run.settings().metric_length * run.settings().metric_length;
  EXPECT_LE(rotational, run.interface().max_rotational_stiffness * (1.0 + 1e-12));
}

TEST(LiveRun, AnExperimentHasItsOwnStiffnessUntilTheHandTakesTheTool) {
  SettingsRequest wanted;
  wanted.method = "paper";
  Steered steered(live_scene_of(find_experiment("paper-cube")), wanted);
  EXPECT_EQ(steered.run.settings().stiffness, 9000.0);
  EXPECT_EQ(steered.run.settings().metric_length, 1.0);
  bool took_over = false;
  steered.until([&] {
    if (steered.newest.time > 0.2) steered.run.stop_motion();
    took_over = took_over || steered.run.hand_took_over();
    return took_over;
  });
  EXPECT_EQ(steered.run.settings().stiffness, steered.run.interface().max_stiffness);
  EXPECT_LT(steered.run.settings().metric_length, 1.0);
  EXPECT_EQ(steered.run.request().stiffness, 9000.0) << "what was asked for is not forgotten";
}

TEST(LiveRun, HoldsTheCouplingToWhatTheFreeBodiesBear) {
  SettingsRequest wanted;
  wanted.stiffness = 500.0;
  wanted.physics_rate = 20.0;  // which every machine affords
  LiveRun run(scene("table.xml"), wanted);
  const double borne = coupling_limits_for_bodies(run.geometry(), 20.0).stiffness;
  EXPECT_LT(borne, 500.0);
  EXPECT_EQ(run.settings().stiffness, borne);
  const SessionSettings before = run.settings();
  EXPECT_THROW(run.set("stiffness", 1.01 * borne), InputError);
  EXPECT_THROW(run.set("damping", 100.0), InputError);
  EXPECT_EQ(run.settings().lines(), before.lines());
  run.set("physics_rate", 10.0);
  EXPECT_DOUBLE_EQ(run.settings().stiffness, borne / 4.0) << "lowered with the rate";
  run.set("physics_rate", 20.0);
  EXPECT_EQ(run.settings().stiffness, borne) << "what was asked for is not forgotten";
}

TEST(LiveRun, SettingsOfOneMethodComeBackWithIt) {
  LiveRun run(scene("table.xml"), {});
  run.set("friction", 0.25);
  run.set_method("paper");
  EXPECT_FALSE(run.settings().friction.has_value());
  run.set_method("proxy");
  EXPECT_EQ(run.settings().friction, 0.25);
  run.set("friction", std::nullopt);
  EXPECT_FALSE(run.settings().friction.has_value()) << "the scene's own";
  run.set("stiffness", 700.0);
  run.set("stiffness", std::nullopt);
  EXPECT_EQ(run.settings().stiffness, 500.0) << "the scene's own";
}

TEST(LiveRun, ShowsTheMovingBodies) {
  Steered steered(scene("table.xml"));
  steered.until([&] { return steered.run.bodies().steps > 20; });
  const MovingBodies& bodies = steered.run.bodies();
  EXPECT_EQ(bodies.count, steered.run.geometry().moving_count);
  for (const PlainPose& pose : bodies.used()) EXPECT_GT(pose.p.z, 0.40);
}

// A device somewhere else than the scene's tool, whose hand goes straight down, slowly, from when it is first read.
class SinkingDevice final : public HapticInterface {
 public:
  InterfaceCapability capability() const override {
    InterfaceCapability capability;
    capability.name = "sinking";
    capability.max_force = 3.0;
    capability.max_stiffness = 800.0;
    return capability;
  }
  InterfaceStatus read(double time, InterfaceState& state) noexcept override {
    if (fails) return InterfaceStatus::kLost;
    ++reads;
    state.time = time;
    state.X_WT = {Vector3(7.0, 7.0, 7.0 - 1e-5 * static_cast<double>(reads)), Quaternion::Identity()};
    state.V_WT.linear = Vector3(0.0, 0.0, -0.01);
    return InterfaceStatus::kOk;
  }
  InterfaceStatus write(const InterfaceCommand& command) noexcept override {
    commanded = command.wrench.force.norm();
    return InterfaceStatus::kOk;
  }

  std::atomic<long> reads{0};
  std::atomic<bool> fails{false};
  std::atomic<double> commanded{-1.0};
};

TEST(LiveRunOnADevice, HoldsTheToolWhereTheSceneHasItAndIsHeldToTheRating) {
  SinkingDevice device;
  SettingsRequest wanted;
  wanted.stiffness = 5000.0;
  Steered steered(scene("table.xml"), wanted, &device);
  const Vector3 start = steered.run.geometry().tool.X_WT.p;
  EXPECT_EQ(steered.run.settings().stiffness, 800.0);
  EXPECT_EQ(steered.run.interface().name, "sinking");
  EXPECT_TRUE(steered.run.has_device());
  steered.until([&] { return steered.ticks > 200; });
  const Vector3 moved = Vector3(steered.newest.X_WT.p) - start;
  EXPECT_NEAR(moved.x(), 0.0, 1e-9);
  EXPECT_NEAR(moved.z(), -1e-5 * static_cast<double>(steered.ticks), 2e-3);
  EXPECT_EQ(device.commanded, 0.0) << "the last command";
}

TEST(LiveRunOnADevice, IsMovedByNothingElse) {
  SinkingDevice device;
  LiveRun run(scene("table.xml"), {}, &device);
  EXPECT_THROW(run.guide(Pose{}), InputError);
  EXPECT_THROW(run.play(find_scripted_motion("press").motion(Vector3::UnitZ())), InputError);
  EXPECT_THROW(run.stop_motion(), InputError);
  EXPECT_FALSE(run.intended().has_value());
  EXPECT_FALSE(run.is_playing());
  EXPECT_THROW(LiveRun(live_scene_of(find_experiment("paper-cube")), {}, &device), InputError);
  const std::string message = live_scene_message(run, {});
  EXPECT_NE(message.find(R"("interface":"sinking")"), std::string::npos) << message;
  EXPECT_NE(message.find(R"("motions":[])"), std::string::npos);
  EXPECT_NE(message.find(R"("experiments":[])"), std::string::npos);
}

TEST(LiveRunOnADevice, PausedGoesOnReadingAndCommandsZero) {
  SinkingDevice device;
  Steered steered(scene("table.xml"), {}, &device);
  long paused_at = 0;
  steered.until([&] {
    if (paused_at == 0 && steered.ticks > 100) {
      steered.run.pause(true);
      paused_at = device.reads;
    }
    return paused_at > 0 && device.reads > paused_at + 200;
  });
  EXPECT_EQ(device.commanded, 0.0);
}

}  // namespace
}  // namespace tegotae
