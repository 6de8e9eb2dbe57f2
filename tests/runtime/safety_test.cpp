// SPDX-License-Identifier: Apache-2.0
#include <tegotae/runtime/safety.hpp>
#include <tegotae/runtime/vector_limits.hpp>

#include <tests/allocation_counter.hpp>
#include <tests/random_shapes.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <random>

namespace tegotae {
namespace {

using test::random_unit;

constexpr double kUnbounded = std::numeric_limits<double>::infinity();
constexpr double kNotANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double kSafetyPeriod = 1e-3;

Wrench push(double force, double torque) { return {Vector3(force, 0.0, 0.0), Vector3(0.0, torque, 0.0)}; }

SafetyInput input_of(const Wrench& target) {
  SafetyInput input;
  input.target = target;
  input.elapsed = kSafetyPeriod;
  return input;
}

// A state whose ramp is done, displaying `wrench`.
SafetyState running_state(const Wrench& wrench = {}) {
  SafetyState state;
  state.waiting = false;
  state.ramp = 1.0;
  state.displayed = wrench;
  return state;
}

bool same_bits(const Vector3& a, const Vector3& b) {
  for (int i = 0; i < 3; ++i) {
    if (std::bit_cast<std::uint64_t>(a[i]) != std::bit_cast<std::uint64_t>(b[i])) return false;
  }
  return true;
}

TEST(Safety, IsTransparentBitForBitWhenNothingTriggers) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> force(0.0, 14.9), torque(0.0, 0.99);
  const SafetyLimits limits;
  for (int i = 0; i < 100'000; ++i) {
    SafetyState state = running_state();
    const Wrench target{force(random) * random_unit(random), torque(random) * random_unit(random)};
    const SafetyOutput output = apply_safety(limits, state, input_of(target));
    ASSERT_TRUE(same_bits(output.displayed.force, target.force));
    ASSERT_TRUE(same_bits(output.displayed.torque, target.torque));
    ASSERT_EQ(output.events, 0U);
    ASSERT_EQ(output.ratio, 1.0);
  }
}

TEST(Safety, RampsInFromZeroThenLetsEverythingThrough) {
  const SafetyLimits limits;
  SafetyState state;
  EXPECT_EQ(apply_safety(limits, state, input_of(Wrench())).displayed.force, Vector3::Zero());
  const Wrench target = push(1.0, 0.1);
  const int ticks = static_cast<int>(std::round(limits.ramp_time / limits.period));
  EXPECT_EQ(ticks, 2000);
  for (int i = 2; i < ticks; ++i) {
    const SafetyOutput output = apply_safety(limits, state, input_of(target));
    EXPECT_NEAR(output.displayed.force.x(), i * limits.period / limits.ramp_time, 1e-12);
    EXPECT_NEAR(output.ratio, i * limits.period / limits.ramp_time, 1e-12);
    EXPECT_TRUE(output.has(SafetyEvent::kRamping));
  }
  apply_safety(limits, state, input_of(target));
  const SafetyOutput after = apply_safety(limits, state, input_of(target));
  EXPECT_EQ(after.displayed.force, target.force);
  EXPECT_EQ(after.events, 0U);
}

TEST(Safety, NoRampTimeMeansNoRamp) {
  SafetyLimits limits = without_hand({});
  limits.ramp_time = 0.0;
  SafetyState state;
  EXPECT_EQ(apply_safety(limits, state, input_of(push(1.0, 0.0))).displayed.force.x(), 1.0);
}

TEST(Safety, WhatIsNoWrenchCountsAsZero) {
  const SafetyLimits limits;
  for (const double bad : {kNotANumber, -kNotANumber, kUnbounded, -kUnbounded, 1.001 * kLargestWrench, -1e308}) {
    for (int component = 0; component < 6; ++component) {
      Wrench target = push(1.0, 0.1);
      (component < 3 ? target.force[component] : target.torque[component - 3]) = bad;
      SafetyState state = running_state(push(5.0, 0.5));
      const SafetyOutput output = apply_safety(limits, state, input_of(target));
      EXPECT_EQ(output.displayed.force, Vector3::Zero());
      EXPECT_EQ(output.displayed.torque, Vector3::Zero());
      EXPECT_TRUE(output.has(SafetyEvent::kNotFinite));
      EXPECT_EQ(state.count(SafetyEvent::kNotFinite), 1U);
      EXPECT_EQ(output.ratio, 0.0);
    }
  }
}

TEST(Safety, ForceAndTorqueGrowByTheirRatesAndReleaseFreely) {
  const SafetyLimits limits;
  SafetyState state = running_state();
  const SafetyOutput grown = apply_safety(limits, state, input_of(push(1000.0, 100.0)));
  EXPECT_TRUE(grown.has(SafetyEvent::kRateLimited));
  EXPECT_LE(grown.displayed.force.x(), limits.force_rate * kSafetyPeriod);
  SafetyLimits slow = limits;
  slow.force_rate = 1000.0;
  slow.torque_rate = 100.0;
  state = running_state();
  for (int i = 1; i <= 5; ++i) {
    const SafetyOutput output = apply_safety(slow, state, input_of(push(10.0, 0.9)));
    EXPECT_NEAR(output.displayed.force.x(), i * 1.0, 1e-12);
    EXPECT_NEAR(output.displayed.torque.y(), std::min(i * 0.1, 0.9), 1e-12);
  }
  EXPECT_EQ(apply_safety(slow, state, input_of(Wrench())).displayed.force.x(), 0.0);
}

TEST(Safety, DefaultRateLetsAStrikeOfOneMetreASecondThrough) {
  constexpr double kStiffness = 1000.0, kSpeed = 1.0;
  const SafetyLimits limits = safety_limits(InterfaceCapability(), kStiffness, 0.08, 0.05);
  SafetyState state = running_state();
  for (int i = 1; kStiffness * kSpeed * i * kSafetyPeriod < limits.max_force; ++i) {
    EXPECT_EQ(apply_safety(limits, state, input_of(push(kStiffness * kSpeed * i * kSafetyPeriod, 0.0))).events, 0U);
  }
  EXPECT_TRUE(apply_safety(limits, state, input_of(push(1e3, 0.0))).has(SafetyEvent::kRateLimited));
}

TEST(Safety, LateTickMayNotGrowTheWrenchByMoreThanOnePeriod) {
  SafetyLimits limits;
  limits.force_rate = 1000.0;
  limits.max_missed_ticks = std::numeric_limits<int>::max();
  for (const double elapsed : {0.02, 1e9, kUnbounded}) {
    SafetyState state = running_state();
    SafetyInput input = input_of(push(10.0, 0.0));
    input.elapsed = elapsed;
    const double displayed = apply_safety(limits, state, input).displayed.force.x();
    EXPECT_LE(displayed, 1.0 + 1e-12);
    EXPECT_NEAR(displayed, elapsed < 1.0 ? 1.0 : 0.0, 1e-12);
  }
  for (const double elapsed : {0.0, -1.0, kNotANumber}) {
    SafetyState state = running_state(push(0.5, 0.0));
    SafetyInput input = input_of(push(10.0, 0.0));
    input.elapsed = elapsed;
    EXPECT_NEAR(apply_safety(limits, state, input).displayed.force.x(), 0.5, 1e-12) << "no growth without a clock";
  }
}

TEST(Safety, SaturatesForceAndTorqueEachAndKeepsDirections) {
  SafetyLimits limits;
  limits.force_rate = limits.torque_rate = 1e9;
  std::mt19937_64 random(2);
  for (int i = 0; i < 1000; ++i) {
    SafetyState state = running_state();
    const Wrench target{40.0 * random_unit(random), 0.5 * random_unit(random)};
    const SafetyOutput output = apply_safety(limits, state, input_of(target));
    ASSERT_LE(output.displayed.force.norm(), limits.max_force);
    ASSERT_LT(output.displayed.force.cross(target.force).norm(), 1e-12);
    ASSERT_EQ(output.displayed.torque, target.torque);
    ASSERT_TRUE(output.has(SafetyEvent::kForceSaturated));
    ASSERT_FALSE(output.has(SafetyEvent::kTorqueSaturated));
  }
}

TEST(Safety, LatePhysicsIsHeldThenFadesToZeroWithinTheFadeTime) {
  const SafetyLimits limits;
  const Wrench target = push(10.0, 0.8);
  SafetyState state = running_state(target);
  SafetyInput input = input_of(target);
  input.model_age = limits.max_model_age;
  EXPECT_EQ(apply_safety(limits, state, input).displayed.force, target.force) << "held up to the limit";
  double last_force = 10.0, last_torque = 0.8;
  const int ticks = static_cast<int>(std::round(limits.fade_time / limits.period));
  for (int i = 1; i <= ticks; ++i) {
    input.model_age = limits.max_model_age + i * kSafetyPeriod;
    const SafetyOutput output = apply_safety(limits, state, input);
    EXPECT_TRUE(output.has(SafetyEvent::kPhysicsLate));
    EXPECT_LT(output.displayed.force.norm(), last_force);
    EXPECT_LT(output.displayed.torque.norm(), last_torque);
    EXPECT_NEAR(output.displayed.force.x(), 10.0 * (1.0 - static_cast<double>(i) / ticks), 1e-12);
    last_force = output.displayed.force.norm();
    last_torque = output.displayed.torque.norm();
  }
  EXPECT_EQ(last_force, 0.0);
  EXPECT_EQ(last_torque, 0.0);
  EXPECT_EQ(state.count(SafetyEvent::kPhysicsLate), static_cast<std::uint64_t>(ticks));
}

TEST(Safety, FadeNeverRisesWhateverTheTargetAndTheClockDo) {
  std::mt19937_64 random(3);
  std::uniform_real_distribution<double> magnitude(0.0, 100.0), elapsed(0.0, 2e-3);
  const SafetyLimits limits;
  for (int run = 0; run < 1000; ++run) {
    SafetyState state = running_state({14.0 * random_unit(random), 0.9 * random_unit(random)});
    double last_force = state.displayed.force.norm(), last_torque = state.displayed.torque.norm();
    const bool clock_fails = run % 3 == 0;
    for (int i = 0; i < 20; ++i) {
      SafetyInput input = input_of({magnitude(random) * random_unit(random), magnitude(random) * random_unit(random)});
      input.model_age = 1.0;
      input.elapsed = clock_fails ? (run % 2 == 0 ? kNotANumber : 0.0) : elapsed(random);
      const SafetyOutput output = apply_safety(limits, state, input);
      ASSERT_LE(output.displayed.force.norm(), last_force);
      ASSERT_LE(output.displayed.torque.norm(), last_torque);
      last_force = output.displayed.force.norm();
      last_torque = output.displayed.torque.norm();
    }
    ASSERT_EQ(last_force, 0.0) << "done after fade_time / period calls at the latest";
    ASSERT_EQ(last_torque, 0.0);
  }
}

TEST(Safety, PhysicsComingBackContinuesWithTheRampFromWhereTheFadeStood) {
  const SafetyLimits limits;
  const Wrench target = push(10.0, 0.0);
  SafetyState state = running_state(target);
  SafetyInput input = input_of(target);
  input.model_age = 1.0;
  for (int i = 0; i < 10; ++i) apply_safety(limits, state, input);
  EXPECT_NEAR(state.displayed.force.x(), 5.0, 1e-12);
  input.model_age = 0.0;
  const SafetyOutput back = apply_safety(limits, state, input);
  EXPECT_NEAR(back.displayed.force.x(), 10.0 * (0.5 + kSafetyPeriod / limits.ramp_time), 1e-12);
  EXPECT_TRUE(back.has(SafetyEvent::kRamping));
  input.model_age = kUnbounded;
  for (int i = 0; i < 25; ++i) apply_safety(limits, state, input);
  input.model_age = 0.0;
  EXPECT_NEAR(apply_safety(limits, state, input).displayed.force.x(), 10.0 * kSafetyPeriod / limits.ramp_time, 1e-12);
}

TEST(Safety, LostInterfaceAndEndingGiveZeroInTheSameCallAndRampAgain) {
  const SafetyLimits limits;
  const Wrench target = push(10.0, 0.8);
  for (const bool ending : {false, true}) {
    SafetyState state = running_state(target);
    SafetyInput input = input_of(target);
    (ending ? input.ending : input.interface_lost) = true;
    const SafetyOutput output = apply_safety(limits, state, input);
    EXPECT_EQ(output.displayed.force, Vector3::Zero());
    EXPECT_EQ(output.displayed.torque, Vector3::Zero());
    EXPECT_TRUE(output.has(SafetyEvent::kStopped));
    EXPECT_EQ(state.count(SafetyEvent::kStopped), 1U);
    for (int i = 0; i < 100; ++i) {
      const SafetyOutput pressed = apply_safety(limits, state, input_of(target));
      EXPECT_EQ(pressed.displayed.force, Vector3::Zero()) << "it waits until the hand has come back";
      EXPECT_TRUE(pressed.has(SafetyEvent::kWaiting));
    }
    apply_safety(limits, state, input_of(Wrench()));
    const SafetyOutput back = apply_safety(limits, state, input_of(target));
    EXPECT_NEAR(back.displayed.force.x(), 10.0 * 2.0 * kSafetyPeriod / limits.ramp_time, 1e-12);
  }
}

TEST(Safety, TheRampWaitsForASmallWrench) {
  const SafetyLimits limits;
  for (const Wrench& large : {push(0.21, 0.0), push(0.0, 0.011)}) {
    SafetyState state;
    for (int i = 0; i < 5000; ++i) {
      const SafetyOutput output = apply_safety(limits, state, input_of(large));
      ASSERT_EQ(output.displayed.force, Vector3::Zero());
      ASSERT_EQ(output.displayed.torque, Vector3::Zero());
      ASSERT_TRUE(output.has(SafetyEvent::kWaiting));
    }
    EXPECT_FALSE(apply_safety(limits, state, input_of(push(0.19, 0.009))).has(SafetyEvent::kWaiting));
    EXPECT_TRUE(apply_safety(limits, state, input_of(large)).has(SafetyEvent::kRamping)) << "begun is begun";
  }
}

TEST(Safety, TheRampWaitsForTheEndOfAPushOut) {
  const SafetyLimits limits;
  SafetyState state;
  for (int i = 0; i < 1000; ++i) {
    SafetyInput input = input_of(push(0.01 * i, 0.0));
    input.pushing_out = true;
    ASSERT_EQ(apply_safety(limits, state, input).displayed.force, Vector3::Zero()) << "small as it is at first";
  }
  const SafetyOutput out = apply_safety(limits, state, input_of(push(10.0, 0.0)));
  EXPECT_NEAR(out.displayed.force.x(), 10.0 * kSafetyPeriod / limits.ramp_time, 1e-12);
}

TEST(Safety, WithoutAHandTheRampIsShortAndBeginsAtOnce) {
  const SafetyLimits limits = without_hand({});
  SafetyState state;
  SafetyInput input = input_of(push(10.0, 0.0));
  input.pushing_out = true;
  for (int i = 1; i <= 200; ++i) apply_safety(limits, state, input);
  EXPECT_NEAR(apply_safety(limits, state, input).displayed.force.x(), 10.0, 1e-12);
}

// Clutch, dead-man button and a pose that is too old.
TEST(Safety, WhatIsLetGoFadesAndThenBeginsAgain) {
  const SafetyLimits limits;
  const Wrench target = push(10.0, 0.8);
  const int ticks = static_cast<int>(std::round(limits.fade_time / limits.period));
  for (const SafetyEvent event : {SafetyEvent::kClutched, SafetyEvent::kDeadMan, SafetyEvent::kPoseFault}) {
    for (const int held : {ticks / 2, ticks, 10 * ticks}) {
      SafetyState state = running_state(target);
      SafetyInput input = input_of(target);
      input.clutched = event == SafetyEvent::kClutched;
      input.enabled = event != SafetyEvent::kDeadMan;
      input.pose_age = event == SafetyEvent::kPoseFault ? 0.021 : 0.0;
      for (int i = 1; i <= held; ++i) {
        const SafetyOutput output = apply_safety(limits, state, input);
        ASSERT_TRUE(output.has(event));
        const double left = std::max(0.0, 1.0 - static_cast<double>(i) / ticks);
        ASSERT_NEAR(output.displayed.force.x(), 10.0 * left, 1e-12);
        ASSERT_NEAR(output.displayed.torque.y(), 0.8 * left, 1e-12);
      }
      for (int i = 0; i < 100; ++i) {
        ASSERT_EQ(apply_safety(limits, state, input_of(target)).displayed.force, Vector3::Zero()) << "still pressed";
      }
      apply_safety(limits, state, input_of(Wrench()));
      EXPECT_NEAR(apply_safety(limits, state, input_of(target)).displayed.force.x(),
                  10.0 * 2.0 * kSafetyPeriod / limits.ramp_time, 1e-12);
    }
  }
}

TEST(Safety, APoseFaultGivesZeroInTheSameCallAndBeginsAgain) {
  const SafetyLimits limits;
  SafetyState state = running_state(push(10.0, 0.8));
  SafetyInput input = input_of(push(10.0, 0.8));
  input.pose_fault = true;
  const SafetyOutput output = apply_safety(limits, state, input);
  EXPECT_EQ(output.displayed.force, Vector3::Zero());
  EXPECT_EQ(output.displayed.torque, Vector3::Zero());
  EXPECT_TRUE(output.has(SafetyEvent::kPoseFault));
  EXPECT_TRUE(apply_safety(limits, state, input_of(push(10.0, 0.8))).has(SafetyEvent::kWaiting));
}

TEST(Safety, AFewMissedTicksAreCountedAndMoreAreFadedAfter) {
  const SafetyLimits limits;
  const Wrench target = push(10.0, 0.8);
  SafetyState state = running_state(target);
  SafetyInput late = input_of(target);
  late.elapsed = 11e-3;
  SafetyOutput output = apply_safety(limits, state, late);
  EXPECT_TRUE(output.has(SafetyEvent::kTickLate));
  EXPECT_EQ(output.displayed.force, target.force) << "ten ticks were missed";
  late.elapsed = 21e-3;
  output = apply_safety(limits, state, late);
  EXPECT_NEAR(output.displayed.force.x(), 9.5, 1e-12) << "twenty: what was held meanwhile is not dropped";
  for (int i = 18; i >= 0; --i) {
    output = apply_safety(limits, state, input_of(target));
    EXPECT_TRUE(output.has(SafetyEvent::kTickLate));
    EXPECT_NEAR(output.displayed.force.x(), 0.5 * i, 1e-12);
  }
  output = apply_safety(limits, state, input_of(target));
  EXPECT_NEAR(output.displayed.force.x(), 10.0 * kSafetyPeriod / limits.ramp_time, 1e-12)
      << "and the ramp goes on from there";
  EXPECT_FALSE(output.has(SafetyEvent::kTickLate));
}

TEST(Safety, AfterAChangeOfSettingsTheWrenchGrowsSlowly) {
  const SafetyLimits limits;
  SafetyState state = running_state(push(1.0, 0.0));
  state.calm_for = limits.calm_time;
  double last = 1.0;
  for (int i = 0; i < 467; ++i) {
    const double now = apply_safety(limits, state, input_of(push(15.0, 0.0))).displayed.force.x();
    ASSERT_LE(now, last + limits.max_force / limits.calm_time * kSafetyPeriod + 1e-12);
    last = now;
  }
  EXPECT_NEAR(last, 15.0, 1e-9) << "less than half a second";
}

TEST(Safety, TheEnergyBoundBrakesWhatASampledSpringGives) {
  for (const bool on : {true, false}) {
    SafetyLimits limits;
    limits.energy_bound.on = on;
    limits.energy_bound.stiffness = 5000.0;
    SafetyState state = running_state();
    double depth = 1e-3, given = 0.0;
    for (int i = 0; i < 2000; ++i) {
      const double next = 1e-3 + 5e-4 * std::sin(0.7 * i);
      given += state.displayed.force.x() * (depth - next);
      SafetyInput input = input_of(push(5000.0 * next, 0.0));
      input.moved[0] = input.stretched[0] = depth - next;
      input.stretch = depth = next;
      apply_safety(limits, state, input);
    }
    if (on) {
      EXPECT_LT(given, 0.01) << "J";
      EXPECT_GT(state.count(SafetyEvent::kEnergyBounded), 500U);
    } else {
      EXPECT_GT(given, 0.2);
      EXPECT_EQ(state.count(SafetyEvent::kEnergyBounded), 0U);
    }
  }
}

TEST(Safety, NothingIsDisplayedBeforePhysicsHasCome) {
  const SafetyLimits limits;
  SafetyState state;
  SafetyInput input = input_of(push(10.0, 0.8));
  for (const double age : {kUnbounded, kNotANumber}) {
    input.model_age = age;
    for (int i = 0; i < 1000; ++i) EXPECT_EQ(apply_safety(limits, state, input).displayed.force, Vector3::Zero());
  }
  EXPECT_EQ(state.ramp, 0.0) << "the ramp waits for physics";
}

TEST(Safety, RatioIsThePartOfTheTargetThatIsDisplayed) {
  SafetyLimits limits;
  limits.force_rate = limits.torque_rate = 1e9;
  SafetyState state = running_state();
  EXPECT_NEAR(apply_safety(limits, state, input_of(push(60.0, 0.0))).ratio, 0.25, 1e-12);
  state = running_state();
  EXPECT_NEAR(apply_safety(limits, state, input_of(push(0.0, 4.0))).ratio, 0.25, 1e-12);
  // Force cut to half, torque whole: least squares with torque over the metric length of 0.1 m.
  state = running_state();
  EXPECT_NEAR(apply_safety(limits, state, input_of(push(30.0, 1.0))).ratio, (15.0 * 30.0 + 100.0) / 1000.0, 1e-12);
  state = running_state();
  EXPECT_EQ(apply_safety(limits, state, input_of(Wrench())).ratio, 1.0) << "nothing asked, nothing withheld";
}

void expect_no_more_than_the_target(const SafetyLimits& limits, const SafetyInput& input) {
  SafetyState state = running_state();
  for (int i = 0; i < 5; ++i) {
    const SafetyOutput output = apply_safety(limits, state, input);
    EXPECT_TRUE(output.displayed.is_finite());
    EXPECT_LE(output.displayed.force.norm(), 5.0);
  }
}

TEST(Safety, OverwrittenLimitsOrStateLetNoNaNOut) {
  SafetyInput input = input_of(push(5.0, 0.5));
  input.moved << 1e-4, 0.0, 0.0, 0.0, 1e-3, 0.0;
  input.stretched = input.moved;
  input.stretch = 1e-4;
  input.turn = 1e-3;
  for (double SafetyLimits::*member :
       {&SafetyLimits::period, &SafetyLimits::ramp_time, &SafetyLimits::force_rate, &SafetyLimits::torque_rate,
        &SafetyLimits::max_force, &SafetyLimits::max_torque, &SafetyLimits::max_model_age, &SafetyLimits::fade_time,
        &SafetyLimits::metric_length, &SafetyLimits::ramp_below_force, &SafetyLimits::ramp_below_torque,
        &SafetyLimits::max_pose_age, &SafetyLimits::calm_time}) {
    SafetyLimits limits;
    limits.*member = kNotANumber;
    expect_no_more_than_the_target(limits, input);
  }
  for (double EnergyBoundSettings::*member :
       {&EnergyBoundSettings::stiffness, &EnergyBoundSettings::metric_length, &EnergyBoundSettings::delay,
        &EnergyBoundSettings::own_damping, &EnergyBoundSettings::own_rotational_damping, &EnergyBoundSettings::carried,
        &EnergyBoundSettings::debt}) {
    SafetyLimits limits;
    limits.energy_bound.*member = kNotANumber;
    expect_no_more_than_the_target(limits, input);
  }
  SafetyState state = running_state({Vector3(kNotANumber, 0.0, 0.0), Vector3(0.0, kNotANumber, 0.0)});
  EXPECT_TRUE(apply_safety(SafetyLimits(), state, input).displayed.is_finite());
  state = running_state();
  state.ramp = kNotANumber;
  EXPECT_TRUE(apply_safety(SafetyLimits(), state, input).displayed.is_finite());
  state.ramp = 1.0;
  EXPECT_TRUE(apply_safety(SafetyLimits(), state, input).displayed.is_finite());
}

// Any bits in the input: half of the numbers are random bit patterns (NaN, infinities, denormals, huge among them).
class BitSweep {
 public:
  explicit BitSweep(std::uint64_t seed) : random_(seed) {}

  SafetyInput input() {
    SafetyInput input;
    for (int i = 0; i < 3; ++i) input.target.force[i] = number(50.0);
    for (int i = 0; i < 3; ++i) input.target.torque[i] = number(3.0);
    input.elapsed = number(2e-3);
    input.model_age = number(0.2);
    input.pose_age = number(0.02);
    input.interface_lost = random_() % 500 == 0;
    input.ending = random_() % 500 == 0;
    input.pushing_out = random_() % 20 == 0;
    input.pose_fault = random_() % 500 == 0;
    input.clutched = random_() % 200 == 0;
    input.enabled = random_() % 200 != 0;
    for (int i = 0; i < 6; ++i) input.moved[i] = number(1e-3);
    for (int i = 0; i < 6; ++i) input.stretched[i] = number(1e-3);
    input.stretch = number(1e-3);
    input.turn = number(1e-2);
    return input;
  }

 private:
  double number(double scale) {
    if (random_() % 16 == 0) return std::bit_cast<double>(random_());
    return std::uniform_real_distribution<double>(-0.2 * scale, scale)(random_);
  }
  std::mt19937_64 random_;
};

TEST(Safety, HoldsItsPropertiesForAnyBits) {
  SafetyLimits limits;
  limits.force_rate = 3000.0;
  limits.torque_rate = 300.0;
  limits.ramp_time = 0.01;
  limits.ramp_below_force = 30.0;
  limits.ramp_below_torque = 2.0;
  limits.max_model_age = 0.18;
  BitSweep sweep(4);
  SafetyState state;
  std::uint64_t displayed_something = 0, events_seen = 0;
  for (int i = 0; i < 200'000; ++i) {
    const SafetyInput input = sweep.input();
    const Wrench last = state.displayed;
    const SafetyOutput output = apply_safety(limits, state, input);
    const Wrench& displayed = output.displayed;
    ASSERT_TRUE(displayed.is_finite());
    ASSERT_LE(displayed.force.norm(), limits.max_force);
    ASSERT_LE(displayed.torque.norm(), limits.max_torque);
    ASSERT_LE(displayed.force.norm(), last.force.norm() + limits.force_rate * limits.period + 1e-12);
    ASSERT_LE(displayed.torque.norm(), last.torque.norm() + limits.torque_rate * limits.period + 1e-12);
    ASSERT_GE(output.ratio, 0.0);
    ASSERT_LE(output.ratio, 1.0);
    if (input.interface_lost || input.ending) {
      ASSERT_EQ(displayed.force, Vector3::Zero());
      ASSERT_EQ(displayed.torque, Vector3::Zero());
    }
    displayed_something += displayed.force.norm() > 1.0 ? 1 : 0;
    events_seen |= output.events;
  }
  EXPECT_GT(displayed_something, 20'000U) << "the sweep reaches the working range";
  EXPECT_EQ(events_seen, (1U << kSafetyEvents) - 1) << "and every stage";
}

TEST(Safety, AllocatesNothing) {
  BitSweep sweep(5);
  SafetyState state;
  const SafetyLimits limits;
  const test::AllocationCounter counter;
  for (int i = 0; i < 1000; ++i) apply_safety(limits, state, sweep.input());
  EXPECT_EQ(counter.count(), 0U);
}

}  // namespace
}  // namespace tegotae
