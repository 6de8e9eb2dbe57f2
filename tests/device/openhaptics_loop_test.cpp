// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/openhaptics.hpp>
#include <tegotae/runtime/realtime_session.hpp>

#include <tests/device/waiting.hpp>
#include <tests/doubles/double_state_file.hpp>
#include <tests/free_body_world.hpp>

#include <gtest/gtest.h>

#include <atomic>
#include <functional>
#include <memory>

namespace tegotae {
namespace {

using test::DoubleStateFile;

// A cube in a Touch, pressed on a floor by the hand that holds it; both loops in real time at 1 kHz, the maker's servo
// loop at its own rate. y is up, which is the device's x.
class OpenHapticsLoop {
 public:
  explicit OpenHapticsLoop(double servo_rate) {
    state->degrees = 3;
    state->max_force = 3.3;
    state->servo_rate = servo_rate;
    state.place({{0.12, 0.0, 0.0}, Quaternion::Identity()});
    lift();
  }

  // Until `ends`, asked at every tick, or for a minute.
  RealtimeReport run(const std::function<bool()>& ends) {
    const auto interface = openhaptics_driver().open("");
    test::FreeBodyWorld world(test::cube_over_floor(), 1000.0);
    PhysicsLoop physics(world, {0.01, 0.005}, ModelNeeds{});
    const InterfaceCapability capability = interface->capability();
    const SafetyLimits limits = safety_limits(capability, 1000.0, 0.1, 0.01);
    HapticTick haptics(make_method("paper", {}, world.geometry()), world.geometry().tool, limits, 1e-3);
    const std::atomic<bool> stop{false};
    return run_realtime(physics, haptics, *interface, 1e-3, 60.0, stop, [&](const TickRecord& record) {
      greatest = std::max(greatest, record.displayed.force.vector().norm());
      const auto is_told = [&](SafetyEvent event) {
        return ((record.safety_events >> static_cast<unsigned>(event)) & 1U) != 0;
      };
      // Nothing is felt before the hand has been where the tool is free; nor again, where a busy machine kept the servo
      // loop from its callbacks, so that the pose grew old or the command was taken back.
      if (is_lifted && is_told(SafetyEvent::kRamping)) press();
      if (!is_lifted && is_told(SafetyEvent::kWaiting)) lift();
      return !ends();
    });
  }
  bool pushes() const { return state.displayed().force.x() > 0.5; }

  DoubleStateFile state{"Touch"};
  void lift() {
    state.move_hand({{0.12, 0.0, 0.0}, Quaternion::Identity()});
    is_lifted = true;
  }
  void press() {
    state.move_hand({{0.09, 0.0, 0.0}, Quaternion::Identity()});
    is_lifted = false;
  }

  double greatest = 0.0;  // N, commanded
  bool is_lifted = true;
};

TEST(OpenHapticsLoopTest, DisplaysAContactAtTheRatesOfItsServoLoop) {
  for (const double rate : {1000.0, 500.0, 1600.0}) {
    OpenHapticsLoop loop(rate);
    int ticks_in_contact = 0;
    const RealtimeReport report = loop.run([&] { return loop.pushes() && ++ticks_in_contact > 300; });
    EXPECT_GT(ticks_in_contact, 300) << rate;
    EXPECT_GT(report.haptics.count(), 300U);
    EXPECT_LE(loop.greatest, 3.3 + 1e-9);
    EXPECT_LE(loop.state->largest_force, 3.3 + 1e-9);
    EXPECT_EQ(loop.state->largest_torque, 0.0) << "it has no motors for that";
    EXPECT_EQ(loop.state.displayed().force.norm(), 0.0) << "in the end";
    EXPECT_EQ(loop.state->bad_commands, 0U);
    EXPECT_EQ(loop.state->opens, loop.state->closes);
  }
}

TEST(OpenHapticsLoopTest, IsUnpluggedAndPluggedInWhileItRuns) {
  OpenHapticsLoop loop(1000.0);
  enum class Stage { kContact, kGone, kBack } stage = Stage::kContact;
  loop.run([&] {
    if (stage == Stage::kContact && loop.pushes()) {
      loop.state.unplug();
      stage = Stage::kGone;
    } else if (stage == Stage::kGone && loop.state->refused_opens > 0) {
      loop.lift();
      loop.state.plug_in();
      stage = Stage::kBack;
    }
    return stage == Stage::kBack && loop.pushes();
  });
  EXPECT_EQ(stage, Stage::kBack);
  EXPECT_EQ(loop.state->opens, 2U);
  EXPECT_LE(loop.state->largest_force, 3.3 + 1e-9);
  EXPECT_EQ(loop.state.displayed().force.norm(), 0.0) << "in the end";
}

}  // namespace
}  // namespace tegotae
