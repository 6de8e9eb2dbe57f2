// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/doctor_measure.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace tegotae {
namespace {

using ::testing::HasSubstr;

constexpr double kPeriod = 1e-3;  // s

// `common` (s), but for `rare` (s) in a part `share` of a thousand.
DurationHistogram durations(double common, double rare, int share) {
  DurationHistogram result;
  for (int i = 0; i < 1000; ++i) result.add(i < share ? rare : common);
  return result;
}

WakeUps wake_ups(const DurationHistogram& late, bool fifo) {
  WakeUps result;
  result.late = late;
  result.rights.fifo = fifo;
  result.missed = 3;
  return result;
}

TEST(DoctorMeasure, JudgesWakeUpsByTheirTail) {
  const Finding good = wake_up_finding(wake_ups(durations(5e-6, 400e-6, 1), true), kPeriod);
  EXPECT_EQ(good.verdict, Verdict::kOk) << good.found;
  EXPECT_THAT(good.found, testing::AllOf(HasSubstr("at 1000 Hz"), HasSubstr("worst 400.0 us of 1000"),
                                         HasSubstr("3 missed periods")));
  EXPECT_EQ(good.mend, "");
  const Finding fair = wake_up_finding(wake_ups(durations(5e-6, 2e-3, 5), true), kPeriod);
  EXPECT_EQ(fair.verdict, Verdict::kCouldBeBetter) << fair.found;
  EXPECT_THAT(fair.mend, HasSubstr("kernel"));
  const Finding bad = wake_up_finding(wake_ups(durations(5e-6, 2e-3, 20), false), kPeriod);
  EXPECT_EQ(bad.verdict, Verdict::kNotPossible) << bad.found;
  EXPECT_THAT(bad.mend, HasSubstr("scheduling")) << "without rights that comes first";
}

TEST(DoctorMeasure, JudgesTicksByThePeriod) {
  EXPECT_EQ(tick_finding(durations(20e-6, 3e-3, 1), kPeriod).verdict, Verdict::kOk);
  EXPECT_EQ(tick_finding(durations(20e-6, 0.9e-3, 5), kPeriod).verdict, Verdict::kCouldBeBetter);
  EXPECT_EQ(tick_finding(durations(20e-6, 0.9e-3, 20), kPeriod).verdict, Verdict::kCouldBeBetter);
  const Finding bad = tick_finding(durations(20e-6, 1.2e-3, 20), kPeriod);
  EXPECT_EQ(bad.verdict, Verdict::kNotPossible);
  EXPECT_THAT(bad.found, HasSubstr("the period is 1000 us"));
  EXPECT_NE(bad.mend, "");
  EXPECT_EQ(tick_finding(durations(20e-6, 1.2e-3, 20), 1e-2).verdict, Verdict::kOk) << "ten times the time";
}

TEST(DoctorMeasure, WakesAThreadOnceAPeriod) {
  std::vector<double> parts;
  const WakeUps measured = measure_wake_ups(kPeriod, 0.2, [&](double part) { parts.push_back(part); });
  // Those that nothing woke in may run over the end.
  EXPECT_GE(measured.late.count() + measured.missed, 200U);
  EXPECT_LE(measured.late.count(), 200U);
  EXPECT_GT(measured.late.max(), 0.0);
  ASSERT_FALSE(parts.empty());
  for (const double part : parts) EXPECT_LT(part, 1.0);
}

TEST(DoctorMeasure, RendersAShippedScene) {
  double last = 0.0;
  const DurationHistogram ticks = measure_ticks([&](double part) { last = part; });
  EXPECT_EQ(ticks.count(), 8001U);
  EXPECT_GT(ticks.median(), 0.0);
  EXPECT_GT(last, 0.9);
}

}  // namespace
}  // namespace tegotae
