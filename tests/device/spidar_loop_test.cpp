// SPDX-License-Identifier: Apache-2.0
// A SPIDAR on its owner's transport in the full loop: haptics at 1 kHz and physics, each on its thread, on the double
// of such a library.
#include <tegotae/device/spidar_transport.h>
#include <tegotae/device/interface_drivers.hpp>
#include <tegotae/runtime/realtime_session.hpp>
#include <tegotae/runtime/safety_limits.hpp>

#include <tests/device/driver_program.hpp>
#include <tests/device/spidar_double.hpp>
#include <tests/device/waiting.hpp>
#include <tests/free_body_world.hpp>

#include <gtest/gtest.h>

#include <atomic>
#include <functional>
#include <memory>

namespace tegotae {
namespace {

using test::comes_true;
using test::HoldingProbe;
using test::on_spidar_double;
using test::run_probe;
using test::SpidarDoubleFile;

// A cube 2 mm over a floor; the grip holds it from where it is calibrated. The hand means to be 8 mm lower. y is up.
class SpidarLoop : public ::testing::Test {
 protected:
  static constexpr double kPeriod = 1e-3;       // s
  static constexpr double kStiffness = 1000.0;  // N/m
  static constexpr double kMetricLength = 0.1;  // m
  static constexpr double kLongest = 60.0;      // s, for a machine as slow as may be
  // What the motors display where they only keep the strings taut: least tensions balance in the middle alone.
  static constexpr double kTaut = 0.5;  // N

  SpidarLoop() {
    spidar->hand_stiffness = 400.0;
    spidar->mass = 0.5;
    spidar->inertia = 5e-3;
    spidar->hand_rotational_stiffness = 20.0;
    spidar->hand_rotational_damping = 0.3;
    interface = spidar_driver().open(on_spidar_double(",axes=xz-y"));
    WorkspaceSettings workspace;
    workspace.from_first_pose = true;
    limits = safety_limits(interface->capability(), kStiffness, kMetricLength, 0.01);
    MethodSettings settings;
    settings.stiffness = kStiffness;
    settings.metric_length = kMetricLength;
    haptics = std::make_unique<HapticTick>(make_method("paper", settings, world.geometry()), world.geometry().tool,
                                           limits, kPeriod, workspace);
  }

  static SceneGeometry scene() {
    SceneGeometry result = test::cube_over_floor();
    result.tool.X_WT.p.y() = 0.102;
    return result;
  }
  static bool is_told(const TickRecord& record, SafetyEvent event) {
    return ((record.safety_events >> static_cast<unsigned>(event)) & 1U) != 0;
  }
  // In S, where z is up.
  void lift() {
    spidar.move_hand({});
    is_lifted = true;
  }
  // Nothing is felt before the hand has been where the tool is free: then it presses. On a busy machine a tick may come
  // late, which ends the press; then it is begun again.
  void press(const TickRecord& record) {
    if (!is_lifted && is_told(record, SafetyEvent::kWaiting)) lift();
    if (!is_lifted || !is_told(record, SafetyEvent::kRamping)) return;
    spidar.move_hand({{0.0, 0.0, -0.01}, Quaternion::Identity()});
    is_lifted = false;
  }
  RealtimeReport run(const std::function<bool(const TickRecord&)>& observer) {
    return run_realtime(physics, *haptics, *interface, kPeriod, kLongest, stop, observer);
  }
  bool pushes() const { return spidar.displayed().force.z() > 1.5; }

  SpidarDoubleFile spidar;
  test::FreeBodyWorld world{scene()};
  PhysicsLoop physics{world, {0.01, 0.005}, ModelNeeds{}};
  SafetyLimits limits;
  std::unique_ptr<HapticInterface> interface;
  std::unique_ptr<HapticTick> haptics;
  std::atomic<bool> stop{false};
  bool is_lifted = true;
};

TEST_F(SpidarLoop, DisplaysContactIsUnpluggedComesBackAndEndsAtZero) {
  enum { kFirst, kGone, kBack, kDone } phase = kFirst;
  double strongest_while_gone = 0.0;
  const RealtimeReport report = run([&](const TickRecord& record) {
    if (phase != kGone) press(record);
    if (phase == kFirst && pushes()) {
      spidar.unplug();
      phase = kGone;
    } else if (phase == kGone) {
      strongest_while_gone = std::max(strongest_while_gone, spidar.displayed().force.norm());
      if (spidar->refused_opens > 0) {
        lift();
        spidar.plug_in();
        phase = kBack;
      }
    } else if (phase == kBack && pushes()) {
      phase = kDone;
    }
    return phase != kDone;
  });
  EXPECT_EQ(phase, kDone);
  EXPECT_EQ(spidar->opens, 2U);
  EXPECT_EQ(spidar->calibrations, 1U) << "where the hand holds it then nobody knows";
  EXPECT_EQ(strongest_while_gone, 0.0);
  EXPECT_LT(spidar.commanded().force.norm(), kTaut);
  EXPECT_EQ(spidar->bad_commands, 0U);
  EXPECT_LE(spidar->largest_force, limits.max_force + kTaut);
  EXPECT_LE(spidar->largest_torque, limits.max_torque + 0.05);
  EXPECT_LE(spidar->largest_force_growth, limits.force_rate * kPeriod + kTaut);
  EXPECT_GT(report.haptics.count(), 100U);
  interface.reset();
  EXPECT_EQ(spidar.greatest_tension(), 0.0);
}

TEST_F(SpidarLoop, CallsThatFailNowAndThenNeverStrikeTheHand) {
  enum { kPress, kFailing, kAgain, kDone } phase = kPress;
  constexpr std::uint64_t kCalls = 4;  // a tick at most
  std::uint64_t ticks = 0, first = 0;
  double strongest_while_failing = 0.0;
  run([&](const TickRecord& record) {
    if (phase == kPress || phase == kAgain) press(record);
    if (phase == kPress && pushes()) {
      phase = kFailing;
      spidar->fail_every = 97;
      first = spidar->failed_calls;
    } else if (phase == kFailing && spidar->failed_calls > first + kCalls) {
      strongest_while_failing = std::max(strongest_while_failing, spidar.displayed().force.norm());
      if (++ticks == 500) {
        spidar->fail_every = 0;
        phase = kAgain;
      }
    } else if (phase == kAgain && pushes()) {
      phase = kDone;
    }
    return phase != kDone;
  });
  EXPECT_EQ(phase, kDone);
  EXPECT_GT(spidar->failed_calls, first + 10U);
  EXPECT_EQ(spidar->opens, 1U);
  EXPECT_LT(strongest_while_failing, kTaut);
  EXPECT_LE(spidar->largest_force_growth, limits.force_rate * kPeriod + kTaut);
}

TEST_F(SpidarLoop, AReadingThatIsOldLetsGoOfTheHand) {
  enum { kPress, kOld, kDone } phase = kPress;
  run([&](const TickRecord& record) {
    if (phase == kPress) press(record);
    if (phase == kPress && pushes()) {
      spidar->reading_age = 100'000'000;
      phase = kOld;
    } else if (phase == kOld && spidar.displayed().force.norm() < kTaut) {
      phase = kDone;
    }
    return phase != kDone;
  });
  EXPECT_EQ(phase, kDone);
}

// What the guard relies on, where the library lets another process stop the motors once the first is dead.
TEST(SpidarProcess, KilledItLeavesItsTensionsUntilSomebodyStopsThem) {
  const SpidarDoubleFile spidar;
  HoldingProbe probe("", "spidar-g6", on_spidar_double());
  ASSERT_TRUE(comes_true([&] { return spidar.displayed().force.z() > 1.9 || !probe.is_running(); }));
  const std::string options = on_spidar_double();
  EXPECT_FALSE(spidar_driver().silence(options)) << "it lives";
  probe.kill_it();
  EXPECT_GT(spidar.displayed().force.z(), 1.9);
  spidar->sharing = TEGOTAE_SPIDAR_NEVER;
  EXPECT_FALSE(spidar_driver().silence(options));
  EXPECT_GT(spidar.displayed().force.z(), 1.9);
  spidar->sharing = TEGOTAE_SPIDAR_AFTER_DEATH;
  EXPECT_TRUE(spidar_driver().silence(options));
  EXPECT_EQ(spidar.greatest_tension(), 0.0);
  EXPECT_EQ(spidar->opener, 0);
  spidar.unplug();
  EXPECT_FALSE(spidar_driver().silence(options));
}

TEST(SpidarProcess, SaysWhatIsFound) {
  const SpidarDoubleFile spidar;
  const auto found = run_probe("", "find spidar-g6 " + on_spidar_double());
  EXPECT_NE(found.text.find("device 'spidar-g6:x3r,hold=0,transport="), std::string::npos) << found.text;
  const auto missing = run_probe("", "open spidar-g6 x3r,transport=libmyboard.so");
  EXPECT_EQ(missing.exit_code, 1);
  EXPECT_NE(missing.text.find("was not found (looked for libmyboard.so)"), std::string::npos) << missing.text;
}

}  // namespace
}  // namespace tegotae
