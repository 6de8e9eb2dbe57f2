// SPDX-License-Identifier: Apache-2.0
#include <tegotae/runtime/duration_histogram.hpp>

#include <tests/allocation_counter.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <memory>
#include <random>
#include <vector>

namespace tegotae {
namespace {

constexpr double kFractions[] = {0.0, 0.001, 0.1, 0.25, 0.5, 0.75, 0.9, 0.99, 0.999, 0.9999, 1.0};

// The nearest-rank percentile of all values.
double sorted_percentile(const std::vector<double>& sorted, double fraction) {
  const auto rank = static_cast<std::size_t>(std::ceil(fraction * static_cast<double>(sorted.size())));
  return sorted[std::clamp<std::size_t>(rank, 1, sorted.size()) - 1];
}

void expect_agrees(const DurationHistogram& histogram, std::vector<double> values) {
  std::sort(values.begin(), values.end());
  ASSERT_EQ(histogram.count(), values.size());
  EXPECT_EQ(histogram.min(), values.front());
  EXPECT_EQ(histogram.max(), values.back());
  for (const double fraction : kFractions) {
    const double exact = sorted_percentile(values, fraction);
    EXPECT_LE(std::abs(histogram.percentile(fraction) - exact), 0.01 * exact) << "fraction " << fraction;
  }
}

std::vector<double> sample(const std::function<double()>& distribution, int count) {
  std::vector<double> values(static_cast<std::size_t>(count));
  std::generate(values.begin(), values.end(), distribution);
  return values;
}

// Shapes of durations: spread over all octaves, a tick with a long tail, two modes, almost constant.
std::vector<std::vector<double>> samples(unsigned seed, int count) {
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> decade(std::log10(50e-9), 1.0), uniform(0.0, 1.0);
  std::lognormal_distribution<double> tail(std::log(15e-6), 0.7);
  std::normal_distribution<double> constant(1e-3, 1e-8);
  return {sample([&] { return std::pow(10.0, decade(random)); }, count),
          sample([&] { return std::max(50e-9, tail(random)); }, count),
          sample([&] { return uniform(random) < 0.998 ? 4e-6 : 90e-3 * (1.0 + uniform(random)); }, count),
          sample([&] { return constant(random); }, count)};
}

TEST(DurationHistogram, PercentilesAgreeWithSortedValues) {
  for (const int count : {1, 2, 3, 10, 1000, 20'000}) {
    for (unsigned seed = 0; seed < 5; ++seed) {
      for (const auto& values : samples(seed, count)) {
        DurationHistogram histogram;
        for (const double value : values) histogram.add(value);
        expect_agrees(histogram, values);
      }
    }
  }
}

TEST(DurationHistogram, RelativeErrorIsBoundedAtEveryDuration) {
  double worst = 0.0;
  constexpr int kSteps = 20'000;
  for (int i = 0; i <= kSteps; ++i) {
    const double exact = 50e-9 * std::pow(10.0 / 50e-9, static_cast<double>(i) / kSteps);
    DurationHistogram histogram;
    histogram.add(50e-9);  // so that min and max do not give the value away
    histogram.add(exact);
    histogram.add(13.0);
    worst = std::max(worst, std::abs(histogram.median() - exact) / exact);
  }
  EXPECT_LE(worst, 1.0 / 128.0 + 1e-12);
  EXPECT_GT(worst, 1.0 / 256.0) << "the sweep meets the edges of buckets";
}

TEST(DurationHistogram, MergedIsAllInOne) {
  const auto parts = samples(7, 3000);
  DurationHistogram merged, all_in_one;
  std::vector<double> values;
  merged.merge(DurationHistogram());
  for (const auto& part : parts) {
    DurationHistogram one;
    for (const double value : part) {
      one.add(value);
      all_in_one.add(value);
    }
    merged.merge(one);
    values.insert(values.end(), part.begin(), part.end());
  }
  merged.merge(DurationHistogram());
  expect_agrees(merged, values);
  for (const double fraction : kFractions) EXPECT_EQ(merged.percentile(fraction), all_in_one.percentile(fraction));
}

TEST(DurationHistogram, EmptyAnswersZero) {
  const DurationHistogram histogram;
  EXPECT_EQ(histogram.count(), 0U);
  EXPECT_EQ(histogram.min(), 0.0);
  EXPECT_EQ(histogram.max(), 0.0);
  EXPECT_EQ(histogram.median(), 0.0);
}

TEST(DurationHistogram, OutOfRangeDurationsAreCountedAtTheEnds) {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  DurationHistogram histogram;
  for (const double value : {-kInfinite, -1.0, 0.0, 1e-12, 1e-6, 100.0, kInfinite}) histogram.add(value);
  histogram.add(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(histogram.count(), 8U);
  EXPECT_EQ(histogram.min(), -kInfinite);
  EXPECT_EQ(histogram.max(), kInfinite);
  EXPECT_NEAR(histogram.percentile(0.5), 50e-9, 1e-9);
  EXPECT_NEAR(histogram.percentile(5.0 / 8.0), 1e-6, 1e-8);
  EXPECT_GT(histogram.percentile(6.0 / 8.0), 10.0);
  EXPECT_GT(histogram.percentile(2.0), 10.0) << "a fraction above 1 is 1";
}

TEST(DurationHistogram, AddingAllocatesNothing) {
  const auto histogram = std::make_unique<DurationHistogram>();
  const test::AllocationCounter counter;
  for (int i = 0; i < 1000; ++i) histogram->add(1e-6 * i);
  const double median = histogram->median();
  EXPECT_EQ(counter.count(), 0U);
  EXPECT_GT(median, 0.0);
}

}  // namespace
}  // namespace tegotae
