// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/frame_maker.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

namespace tegotae {
namespace {

TickRecord tick(double time, double tick_us = 5.0) {
  TickRecord record;
  record.time = time;
  record.tick_us = tick_us;
  record.displayed.force.z = time;
  return record;
}

MovingBodies bodies_at(double time, std::uint64_t steps) {
  MovingBodies bodies;
  bodies.time = time;
  bodies.steps = steps;
  bodies.step_duration = 2e-3;
  bodies.count = 2;
  return bodies;
}

struct Rig {
  Rig() : frames(SessionSettings{}, Vector3::Zero()) {}
  // One tick a millisecond, from `begin` to `end` (ms).
  void run(int begin, int end) {
    for (int i = begin; i < end; ++i) frames.add(tick(1e-3 * i));
  }
  ViewFrame frame(double time = 0.0, std::uint64_t steps = 1) { return frames.frame(contacts, bodies_at(time, steps)); }

  FrameMaker frames;
  ContactView contacts;
};

TEST(FrameMaker, ShowsTheNewestTickAndTheSamplesOfFiftyMilliseconds) {
  Rig rig;
  rig.run(0, 1000);
  const ViewFrame frame = rig.frame();
  EXPECT_EQ(frame.n, 1u);
  EXPECT_EQ(rig.frame().n, 2u);
  EXPECT_DOUBLE_EQ(frame.time, 0.999);
  EXPECT_EQ(frame.displayed.force.z, 0.999);
  ASSERT_NEAR(static_cast<double>(frame.samples.size()), 51.0, 1.0);
  EXPECT_NEAR(frame.samples.front().time, 0.949, 1e-9);
  EXPECT_EQ(frame.samples.back().displayed.force.z, 0.999);
  EXPECT_EQ(frame.bodies.size(), 2u);
}

TEST(FrameMaker, MeasuresTheRatesOfTheLastSecond) {
  Rig rig;
  rig.run(0, 3000);
  EXPECT_NEAR(rig.frame().numbers.haptic_rate, 1000.0, 1e-6);
  for (int i = 0; i <= 200; ++i) rig.frame(0.01 * i, 5 * static_cast<std::uint64_t>(i));
  EXPECT_NEAR(rig.frame(2.01, 1005).numbers.physics_rate, 500.0, 1.0);
}

TEST(FrameMaker, CountsMissedPeriodsByTheGaps) {
  Rig rig;
  rig.run(0, 100);
  rig.run(103, 200);
  rig.run(201, 300);
  EXPECT_EQ(rig.frame().numbers.missed, 4u);
  EXPECT_EQ(rig.frame().numbers.ticks, 296u);
}

TEST(FrameMaker, TellsTickTimesByPercentileAndHistogram) {
  Rig rig;
  for (int i = 0; i < 990; ++i) rig.frames.add(tick(1e-3 * i, 5.0));
  for (int i = 990; i < 1000; ++i) rig.frames.add(tick(1e-3 * i, 50.0));
  const ViewedNumbers numbers = rig.frame().numbers;
  EXPECT_NEAR(numbers.tick_median_us, 5.0, 0.05);
  EXPECT_NEAR(numbers.tick_p999_us, 50.0, 0.5);
  EXPECT_NEAR(numbers.tick_max_us, 50.0, 1e-9);
  const ViewedHistogram histogram = rig.frames.histogram();
  ASSERT_EQ(histogram.edges_us.size(), histogram.counts.size() + 1);
  EXPECT_EQ(std::accumulate(histogram.counts.begin(), histogram.counts.end(), std::uint64_t{0}), 1000u);
  for (size_t i = 0; i < histogram.counts.size(); ++i) {
    const bool has_five = histogram.edges_us[i] <= 5.0 && 5.0 < histogram.edges_us[i + 1];
    const bool has_fifty = histogram.edges_us[i] <= 50.0 && 50.0 < histogram.edges_us[i + 1];
    EXPECT_EQ(histogram.counts[i], has_five ? 990u : has_fifty ? 10u : 0u) << histogram.edges_us[i];
  }
}

TEST(FrameMaker, WhatIsBeyondTheHistogramCountsAtItsEnds) {
  Rig rig;
  rig.frames.add(tick(0.0, 0.0));
  rig.frames.add(tick(1e-3, 1e9));
  const ViewedHistogram histogram = rig.frames.histogram();
  EXPECT_EQ(histogram.counts.front(), 1u);
  EXPECT_EQ(histogram.counts.back(), 1u);
}

TEST(FrameMaker, KeepsWhatTheSafetyStageDidForFiftyMilliseconds) {
  Rig rig;
  TickRecord record = tick(0.0);
  record.safety_events = 6;
  rig.frames.add(record);
  rig.run(1, 40);
  EXPECT_EQ(rig.frame().numbers.safety_events, 6u);
  rig.run(40, 80);
  EXPECT_EQ(rig.frame().numbers.safety_events, 0u);
}

// A rendering that gives more than a spring may: it pushes harder on the way out than on the way in.
TEST(FrameMaker, SumsTheEnergyGivenOverAllSettings) {
  Rig rig;
  const auto press = [&](double begin) {
    for (int i = 0; i <= 200; ++i) {
      TickRecord record = tick(begin + 1e-3 * i);
      const double depth = 1e-3 * (100 - std::abs(i - 100)) / 100.0;
      record.X_WT.p.z = -depth;
      record.deepest = depth;
      record.active = depth > 0.0 ? 1 : 0;
      record.displayed.force.z = (i < 100 ? 1000.0 : 3000.0) * depth;
      rig.frames.add(record);
    }
  };
  press(0.0);
  const double once = rig.frame().numbers.energy;
  EXPECT_GT(once, 0.5e-3);
  rig.frames.change(SessionSettings{});
  press(0.3);
  EXPECT_NEAR(rig.frame().numbers.energy, 2.0 * once, 1e-9);
}

// Pressed, then set anew to what it was, then let go: a spring has given back what it took.
TEST(FrameMaker, ASettingThatChangesInAContactGivesNoEnergyByItself) {
  Rig rig;
  for (int i = 0; i <= 2000; ++i) {
    if (i == 1000) rig.frames.change(SessionSettings{});
    TickRecord record = tick(1e-3 * i);
    const double depth = 1e-2 * (1000 - std::abs(i - 1000)) / 1000.0;
    record.X_WT.p.z = -depth;
    record.displayed.force.z = SessionSettings{}.stiffness * depth;
    rig.frames.add(record);
  }
  constexpr double kStored = 0.05;  // J, in the spring as it was set anew
  EXPECT_LT(rig.frame().numbers.energy, 1e-3 * kStored);
}

TEST(FrameMaker, FramesOfARunThatStandsStillCountItsLastStepOnce) {
  Rig rig;
  rig.run(0, 1000);
  MovingBodies bodies = bodies_at(0.5, 250);
  bodies.step_duration = 1e-3;
  for (const std::uint64_t step : {249, 250, 251}) {
    bodies.steps = step;
    rig.frames.frame(rig.contacts, bodies);
  }
  bodies.step_duration = 8e-3;
  bodies.steps = 252;
  for (int i = 0; i < 100; ++i) rig.frames.frame(rig.contacts, bodies);
  EXPECT_NEAR(rig.frames.frame(rig.contacts, bodies).numbers.physics_step_ms, 1.0, 0.02);
}

}  // namespace
}  // namespace tegotae
