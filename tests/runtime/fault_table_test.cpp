// SPDX-License-Identifier: Apache-2.0
#include <tegotae/runtime/haptic_tick.hpp>
#include <tegotae/runtime/physics_loop.hpp>

#include <tests/free_body_world.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>

// What the hand is told while things go wrong under a steady press of 5 N: in simulated time, a line a fault.
namespace tegotae {
namespace {

constexpr double kPeriod = 1e-3;           // s
constexpr double kPhysicsPeriod = 0.01;    // s
constexpr double kFeltStiffness = 1000.0;  // N/m
constexpr double kDepth = 5e-3;            // m of the press
constexpr double kFault = 4.0;             // s
constexpr double kEnd = 12.0;              // s
constexpr double kClear = 8.0;             // s, from when on the hand is above the floor
constexpr double kAgain = 9.0;             // s, from when on it presses again

class FailingWorld : public test::FreeBodyWorld {
 public:
  FailingWorld() : FreeBodyWorld(test::cube_over_floor()) {}
  void advance(double duration, const ToolState& tool, std::span<const BodyImpulse> impulses) override {
    if (fails) throw std::runtime_error("the engine gave up");
    FreeBodyWorld::advance(duration, tool, impulses);
  }
  bool fails = false;
};

// What a fault may change in a tick.
struct Moment {
  double time = 0.0;
  InterfaceState state;
  HapticTick::Circumstances circumstances;
  bool physics_stalls = false;
  bool tick_missed = false;
};

struct Outcome {
  double force = 0.0, torque = 0.0;                             // N, N m: greatest, from the fault on
  double force_growth = 0.0, torque_growth = 0.0;               // of a tick, in all the run
  double before = 0.0;                                          // N, displayed when it came
  double zero_after = std::numeric_limits<double>::infinity();  // s from the fault to the first zero
  double growth_after = 0.0;                                    // N, of a tick within a second from the fault
  double in_the_end = 0.0;                                      // N
};

class FaultTable : public ::testing::Test {
 protected:
  explicit FaultTable() {
    InterfaceCapability capability;
    capability.max_force = 10.0;
    capability.max_torque = 0.4;
    limits = safety_limits(capability, kFeltStiffness, length(), kPhysicsPeriod);
    use("proxy");
  }

  double length() const { return world.geometry().tool.mass.gyration_length(); }
  RenderingMethod method(const char* name, double stiffness) const {
    MethodSettings settings;
    settings.stiffness = stiffness;
    settings.metric_length = length();
    return make_method(name, settings, world.geometry());
  }
  void use(const char* name) {
    haptics =
        std::make_unique<HapticTick>(method(name, kFeltStiffness), world.geometry().tool, limits, kPeriod, workspace);
    physics = std::make_unique<PhysicsLoop>(world, PhysicsLoop::Settings{kPhysicsPeriod, 0.005},
                                            needs_of(method(name, kFeltStiffness)));
  }

  // From above the floor into it; kept until it lifts off, and pressed again.
  static double height(double time) {
    const auto ease = [](double t) { return 0.5 - 0.5 * std::cos(M_PI * std::clamp(t, 0.0, 1.0)); };
    const double pressed = ease((time - 2.5) / 0.5) - ease((time - kClear + 0.5) / 0.5) + ease((time - kAgain) / 0.5);
    return 0.1 + 2e-3 - (kDepth + 2e-3) * pressed;
  }

  // The physics of this tick, as a thread of its own would make it: none where it stalls or has died.
  const IntermediateRepresentation* step_physics(const Moment& moment) {
    if (physics_died || moment.physics_stalls || moment.time + 1e-9 < next_step) return nullptr;
    while (next_step <= moment.time + 1e-9) next_step += kPhysicsPeriod;
    try {
      std::swap(ready, pending);
      physics->step(moment.time, *message, *pending);
    } catch (const std::runtime_error&) {
      physics_died = true;
    }
    return physics_died ? nullptr : ready.get();
  }

  Outcome run(const std::function<void(Moment&)>& fault) {
    Outcome outcome;
    Wrench before;
    for (long tick = 0; static_cast<double>(tick) * kPeriod < kEnd; ++tick) {
      Moment moment;
      moment.time = static_cast<double>(tick) * kPeriod;
      moment.state.X_WT.p.y() = height(moment.time);
      moment.state.buttons = buttons;
      if (moment.time >= kFault - 1e-9) fault(moment);
      moment.state.time = moment.time;
      if (tick == 0) begin(moment.state);
      const IntermediateRepresentation* fresh = step_physics(moment);
      if (moment.tick_missed) continue;
      const Wrench now = (*haptics)(moment.state, fresh, moment.circumstances, record).wrench;
      haptics->fill(*message, 0);
      note(moment.time, before, now, outcome);
      before = now;
    }
    outcome.in_the_end = before.force.norm();
    return outcome;
  }

  void begin(const InterfaceState& state) {
    const ToolState tool = haptics->begin(state, false);
    message->X_WT = tool.X_WT;
    message->X_WP = tool.X_WP;
    physics->build(-kPhysicsPeriod, tool, *pending);
  }

  static void note(double time, const Wrench& before, const Wrench& now, Outcome& outcome) {
    outcome.force_growth = std::max(outcome.force_growth, now.force.norm() - before.force.norm());
    outcome.torque_growth = std::max(outcome.torque_growth, now.torque.norm() - before.torque.norm());
    if (time < kFault - 1e-9) {
      outcome.before = now.force.norm();
      return;
    }
    if (time < kFault + 1.0) {
      outcome.growth_after = std::max(outcome.growth_after, now.force.norm() - before.force.norm());
    }
    outcome.force = std::max(outcome.force, now.force.norm());
    outcome.torque = std::max(outcome.torque, now.torque.norm());
    const bool is_zero = now.force.norm() == 0.0 && now.torque.norm() == 0.0;
    if (is_zero && time < kClear - 0.5) outcome.zero_after = std::min(outcome.zero_after, time - kFault);
  }

  // Prints the line and asserts what no fault may break, and that zero is reached in `zero_within` (s).
  void expect_safe(const char* fault, const Outcome& outcome, double zero_within) const {
    std::printf("| %-36s | %5.2f | %6.4f | %6.3f of %5.2f | %7.4f of %6.3f | %4.0f |\n", fault, outcome.force,
                outcome.torque, outcome.force_growth, limits.force_rate * kPeriod, outcome.torque_growth,
                limits.torque_rate * kPeriod, 1e3 * outcome.zero_after);
    EXPECT_LE(outcome.force, limits.max_force);
    EXPECT_LE(outcome.torque, limits.max_torque);
    EXPECT_LE(outcome.force_growth, limits.force_rate * kPeriod * (1.0 + 1e-9));
    EXPECT_LE(outcome.torque_growth, limits.torque_rate * kPeriod * (1.0 + 1e-9));
    EXPECT_TRUE(std::isinf(zero_within) || outcome.zero_after <= zero_within + 1e-9) << outcome.zero_after;
  }
  // It pressed when the fault came, and the hand that comes back is served again.
  static void expect_recovers(const Outcome& outcome) {
    EXPECT_NEAR(outcome.before, kFeltStiffness * kDepth, 0.1);
    EXPECT_NEAR(outcome.in_the_end, kFeltStiffness * kDepth, 0.1);
  }

  FailingWorld world;
  SafetyLimits limits;
  WorkspaceSettings workspace;
  std::unique_ptr<PhysicsLoop> physics;
  std::unique_ptr<HapticTick> haptics;
  std::unique_ptr<IntermediateRepresentation> ready = std::make_unique<IntermediateRepresentation>(),
                                              pending = std::make_unique<IntermediateRepresentation>();
  std::unique_ptr<ImpulseSums> message = std::make_unique<ImpulseSums>();
  TickRecord record;
  std::uint32_t buttons = 0;  // held down but for what the fault does
  double next_step = 0.0;
  bool physics_died = false;
};

bool during(const Moment& moment, double duration) { return moment.time < kFault + duration - 1e-9; }

constexpr double kAtOnce = 0.0;  // in the tick that meets the fault

TEST_F(FaultTable, Nothing) {
  const Outcome outcome = run([](Moment&) {});
  expect_safe("nothing", outcome, std::numeric_limits<double>::infinity());
  expect_recovers(outcome);
  EXPECT_TRUE(std::isinf(outcome.zero_after));
}

TEST_F(FaultTable, PoseNotANumber) {
  const Outcome outcome = run([](Moment& moment) {
    if (during(moment, 1.0)) moment.state.X_WT.p.y() = std::nan("");
  });
  expect_safe("pose NaN for 1 s", outcome, kAtOnce);
  expect_recovers(outcome);
}

TEST_F(FaultTable, PoseNotANumberForOneTick) {
  const Outcome outcome = run([](Moment& moment) {
    if (during(moment, kPeriod)) moment.state.X_WT.q.w() = std::nan("");
  });
  expect_safe("pose NaN for one tick", outcome, kAtOnce);
  expect_recovers(outcome);
}

TEST_F(FaultTable, PoseFrozenThatSaysSo) {
  const Outcome outcome = run([](Moment& moment) {
    if (during(moment, 1.0)) moment.circumstances.pose_age = moment.time - kFault;
  });
  expect_safe("pose frozen for 1 s, with its time", outcome, limits.max_pose_age + limits.fade_time + kPeriod);
  expect_recovers(outcome);
}

TEST_F(FaultTable, PoseFrozenThatDoesNotSaySo) {
  // Nothing tells it from a hand that rests; nothing but what the hand pressed last is displayed.
  const Outcome outcome = run([](Moment& moment) {
    if (during(moment, 1.0)) moment.state.X_WT.p.y() = height(kFault);
  });
  expect_safe("pose frozen for 1 s, without it", outcome, std::numeric_limits<double>::infinity());
  expect_recovers(outcome);
  EXPECT_LE(outcome.force, kFeltStiffness * kDepth + 0.1);
}

TEST_F(FaultTable, PoseLeapsIntoTheFloor) {
  const Outcome outcome = run([](Moment& moment) {
    if (during(moment, 1.0)) moment.state.X_WT.p.y() -= 0.2;
  });
  expect_safe("pose leaps 0.2 m down, for 1 s", outcome, kAtOnce);
  expect_recovers(outcome);
}

TEST_F(FaultTable, PoseLeapsAside) {
  const Outcome outcome = run([](Moment& moment) {
    if (during(moment, 1.0)) moment.state.X_WT.p.x() += 0.2;
  });
  expect_safe("pose leaps 0.2 m aside, for 1 s", outcome, kAtOnce);
  expect_recovers(outcome);
}

TEST_F(FaultTable, PoseLeapsForOneReading) {
  const Outcome outcome = run([](Moment& moment) {
    if (during(moment, kPeriod)) moment.state.X_WT.p.y() -= 0.2;
  });
  expect_safe("pose leaps 0.2 m down, one tick", outcome, kAtOnce);
  expect_recovers(outcome);
}

TEST_F(FaultTable, PoseLeapsAsideAndTurnsForAMoment) {
  const Outcome outcome = run([](Moment& moment) {
    if (!during(moment, 0.02)) return;
    moment.state.X_WT.p += Vector3(0.2, -0.2, 0.0);
    moment.state.X_WT.q = Quaternion(0.0, 1.0, 0.0, 0.0);
  });
  expect_safe("pose leaps and turns, for 20 ms", outcome, kAtOnce);
  expect_recovers(outcome);
}

TEST_F(FaultTable, PhysicsStalls) {
  const Outcome outcome = run([](Moment& moment) { moment.physics_stalls = during(moment, 2.0); });
  expect_safe("physics stalled 2 s", outcome, limits.max_model_age + limits.fade_time + kPeriod);
  expect_recovers(outcome);
}

TEST_F(FaultTable, PhysicsDies) {
  const Outcome outcome = run([this](Moment&) { world.fails = true; });
  expect_safe("physics thread ended by an exception", outcome, limits.max_model_age + limits.fade_time + kPeriod);
  EXPECT_TRUE(physics_died);
  EXPECT_EQ(outcome.in_the_end, 0.0);
}

TEST_F(FaultTable, InterfaceLostAndBack) {
  const Outcome outcome = run([](Moment& moment) { moment.circumstances.interface_lost = during(moment, 1.0); });
  expect_safe("interface unplugged 1 s", outcome, kAtOnce);
  expect_recovers(outcome);
}

TEST_F(FaultTable, InterfaceBackElsewhere) {
  const Outcome outcome = run([](Moment& moment) {
    moment.circumstances.interface_lost = during(moment, 1.0);
    if (!during(moment, 1.0) && during(moment, 3.0)) moment.state.X_WT.p.y() -= 0.1;
  });
  expect_safe("interface back 0.1 m deeper", outcome, kAtOnce);
  expect_recovers(outcome);
}

TEST_F(FaultTable, InterfaceLostNowAndThen) {
  const Outcome outcome = run([](Moment& moment) {
    moment.circumstances.interface_lost = during(moment, 3.0) && std::lround(moment.time / kPeriod) % 97 == 0;
  });
  expect_safe("one reading in 97 fails", outcome, 0.1);
  expect_recovers(outcome);
}

TEST_F(FaultTable, TickOverrun) {
  const Outcome outcome = run([](Moment& moment) { moment.tick_missed = during(moment, 20.0 * kPeriod); });
  expect_safe("tick overrun of 20 ms", outcome, 20.0 * kPeriod + limits.fade_time);
  expect_recovers(outcome);
}

// A program that was stopped, or a call that hung: where the hand is afterwards it may press only once it has let go.
TEST_F(FaultTable, HapticThreadStands) {
  for (const double deeper : {0.0, 0.02, 0.3}) {
    use("proxy");
    next_step = 0.0;
    const Outcome outcome = run([deeper](Moment& moment) {
      moment.tick_missed = during(moment, 1.0);
      if (!moment.tick_missed && during(moment, 3.0)) moment.state.X_WT.p.y() -= deeper;
    });
    expect_safe("haptic thread stands for 1 s", outcome, 1.0 + limits.fade_time + kPeriod);
    expect_recovers(outcome);
    EXPECT_LE(outcome.force, kFeltStiffness * kDepth + 0.1) << "deeper by " << deeper;
  }
}

TEST_F(FaultTable, TickOverrunOfAHiccupIsOnlyCounted) {
  const Outcome outcome = run([](Moment& moment) { moment.tick_missed = during(moment, 5.0 * kPeriod); });
  expect_safe("tick overrun of 5 ms", outcome, std::numeric_limits<double>::infinity());
  expect_recovers(outcome);
  EXPECT_TRUE(std::isinf(outcome.zero_after));
  EXPECT_EQ(haptics->safety().count(SafetyEvent::kTickLate), 1U);
}

TEST_F(FaultTable, ClutchedInContact) {
  double tool_moved = 0.0;
  const Outcome outcome = run([&](Moment& moment) {
    moment.circumstances.clutched = during(moment, 1.0);
    // The hand goes on by 50 mm, and comes back at its leisure.
    const double gone = std::clamp(moment.time - kFault, 0.0, 1.0) - std::clamp(moment.time - kFault - 1.5, 0.0, 1.0);
    moment.state.X_WT.p.x() += 0.05 * gone;
    if (during(moment, 1.0)) tool_moved = std::max(tool_moved, std::abs(record.X_WT.p.x));
  });
  expect_safe("clutched in contact for 1 s", outcome, limits.fade_time);
  EXPECT_LT(tool_moved, 1e-12);
  EXPECT_NEAR(outcome.in_the_end, kFeltStiffness * kDepth, 0.1);
}

TEST_F(FaultTable, DeadManButtonLetGo) {
  limits.dead_man_button = 0;
  use("proxy");
  buttons = 1;
  const Outcome outcome = run([](Moment& moment) {
    if (during(moment, 1.0)) moment.state.buttons = 0;
  });
  expect_safe("dead-man button let go for 1 s", outcome, limits.fade_time);
  expect_recovers(outcome);
}

TEST_F(FaultTable, DeadManButtonNeverHeld) {
  limits.dead_man_button = 0;
  use("proxy");
  const Outcome outcome = run([](Moment&) {});
  EXPECT_EQ(outcome.before + outcome.force + outcome.in_the_end, 0.0);
}

TEST_F(FaultTable, StiffnessRaisedTenfold) {
  HapticUpdate update{std::make_unique<RenderingMethod>(method("proxy", 10.0 * kFeltStiffness)), limits};
  bool is_changed = false;
  const Outcome outcome = run([&](Moment&) {
    if (!is_changed) haptics->adopt(update);
    is_changed = true;
  });
  expect_safe("stiffness times ten under the press", outcome, std::numeric_limits<double>::infinity());
  EXPECT_NEAR(outcome.in_the_end, limits.max_force, 1e-6);
  EXPECT_LE(outcome.growth_after, limits.max_force / limits.calm_time * kPeriod * (1.0 + 1e-9)) << "it swells";
}

TEST_F(FaultTable, StartsInside) {
  for (const char* name : {"proxy", "paper"}) {
    physics_died = false;
    next_step = 0.0;
    use(name);
    Outcome outcome;
    Wrench before;
    double first = -1.0;
    for (long tick = 0; tick < 8000; ++tick) {
      Moment moment;
      moment.time = static_cast<double>(tick) * kPeriod;
      moment.state.time = moment.time;
      moment.state.X_WT.p.y() = 0.1 - kDepth;
      if (tick == 0) begin(moment.state);
      const IntermediateRepresentation* fresh = step_physics(moment);
      const Wrench now = (*haptics)(moment.state, fresh, {}, record).wrench;
      haptics->fill(*message, 0);
      note(moment.time + kFault, before, now, outcome);
      if (first < 0.0 && now.force.norm() > 0.0) first = moment.time;
      before = now;
    }
    const bool is_proxy = std::string(name) == "proxy";
    expect_safe(is_proxy ? "start inside, 'proxy'" : "start inside, 'paper'", outcome, kAtOnce);
    // The push-out is 0.01 m/s, the ramp begins after it; a method that does not push out waits for the hand.
    EXPECT_NEAR(before.force.norm(), is_proxy ? kFeltStiffness * kDepth : 0.0, 0.1);
    EXPECT_NEAR(first, is_proxy ? kDepth / 0.01 : -1.0, 0.05);
    EXPECT_LT(outcome.force_growth, 0.01);
  }
}

}  // namespace
}  // namespace tegotae
