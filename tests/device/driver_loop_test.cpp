// SPDX-License-Identifier: Apache-2.0
// Drivers in the full loop: haptics at 1 kHz and physics, each on its thread,
// on the doubles of the makers' libraries.
#include <tegotae/device/interface_drivers.hpp>
#include <tegotae/runtime/realtime_session.hpp>
#include <tegotae/runtime/safety_limits.hpp>

#include <tests/doubles/double_state_file.hpp>
#include <tests/free_body_world.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <ostream>
#include <string>

namespace tegotae {
namespace {

using test::DoubleStateFile;

struct DriverCase {
  const char* driver;
  const char* options;
  const char* model;  // what the double answers to
};

void PrintTo(const DriverCase& each, std::ostream* out) { *out << each.driver; }

// A cube over a floor whose top is y = 0, held by a hand that means to be 10 mm
// in it.
class DriverLoop : public ::testing::TestWithParam<DriverCase> {
 protected:
  static constexpr double kPeriod = 1e-3;       // s
  static constexpr double kStiffness = 1000.0;  // N/m
  static constexpr double kMetricLength = 0.1;  // m
  static constexpr double kLongest = 60.0;      // s, for a machine as slow as may be

  // Nothing is felt before the hand has been where the tool is free: then it
  // presses.
  void lift() {
    device.move_hand(kAboveTheFloor);
    is_lifted = true;
  }
  void press_once_free(const TickRecord& record) {
    if (!is_lifted || !is_told(record, SafetyEvent::kRamping)) return;
    device.move_hand(in_the_floor);
    is_lifted = false;
  }
  static bool is_told(const TickRecord& record, SafetyEvent event) {
    return ((record.safety_events >> static_cast<unsigned>(event)) & 1U) != 0;
  }

  const Pose kAboveTheFloor{{0.0, 0.102, 0.0}, Quaternion::Identity()};
  Pose in_the_floor{{0.0, 0.09, 0.0}, Quaternion::Identity()};

  DriverLoop() {
    device->max_force.store(12.0);
    device->mass.store(0.5);
    device->inertia.store(5e-3);
    device->hand_stiffness.store(400.0);
    device.place(kAboveTheFloor);
    lift();
  }
  void SetUp() override {
    ASSERT_THAT(driver.find().library, ::testing::StartsWith(TEGOTAE_DOUBLES)) << "this would drive a real device";
    interface = driver.open(GetParam().options);
    MethodSettings settings;
    settings.stiffness = kStiffness;
    settings.metric_length = kMetricLength;
    limits = safety_limits(interface->capability(), kStiffness, kMetricLength, 0.01);
    haptics = std::make_unique<HapticTick>(make_method("paper", settings, world.geometry()), world.geometry().tool,
                                           limits, kPeriod);
  }

  RealtimeReport run(const RealtimeObserver& observer) {
    return run_realtime(physics, *haptics, *interface, kPeriod, kLongest, stop, [&](const TickRecord& record) {
      press_once_free(record);
      return observer(record);
    });
  }
  bool pushes() const { return device.displayed().force.y() > 0.5; }

  // Of the commands kept, the one that grew most beyond what was commanded
  // before, N: its distance from the segment between zero and that.
  double largest_growth() const {
    const std::uint64_t count = device->command_count.load();
    const std::uint64_t first = count > test::DoubleState::kCommands ? count - test::DoubleState::kCommands : 0;
    double largest = 0.0;
    Vector3 before = force(first);
    for (std::uint64_t i = first + 1; i < count; ++i) {
      const Vector3 now = force(i);
      const double square = before.squaredNorm();
      const double along = square > 0.0 ? std::clamp(now.dot(before) / square, 0.0, 1.0) : 0.0;
      largest = std::max(largest, (now - along * before).norm());
      before = now;
    }
    return largest;
  }
  Vector3 force(std::uint64_t command) const {
    const auto& values = device->commands[command % test::DoubleState::kCommands].force;
    return {values[0].load(), values[1].load(), values[2].load()};
  }

  const InterfaceDriver& driver = find_interface_driver(GetParam().driver);
  DoubleStateFile device{GetParam().model};
  test::FreeBodyWorld world{test::cube_over_floor()};
  PhysicsLoop physics{world, {0.01, 0.005}, ModelNeeds{}};
  SafetyLimits limits;
  std::unique_ptr<HapticInterface> interface;
  std::unique_ptr<HapticTick> haptics;
  std::atomic<bool> stop{false};
  bool is_lifted = true;
};

TEST_P(DriverLoop, DisplaysContactIsUnpluggedComesBackAndEndsAtZero) {
  enum { kFirst, kGone, kBack, kDone } phase = kFirst;
  double strongest_while_gone = 0.0;
  const RealtimeReport report = run([&](const TickRecord& record) {
    // On a busy machine a tick may come late, which ends the press.
    if (phase != kGone && !is_lifted && is_told(record, SafetyEvent::kWaiting)) lift();
    if (phase == kFirst && pushes()) {
      device.unplug();
      phase = kGone;
    } else if (phase == kGone) {
      strongest_while_gone = std::max(strongest_while_gone, device.displayed().force.norm());
      if (device->refused_opens.load() > 0) {
        lift();
        device.plug_in();
        phase = kBack;
      }
    } else if (phase == kBack && pushes()) {
      phase = kDone;
    }
    return phase != kDone;
  });
  EXPECT_EQ(phase, kDone);
  EXPECT_EQ(device->opens.load(), 2u);
  EXPECT_EQ(strongest_while_gone, 0.0);
  EXPECT_EQ(device.commanded().force.norm(), 0.0);
  EXPECT_EQ(device.commanded().torque.norm(), 0.0);
  EXPECT_EQ(device->bad_commands.load(), 0u);
  // Rounding of single precision, in which some makers' libraries speak.
  constexpr double kSlack = 1e-5;
  EXPECT_LE(device->largest_force.load(), limits.max_force + kSlack);
  EXPECT_LE(device->largest_torque.load(), limits.max_torque + kSlack);
  EXPECT_LE(device->largest_force_growth.load(), limits.force_rate * kPeriod + kSlack);
  EXPECT_LE(device->largest_torque_growth.load(), limits.torque_rate * kPeriod + kSlack);
  EXPECT_GT(report.haptics.count(), 100u);
}

// Pressed with more than four ticks' growth when the failures begin: a force
// that came back at once would be a blow.
TEST_P(DriverLoop, CallsThatFailNowAndThenNeverStrikeTheHand) {
  in_the_floor.p.y() = 0.06;
  const double strong = 4.0 * limits.force_rate * kPeriod;  // N
  ASSERT_LT(strong, limits.max_force);
  enum { kPress, kFailing, kAgain, kDone } phase = kPress;
  constexpr std::uint64_t kCalls = 4;  // a tick at most
  std::uint64_t ticks = 0, first = 0;
  double strongest_while_failing = 0.0;
  run([&](const TickRecord& record) {
    // On a busy machine a tick may come late, which ends the press.
    const bool must_press = phase == kPress || phase == kAgain;
    if (must_press && !is_lifted && is_told(record, SafetyEvent::kWaiting)) lift();
    const bool is_strong = device.displayed().force.norm() > strong;
    if (phase == kPress && is_strong) {
      phase = kFailing;
      device->fail_every.store(97);
      first = device->failed_calls.load();
    } else if (phase == kFailing && device->failed_calls.load() > first + kCalls) {
      // Each call of a tick has failed once (not each loses the tick: a velocity is replaced), so zero was commanded,
      // and the hand presses still.
      strongest_while_failing = std::max(strongest_while_failing, device.displayed().force.norm());
      if (++ticks == 500) {
        device->fail_every.store(0);
        phase = kAgain;
      }
    } else if (phase == kAgain && is_strong) {
      phase = kDone;
    }
    return phase != kDone;
  });
  EXPECT_EQ(phase, kDone);
  EXPECT_GT(device->failed_calls.load(), first + 10u);
  EXPECT_EQ(device->opens.load(), 1u);
  EXPECT_EQ(strongest_while_failing, 0.0);
  EXPECT_GT(device->largest_force.load(), strong);
  EXPECT_LE(device->largest_force.load(), limits.max_force + 1e-5);
  EXPECT_LE(largest_growth(), limits.force_rate * kPeriod + 1e-5);
}

TEST_P(DriverLoop, ClosingAfterCallsThatFailedEndsAtZero) {
  device->fail_every.store(97);
  std::uint64_t ticks = 0;
  run([&](const TickRecord&) { return ++ticks < 300; });
  EXPECT_GT(device->failed_calls.load(), 5u);
  // The last command may have been the one that fails: closing says zero again.
  device->fail_every.store(0);
  interface.reset();
  EXPECT_EQ(device.commanded().force.norm(), 0.0);
  EXPECT_FALSE(device->forces_on.load());
}

INSTANTIATE_TEST_SUITE_P(Drivers, DriverLoop,
                         ::testing::Values(DriverCase{"force-dimension", "", "sigma.7"},
                                           DriverCase{"virtuose", "arm", "arm"}),
                         [](const auto& each) {
                           std::string name = each.param.driver;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace tegotae
