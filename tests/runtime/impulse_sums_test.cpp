// SPDX-License-Identifier: Apache-2.0
#include <tegotae/runtime/impulse_sums.hpp>
#include <tegotae/runtime/latest_value.hpp>

#include <tests/allocation_counter.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <memory>
#include <random>
#include <thread>
#include <vector>

namespace tegotae {
namespace {

constexpr double kSumPeriod = 1e-3;

Wrench random_wrench(std::mt19937_64& random) {
  std::uniform_real_distribution<double> uniform(-20.0, 20.0);
  Wrench wrench;
  for (int i = 0; i < 3; ++i) wrench.force[i] = uniform(random);
  for (int i = 0; i < 3; ++i) wrench.torque[i] = 0.1 * uniform(random);
  return wrench;
}

TEST(ImpulseSums, DifferenceIsTheImpulseOfEachBody) {
  ImpulseAccumulator accumulator;
  ImpulseDifferences differences;
  ImpulseSums message;
  std::vector<BodyImpulse> impulses(3);
  accumulator.add(0, {Vector3(1.0, 2.0, 3.0), Vector3(0.0, 0.0, 1.0)}, 0.5);
  accumulator.add(2, {Vector3(0.0, 4.0, 0.0), Vector3::Zero()}, 0.25);
  accumulator.fill(message, 3);
  message.sequence = 1;
  EXPECT_TRUE(differences.take(message, impulses));
  EXPECT_EQ(impulses[0].linear, Vector3(0.5, 1.0, 1.5));
  EXPECT_EQ(impulses[0].angular, Vector3(0.0, 0.0, 0.5));
  EXPECT_EQ(impulses[1].linear, Vector3::Zero());
  EXPECT_EQ(impulses[2].linear, Vector3(0.0, 1.0, 0.0));
}

TEST(ImpulseSums, RepeatedAndOlderMessagesGiveNothing) {
  ImpulseAccumulator accumulator;
  ImpulseDifferences differences;
  ImpulseSums first, second;
  std::vector<BodyImpulse> impulses(1);
  EXPECT_FALSE(differences.take(first, impulses)) << "nothing was sent yet";
  accumulator.add(0, {Vector3(1.0, 0.0, 0.0), Vector3::Zero()}, 1.0);
  accumulator.fill(first, 1);
  first.sequence = 1;
  accumulator.add(0, {Vector3(1.0, 0.0, 0.0), Vector3::Zero()}, 1.0);
  accumulator.fill(second, 1);
  second.sequence = 2;
  EXPECT_TRUE(differences.take(second, impulses));
  EXPECT_EQ(impulses[0].linear.x(), 2.0);
  for (const ImpulseSums* old : {&second, &first}) {
    impulses[0].linear.setConstant(9.0);
    EXPECT_FALSE(differences.take(*old, impulses));
    EXPECT_EQ(impulses[0].linear, Vector3::Zero()) << "the caller may apply the impulses without asking";
  }
}

// Each displayed impulse is applied once and only once, whatever messages are skipped or repeated.
TEST(ImpulseSums, DifferencesAddUpToTheFinalSumOverRandomSkipping) {
  constexpr int kBodies = 5, kTicks = 2000;
  for (unsigned seed = 0; seed < 50; ++seed) {
    std::mt19937_64 random(seed);
    std::uniform_int_distribution<int> body(0, kBodies - 1), pattern(0, 9);
    ImpulseAccumulator accumulator;
    ImpulseDifferences differences;
    ImpulseSums message;
    std::vector<BodyImpulse> displayed(kBodies), applied(kBodies), impulses(kBodies);
    for (int tick = 1; tick <= kTicks; ++tick) {
      const int pushed = body(random);
      const Wrench wrench = random_wrench(random);
      accumulator.add(pushed, wrench, kSumPeriod);
      displayed[static_cast<std::size_t>(pushed)].linear += kSumPeriod * wrench.force;
      displayed[static_cast<std::size_t>(pushed)].angular += kSumPeriod * wrench.torque;
      accumulator.fill(message, kBodies);
      message.sequence = static_cast<std::uint64_t>(tick);
      const int taken = tick == kTicks ? 1 : std::max(0, pattern(random) - 7);  // 0: skipped, 2: repeated
      for (int i = 0; i < taken; ++i) {
        differences.take(message, impulses);
        for (std::size_t b = 0; b < kBodies; ++b) {
          applied[b].linear += impulses[b].linear;
          applied[b].angular += impulses[b].angular;
        }
      }
    }
    for (std::size_t b = 0; b < kBodies; ++b) {
      // Rounding of 400 terms of about 0.02 N s in three sums; one lost or doubled impulse is 1e-2 N s.
      EXPECT_LT((applied[b].linear - displayed[b].linear).norm(), 1e-13) << "seed " << seed << " body " << b;
      EXPECT_LT((applied[b].angular - displayed[b].angular).norm(), 1e-14) << "seed " << seed << " body " << b;
    }
  }
}

// An hour at 1 kHz of a push whose impulse has no finite binary fraction.
TEST(ImpulseSums, AnHourDoesNotDrift) {
  constexpr long kTicks = 3'600'000;
  const Wrench wrench{Vector3(10.0, 3.3, -0.7), Vector3(0.1, 0.0, 0.0)};
  const double tick_impulse = wrench.force.x() * kSumPeriod;
  ImpulseAccumulator accumulator;
  double plain = 0.0;
  for (long i = 0; i < kTicks; ++i) {
    accumulator.add(0, wrench, kSumPeriod);
    plain += tick_impulse;
  }
  ImpulseSums message;
  accumulator.fill(message, 1);
  const long double exact = static_cast<long double>(tick_impulse) * kTicks;
  const auto error = static_cast<double>(std::abs(static_cast<long double>(message.bodies[0].linear.x) - exact));
  const auto plain_error = static_cast<double>(std::abs(static_cast<long double>(plain) - exact));
  RecordProperty("plain_drift_N_s", std::to_string(plain_error));
  EXPECT_LE(error, 0x1p-53 * static_cast<double>(exact)) << "half a unit in the last place";
  EXPECT_GT(plain_error, 1e-6) << "plain summation drifts, so this test would see it";

  // The impulse of one further tick, as the difference of two such sums.
  ImpulseDifferences differences;
  std::vector<BodyImpulse> impulses(1);
  message.sequence = 1;
  differences.take(message, impulses);
  accumulator.add(0, wrench, kSumPeriod);
  accumulator.fill(message, 1);
  message.sequence = 2;
  differences.take(message, impulses);
  EXPECT_NEAR(impulses[0].linear.x(), tick_impulse, 7.3e-12);
}

TEST(ImpulseSums, WhatCannotBeSummedIsCounted) {
  ImpulseAccumulator accumulator;
  const Wrench wrench{Vector3(1.0, 0.0, 0.0), Vector3::Zero()};
  accumulator.add(-1, wrench, kSumPeriod);
  accumulator.add(kMaxMovingBodies, wrench, kSumPeriod);
  accumulator.add(0, {Vector3(std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0), Vector3::Zero()}, kSumPeriod);
  accumulator.add(0, {Vector3::Zero(), Vector3(0.0, std::numeric_limits<double>::infinity(), 0.0)}, kSumPeriod);
  accumulator.add(0, wrench, std::numeric_limits<double>::infinity());
  EXPECT_EQ(accumulator.dropped(), 5U);
  accumulator.add(kMaxMovingBodies - 1, wrench, kSumPeriod);
  EXPECT_EQ(accumulator.dropped(), 5U);
  ImpulseSums message;
  accumulator.fill(message, 100'000);
  EXPECT_EQ(message.body_count, kMaxMovingBodies);
  EXPECT_EQ(message.bodies[0].linear.x, 0.0);
  EXPECT_EQ(message.bodies[kMaxMovingBodies - 1].linear.x, kSumPeriod);
  accumulator.fill(message, -3);
  EXPECT_EQ(message.body_count, 0);
}

TEST(ImpulseSums, MessageAndCallerMayHoldDifferentNumbersOfBodies) {
  ImpulseAccumulator accumulator;
  accumulator.add(0, {Vector3(1.0, 0.0, 0.0), Vector3::Zero()}, 1.0);
  accumulator.add(1, {Vector3(2.0, 0.0, 0.0), Vector3::Zero()}, 1.0);
  ImpulseSums message;
  message.sequence = 1;
  accumulator.fill(message, 2);
  ImpulseDifferences short_reader, long_reader;
  std::vector<BodyImpulse> one(1), three(3);
  three[2].linear.setConstant(7.0);
  EXPECT_TRUE(short_reader.take(message, one));
  EXPECT_TRUE(long_reader.take(message, three));
  EXPECT_EQ(one[0].linear.x(), 1.0);
  EXPECT_EQ(three[1].linear.x(), 2.0);
  EXPECT_EQ(three[2].linear, Vector3::Zero());
}

TEST(ImpulseSums, TwoThreadsThroughTheLatestValueApplyEachImpulseOnce) {
  constexpr std::uint64_t kTicks = 100'000;
  const auto exchange = std::make_unique<LatestValue<ImpulseSums>>();
  std::thread haptics([&] {
    ImpulseAccumulator accumulator;
    for (std::uint64_t tick = 1; tick <= kTicks; ++tick) {
      accumulator.add(static_cast<int>(tick % 2), {Vector3(0.5, 0.0, 0.0), Vector3::Zero()}, 1.0);
      ImpulseSums& message = exchange->begin_write();
      message.sequence = tick;
      accumulator.fill(message, 2);
      exchange->publish();
    }
  });
  ImpulseDifferences differences;
  std::vector<BodyImpulse> impulses(2);
  double applied = 0.0;
  while (exchange->get().sequence < kTicks) {
    if (!exchange->update()) std::this_thread::yield();
    differences.take(exchange->get(), impulses);
    applied += impulses[0].linear.x() + impulses[1].linear.x();
  }
  haptics.join();
  EXPECT_EQ(applied, 0.5 * static_cast<double>(kTicks)) << "exact: halves add up without rounding";
}

TEST(ImpulseSums, AllocatesNothing) {
  const auto accumulator = std::make_unique<ImpulseAccumulator>();
  const auto differences = std::make_unique<ImpulseDifferences>();
  const auto message = std::make_unique<ImpulseSums>();
  std::vector<BodyImpulse> impulses(kMaxMovingBodies);
  const test::AllocationCounter counter;
  for (std::uint64_t tick = 1; tick <= 100; ++tick) {
    accumulator->add(7, {Vector3(1.0, 0.0, 0.0), Vector3::Zero()}, kSumPeriod);
    accumulator->fill(*message, kMaxMovingBodies);
    message->sequence = tick;
    differences->take(*message, impulses);
  }
  EXPECT_EQ(counter.count(), 0U);
}

}  // namespace
}  // namespace tegotae
