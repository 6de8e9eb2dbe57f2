// SPDX-License-Identifier: Apache-2.0
#include <tegotae/math/rotation.hpp>
#include <tegotae/runtime/realtime_session.hpp>

#include <tests/free_body_world.hpp>

#include <gtest/gtest.h>
#include <pthread.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <fstream>
#include <mutex>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <vector>

namespace tegotae {
namespace {

// A hand that presses a cube on the floor and sways, at the loop's time.
class SwayingHand : public HapticInterface {
 public:
  InterfaceCapability capability() const override { return {}; }
  InterfaceStatus read(double time, InterfaceState& state) noexcept override {
    state = {};
    state.time = time;
    const double tilt = 0.02 * std::sin(9.0 * time);
    state.X_WT = {{0.01 * std::sin(3.0 * time), 0.0995 + 0.001 * std::sin(13.0 * time), 0.0},
                  rotation_from_vector({0.0, 0.0, tilt})};
    ++reads;
    return status;
  }
  InterfaceStatus write(const InterfaceCommand& command) noexcept override {
    last = command;
    strongest = std::max(strongest, command.wrench.force.norm());
    ++writes;
    newest = command.wrench.force.norm() + command.wrench.torque.norm();
    return status;
  }

  std::atomic<InterfaceStatus> status{InterfaceStatus::kOk};
  InterfaceCommand last;  // read after the run
  double strongest = 0.0;
  int reads = 0, writes = 0;
  std::atomic<double> newest{0.0};  // force and torque of the last command, while it runs
};

SceneGeometry scene_with_a_loose_block() {
  SceneGeometry scene = test::cube_over_floor();
  Body block;
  block.name = "block";
  block.pieces = {make_box(Vector3(0.02, 0.02, 0.02))};
  block.X_WB.p = Vector3(0.1205, 0.1, 0.0);
  block.moving_index = 0;
  scene.bodies.push_back(block);
  return scene;
}

struct RealtimeRig {
  explicit RealtimeRig(double physics_period = 0.01)
      : world(scene_with_a_loose_block(), 1000.0), physics(world, {physics_period, 0.005}, ModelNeeds{}) {
    const Tool& tool = world.geometry().tool;
    haptics = std::make_unique<HapticTick>(make_method("paper", {}, world.geometry()), tool, SafetyLimits{}, 1e-3);
  }

  RealtimeReport run(double duration, const RealtimeObserver& observer) {
    return run_realtime(physics, *haptics, hand, 1e-3, duration, stop, observer);
  }

  test::FreeBodyWorld world;
  PhysicsLoop physics;
  std::unique_ptr<HapticTick> haptics;
  SwayingHand hand;
  std::atomic<bool> stop{false};
};

// Ten seconds of two threads; what the sanitizers watch.
TEST(RealtimeSession, TwoThreadsRunAtTheirRatesAndTheLastCommandIsZero) {
  RealtimeRig rig;
  std::vector<TickRecord> records;
  const RealtimeReport report = rig.run(10.0, [&](const TickRecord& record) {
    records.push_back(record);
    return true;
  });
  EXPECT_EQ(report.haptics.count(), static_cast<std::uint64_t>(rig.hand.writes));
  EXPECT_EQ(records.size() + report.dropped_records, report.haptics.count());
  EXPECT_GT(records.size(), 100u);
  EXPECT_GT(rig.world.steps, 10);
  EXPECT_EQ(rig.hand.last.wrench.force.norm() + rig.hand.last.wrench.torque.norm(), 0.0);
  EXPECT_GT(rig.hand.strongest, 0.2) << "it pressed";
  EXPECT_EQ(report.physics_error, "");
  EXPECT_LT(rig.world.body(0).X_WB.p.norm(), 10.0) << "pushed, not shot away";
  for (size_t i = 1; i < records.size(); ++i) {
    ASSERT_GT(records[i].time, records[i - 1].time);
    ASSERT_GE(records[i].model_sequence, records[i - 1].model_sequence);
    ASSERT_TRUE(Vector3(records[i].displayed.force).allFinite());
  }
  EXPECT_GT(records.back().model_sequence, 10u);
}

// An interface that does not stand still with the run.
TEST(RealtimeSession, CommandsZeroToARealInterfaceWhilePaused) {
  RealtimeRig rig;
  LiveLink link;
  link.interface_waits = false;
  constexpr int kMostPasses = 6000;  // a failure then, not a hang
  int passes = 0, zeros = 0, others = 0;
  link.on_pass = [&] { rig.stop = ++passes > kMostPasses; };
  const auto observer = [&](const TickRecord& record) {
    const bool stopped = ((record.safety_events >> static_cast<unsigned>(SafetyEvent::kStopped)) & 1U) != 0;
    const double force = Vector3(record.displayed.force).norm();
    if (!link.paused && force > 0.2) link.pause(true);
    if (stopped && force == 0.0) ++zeros;
    if (stopped && force != 0.0) ++others;
    return zeros < 50;
  };
  run_realtime(rig.physics, *rig.haptics, rig.hand, 1e-3, 3600.0, rig.stop, observer, &link);
  EXPECT_TRUE(link.paused) << "it pressed";
  EXPECT_GE(zeros, 50);
  EXPECT_EQ(others, 0);
  EXPECT_EQ(rig.hand.last.wrench.force.norm(), 0.0);
}

TEST(RealtimeSession, TellsWhoWatchesOnceWhatTheSystemGranted) {
  RealtimeRig rig;
  LiveLink link;
  int told = 0;
  bool haptic_fifo = false;
  link.on_rights = [&](const RealtimeRights& haptics, const RealtimeRights&) {
    ++told;
    haptic_fifo = haptics.fifo;
  };
  const RealtimeReport report = run_realtime(
      rig.physics, *rig.haptics, rig.hand, 1e-3, 0.2, rig.stop, [](const TickRecord&) { return true; }, &link);
  EXPECT_EQ(told, 1);
  EXPECT_EQ(haptic_fifo, report.haptic_rights.fifo);
}

TEST(RealtimeSession, EndsWhenTheObserverSaysSo) {
  RealtimeRig rig;
  int seen = 0;
  rig.run(3600.0, [&](const TickRecord&) { return ++seen < 20; });
  EXPECT_GE(seen, 20);
}

TEST(RealtimeSession, EndsWhenStopped) {
  RealtimeRig rig;
  rig.stop = true;
  const RealtimeReport report = rig.run(3600.0, [](const TickRecord&) { return true; });
  EXPECT_GT(report.haptics.count(), 0u);
}

// A full disk or a terminal that stands still: the observer hangs, and the force must end all the same.
TEST(RealtimeSession, StoppedWhileTheObserverHangsTheHandIsToldZeroAtOnce) {
  RealtimeRig rig;
  bool hung = false;
  double commanded = -1.0;
  rig.run(100.0, [&](const TickRecord& record) {
    if (hung || rig.hand.newest < 0.1 || record.model_sequence == 0) return true;
    hung = true;
    rig.stop = true;
    for (int i = 0; i < 2000; ++i) std::this_thread::sleep_for(std::chrono::milliseconds(1));
    commanded = rig.hand.newest;
    return true;
  });
  EXPECT_TRUE(hung);
  EXPECT_EQ(commanded, 0.0) << "while it still hung";
}

TEST(RealtimeSession, AnObserverThatThrowsEndsTheRunWithAZeroCommand) {
  RealtimeRig rig;
  EXPECT_THROW(rig.run(3600.0, [](const TickRecord&) -> bool { throw std::runtime_error("disk full"); }),
               std::runtime_error);
  EXPECT_EQ(rig.hand.last.wrench.force.norm(), 0.0);
}

TEST(RealtimeSession, AnExceptionOfALinksCallbackEndsTheRunWithAZeroCommand) {
  for (const bool in_pass : {true, false}) {
    RealtimeRig rig;
    LiveLink link;
    int passes = 0;
    const auto fail = [] { throw std::runtime_error("the page is gone"); };
    if (in_pass)
      link.on_pass = [&] {
        if (++passes > 20) fail();
      };
    if (!in_pass) link.on_rights = [&](const RealtimeRights&, const RealtimeRights&) { fail(); };
    const auto observer = [](const TickRecord&) { return true; };
    EXPECT_THROW(run_realtime(rig.physics, *rig.haptics, rig.hand, 1e-3, 3600.0, rig.stop, observer, &link),
                 std::runtime_error);
    EXPECT_GT(rig.hand.writes, 0);
    EXPECT_EQ(rig.hand.last.wrench.force.norm(), 0.0);
  }
}

// A world whose first model cannot be made.
class UnreadableWorld : public test::FreeBodyWorld {
 public:
  using FreeBodyWorld::FreeBodyWorld;
  void read_bodies(std::span<BodyState>) const override { throw std::runtime_error("no bodies"); }
};

TEST(RealtimeSession, ARunThatCannotBeginSaysZeroAllTheSame) {
  UnreadableWorld world(test::cube_over_floor());
  PhysicsLoop physics(world, {0.01, 0.005}, ModelNeeds{});
  HapticTick haptics(make_method("paper", {}, world.geometry()), world.geometry().tool, SafetyLimits{}, 1e-3);
  SwayingHand hand;
  hand.last.wrench.force.x() = 1.0;
  const std::atomic<bool> stop{false};
  EXPECT_THROW(run_realtime(physics, haptics, hand, 1e-3, 1.0, stop, [](const TickRecord&) { return true; }),
               std::runtime_error);
  EXPECT_EQ(hand.writes, 1);
  EXPECT_EQ(hand.last.wrench.force.norm(), 0.0);
}

#if !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)

// This process may have `more` bytes of address space than it has now.
void limit_memory(std::size_t more) {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  const rlim_t most = pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) + more;
  const rlimit limit{most, most};
  setrlimit(RLIMIT_AS, &limit);
}

// In a child that has no memory for the stack of a thread.
TEST(RealtimeSession, AThreadThatCannotBeStartedLeavesZero) {
  const auto child_ends_with = [] {
    RealtimeRig rig;
    rig.hand.last.wrench.force.x() = 1.0;
    // Stacks larger than any that the process keeps for reuse, and than what it may still have.
    pthread_attr_t attributes;
    pthread_attr_init(&attributes);
    pthread_attr_setstacksize(&attributes, std::size_t{256} << 20U);
    pthread_setattr_default_np(&attributes);
    limit_memory(std::size_t{32} << 20U);
    try {
      rig.run(1.0, [](const TickRecord&) { return true; });
    } catch (const std::system_error&) {
      return rig.hand.last.wrench.force.norm() == 0.0 ? 0 : 1;
    } catch (...) {
      return 2;
    }
    return 3;
  };
  const pid_t child = fork();
  if (child == 0) _exit(child_ends_with());
  int status = 0;
  waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0);
}

#endif

// A world that fails after a few steps.
class ThrowingWorld : public test::FreeBodyWorld {
 public:
  using FreeBodyWorld::FreeBodyWorld;
  void advance(double duration, const ToolState& tool, std::span<const BodyImpulse> impulses) override {
    if (steps >= 3) throw std::runtime_error("the engine gave up");
    FreeBodyWorld::advance(duration, tool, impulses);
  }
};

TEST(RealtimeSession, WhenPhysicsFailsTheWrenchFadesAndTheReportSaysWhy) {
  ThrowingWorld world(test::cube_over_floor());
  PhysicsLoop physics(world, {0.01, 0.005}, ModelNeeds{});
  SafetyLimits limits;
  limits.max_model_age = 0.05;
  const Tool& tool = world.geometry().tool;
  HapticTick haptics(make_method("paper", {}, world.geometry()), tool, limits, 1e-3);
  SwayingHand hand;
  std::atomic<bool> stop{false};
  TickRecord last;
  const RealtimeReport report = run_realtime(physics, haptics, hand, 1e-3, 1.0, stop, [&](const TickRecord& record) {
    if (record.time < 0.99) last = record;
    return true;
  });
  EXPECT_EQ(report.physics_error, "the engine gave up");
  EXPECT_EQ(Vector3(last.displayed.force).norm(), 0.0);
  EXPECT_NE(last.safety_events, 0u);
}

TEST(RealtimeSession, WithALostInterfaceNothingIsCommanded) {
  RealtimeRig rig;
  rig.hand.status = InterfaceStatus::kLost;
  rig.run(0.5, [](const TickRecord&) { return true; });
  EXPECT_EQ(rig.hand.strongest, 0.0);
}

}  // namespace
}  // namespace tegotae
