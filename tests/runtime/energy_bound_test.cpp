// SPDX-License-Identifier: Apache-2.0
#include <tegotae/runtime/energy_bound.hpp>

#include <tests/allocation_counter.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>

namespace tegotae {
namespace {

constexpr double kDt = 1e-3;

// A spring along x (or about it) at the port, pressed by `depth`; the bound displays its force in part.
class Spring {
 public:
  explicit Spring(double stiffness = 1000.0) {
    settings.stiffness = stiffness;
    settings.metric_length = 0.1;
  }

  // The wrench that is displayed once the grip is at `depth` (m, or rad).
  Wrench press(double depth) {
    EnergyBoundInput input;
    const double moved = depth - depth_;
    const double stretch = std::max(depth, 0.0);
    const double rotational = settings.stiffness * settings.metric_length * settings.metric_length;
    (turning ? input.moved[3] : input.moved[0]) = -moved;
    (turning ? input.turn : input.stretch) = stretch;
    input.stretched = input.moved;
    input.part = part;
    if (turning) input.target.torque.x() = part * std::min(rotational * stretch, input.max_torque / part);
    if (!turning) input.target.force.x() = part * std::min(settings.stiffness * stretch, input.max_force / part);
    given += displayed.force.x() * input.moved[0] + displayed.torque.x() * input.moved[3];
    displayed = bound.apply(settings, input, displayed);
    target = input.target;
    depth_ = depth;
    return displayed;
  }
  bool is_untouched() const { return displayed.force == target.force && displayed.torque == target.torque; }

  EnergyBoundSettings settings;
  EnergyBound bound;
  bool turning = false;
  double part = 1.0;
  double given = 0.0;  // J, to the hand
  Wrench displayed, target;

 private:
  double depth_ = 0.0;
};

TEST(EnergyBound, ASteadyPressIsLeftAloneBitForBit) {
  Spring spring;
  for (int i = 0; i < 1000; ++i) spring.press(std::min(1e-6 * i, 5e-4));
  for (int i = 0; i < 100'000; ++i) {
    spring.press(5e-4);
    ASSERT_TRUE(spring.is_untouched());
  }
}

TEST(EnergyBound, TurnedOffItChangesNothing) {
  Spring spring;
  spring.settings.on = false;
  for (int i = 0; i < 1000; ++i) {
    spring.press(1e-3 * std::sin(0.5 * i));
    ASSERT_TRUE(spring.is_untouched());
  }
}

// What a sampled spring gives away is k |dx|^2/2 a tick, whatever it is stretched by.
TEST(EnergyBound, TheObserverSeesExactlyWhatASampledSpringGives) {
  for (const bool turning : {false, true}) {
    Spring spring;
    spring.turning = turning;
    spring.settings.carried = 1e3;
    spring.settings.debt = 1e3;
    const double stiffness = turning ? 10.0 : 1000.0;
    double depth = 0.0, before = 1e-4, own = 0.5 * stiffness * before * before;
    spring.press(before);
    std::mt19937_64 random(1);
    for (int i = 0; i < 100; ++i) {
      depth = before + std::uniform_real_distribution<double>(-1e-6, 1e-6)(random);
      // What the controller adds is part of what is displayed, and of the account.
      const double braking = turning ? spring.displayed.torque.x() - spring.target.torque.x()
                                     : spring.displayed.force.x() - spring.target.force.x();
      own += 0.5 * stiffness * (depth - before) * (depth - before) + braking * (before - depth);
      spring.press(depth);
      before = depth;
    }
    EXPECT_NEAR(spring.bound.level(), -own, 1e-12 + 1e-9 * own);
  }
}

// Pressed and let go quickly, over and over: the hand receives no more than it gave, but for what may be carried.
TEST(EnergyBound, AQuickSpringReturnsNoMoreThanItTook) {
  for (const bool on : {true, false}) {
    Spring spring(8000.0);
    spring.settings.on = on;
    for (int i = 0; i < 2000; ++i) spring.press(1e-3 + 5e-4 * std::sin(0.7 * i));
    const double stored_at_most = 0.5 * 8000.0 * 1.5e-3 * 1.5e-3;
    if (on) {
      EXPECT_LT(spring.given, 0.01) << "J, after 220 cycles";
    } else {
      EXPECT_GT(spring.given, 50.0 * stored_at_most);
    }
  }
}

TEST(EnergyBound, WhatWasDissipatedForAnHourIsNoCredit) {
  Spring rubbed(8000.0), fresh(8000.0);
  EnergyBoundInput rubbing;
  rubbing.moved[1] = 1e-3;
  rubbing.target.force = Vector3(8.0, -5.0, 0.0);
  rubbing.stretch = 1e-3;
  Wrench displayed;
  for (int i = 0; i < 3'600'000; ++i) displayed = rubbed.bound.apply(rubbed.settings, rubbing, displayed);
  EXPECT_LE(rubbed.bound.level(), rubbed.settings.carried);
  EXPECT_GT(rubbed.bound.level(), 0.0);
  fresh.press(1e-3);
  for (Spring* spring : {&rubbed, &fresh}) {
    spring->given = 0.0;
    for (int i = 0; i < 200; ++i) spring->press(1e-3 + 5e-4 * std::sin(0.7 * i));
  }
  EXPECT_NEAR(rubbed.given, fresh.given, 5e-3);
}

TEST(EnergyBound, TheDamperBrakesAndNeverPulls) {
  Spring spring(8000.0);
  double strongest = 0.0;
  for (int i = 0; i < 2000; ++i) {
    spring.press(5e-4 * std::sin(0.9 * i));
    ASSERT_GE(spring.displayed.force.x(), -1e-12) << "a wall that pulls";
    ASSERT_LE(spring.displayed.force.x(), 2.0 * spring.target.force.x());
    strongest = std::max(strongest, spring.bound.damping());
  }
  EXPECT_GT(strongest, 1.0);
  EXPECT_LE(strongest, 4.0 * 8000.0 * 0.5 * kDt * (1.0 + 1e-12));
}

// 10 um a tick are 0.06 N at 6 N s/m.
TEST(EnergyBound, ACoarseEncoderMakesTheDamperWeakerThanItsNoise) {
  for (const double step : {0.0, 10e-6}) {
    Spring spring(9000.0);
    spring.settings.encoder_step = step;
    double strongest = 0.0;
    for (int i = 0; i < 1000; ++i) {
      spring.press(1e-3 + 2e-4 * std::sin(0.5 * i));
      strongest = std::max(strongest, spring.bound.damping());
    }
    if (step > 0.0) {
      EXPECT_NEAR(strongest, spring.settings.noise * kDt / step, 1e-9);
    } else {
      EXPECT_GT(strongest, 10.0);
    }
  }
}

TEST(EnergyBound, WhatTheInterfaceVouchesForIsNotTakenBack) {
  Spring spring(1000.0);
  spring.settings.own_damping = 0.5 * 1001.0 * kDt;
  for (int i = 0; i < 2000; ++i) {
    spring.press(1e-3 + 5e-4 * std::sin(0.7 * i));
    ASSERT_TRUE(spring.is_untouched()) << i;
  }
}

TEST(EnergyBound, ASpringThatIsCutToTheLimitStoresWhatItsForceDid) {
  Spring spring(8000.0);  // 15 N at 1.9 mm
  spring.settings.own_damping = 0.5 * 8001.0 * kDt;
  for (int i = 0; i < 4000; ++i) {
    spring.press(3e-3 - 3e-3 * std::cos(0.01 * i));
    ASSERT_TRUE(spring.is_untouched()) << "6 mm deep and back";
  }
}

TEST(EnergyBound, ADelayThatIsKnownIsCounted) {
  double taken[2] = {};
  for (const int periods : {0, 2}) {
    Spring spring(8000.0);
    spring.settings.delay = periods * kDt;
    double damping = 0.0;
    for (int i = 0; i < 500; ++i) {
      spring.press(1e-3 + 1e-4 * std::sin(0.3 * i));
      damping += spring.bound.damping() / 500.0;
    }
    taken[periods / 2] = damping;
  }
  EXPECT_GT(taken[1], 2.0 * taken[0]);
}

TEST(EnergyBound, ForgetsWhereNothingIsDisplayed) {
  Spring spring(8000.0);
  for (int i = 0; i < 100; ++i) spring.press(1e-3 + 5e-4 * std::sin(0.9 * i));
  EXPECT_NE(spring.bound.level(), 0.0);
  for (int i = 0; i < 3; ++i) spring.press(-1e-3);
  EXPECT_EQ(spring.bound.level(), 0.0);
}

TEST(EnergyBound, ARampThatRisesUnderAPressIsNoGift) {
  Spring spring;
  for (int i = 0; i < 2000; ++i) {
    spring.part = i / 2000.0;
    spring.press(1e-3);
    ASSERT_TRUE(spring.is_untouched());
  }
}

TEST(EnergyBound, WhatIsNotFiniteIsForgotten) {
  Spring spring;
  spring.press(1e-3);
  EnergyBoundInput input;
  input.target.force.x() = 1.0;
  input.stretch = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(spring.bound.apply(spring.settings, input, {}).force.x(), 1.0);
  EXPECT_EQ(spring.bound.level(), 0.0);
  input.dt = 0.0;
  EXPECT_EQ(spring.bound.apply(spring.settings, input, {}).force.x(), 1.0);
}

TEST(EnergyBound, AllocatesNothing) {
  Spring spring;
  const test::AllocationCounter counter;
  for (int i = 0; i < 1000; ++i) spring.press(1e-3 * std::sin(0.5 * i));
  EXPECT_EQ(counter.count(), 0U);
}

}  // namespace
}  // namespace tegotae
