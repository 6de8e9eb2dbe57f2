// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/decay_judge.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>

namespace tegotae {
namespace {

DecayJudge judged(const std::function<double(double)>& speed, double begin = 0.5) {
  DecayJudge judge(begin);
  for (int i = 0; i <= 10000; ++i) {
    if (!judge.add(1e-3 * i, std::abs(speed(1e-3 * i)))) break;
  }
  return judge;
}

double oscillation(double time, double rate) { return 1e-3 * std::exp(rate * time) * std::cos(170.0 * time); }

TEST(DecayJudge, PassesWhatDecaysAndRefusesWhatGrowsOrStays) {
  EXPECT_TRUE(judged([](double t) { return oscillation(t, -1.0); }).decayed());
  EXPECT_TRUE(judged([](double t) { return oscillation(t, -0.05); }).decayed());
  EXPECT_FALSE(judged([](double t) { return oscillation(t, 0.0); }).decayed());
  EXPECT_FALSE(judged([](double t) { return oscillation(t, 0.05); }).decayed());
}

TEST(DecayJudge, ItsThresholdIsTheRateStated) {
  // ln(1/0.9) over the four seconds between the windows.
  const double rate = std::log(1.0 / DecayJudge::kShrink) / 4.0;
  EXPECT_TRUE(judged([&](double t) { return oscillation(t, -1.05 * rate); }).decayed());
  EXPECT_FALSE(judged([&](double t) { return oscillation(t, -0.95 * rate); }).decayed());
}

TEST(DecayJudge, RestIsStableAndSmallNoiseAtRestToo) {
  EXPECT_TRUE(judged([](double) { return 0.0; }).decayed());
  EXPECT_TRUE(judged([](double t) { return 0.9 * DecayJudge::kStill * std::sin(300.0 * t); }).decayed());
  EXPECT_FALSE(judged([](double) { return 1.1 * DecayJudge::kStill; }).decayed());
}

TEST(DecayJudge, WhatHappensBeforeTheTouchHasEndedDoesNotCount) {
  EXPECT_FALSE(judged([](double t) { return t < 0.5 ? 0.05 : 1e-3; }).decayed());
  EXPECT_NEAR(judged([](double t) { return t < 0.5 ? 0.05 : 1e-3; }).first_speed(), 1e-3, 1e-15);
}

TEST(DecayJudge, EndsAtOnceWhereThereIsNoDoubt) {
  DecayJudge judge(0.5);
  EXPECT_TRUE(judge.add(0.0, 0.09));
  EXPECT_FALSE(judge.add(0.1, 0.11));
  EXPECT_FALSE(judge.decayed());
  DecayJudge lost(0.5);
  EXPECT_FALSE(lost.add(0.0, std::numeric_limits<double>::quiet_NaN()));
  EXPECT_FALSE(lost.decayed());
}

TEST(DecayJudge, ARunThatWasTooShortIsNotPassed) {
  DecayJudge judge(0.5);
  for (int i = 0; i < 3000; ++i) judge.add(1e-3 * i, 0.0);
  EXPECT_FALSE(judge.decayed());
}

}  // namespace
}  // namespace tegotae
