// SPDX-License-Identifier: Apache-2.0
#include <tegotae/runtime/latest_value.hpp>
#include <tegotae/runtime/statistics.hpp>

#include <gtest/gtest.h>

#include <memory>
#include <thread>

namespace tegotae {
namespace {

TEST(TickStatistics, KeepsDurationsStalenessAndMissedDeadlinesApart) {
  TickStatistics statistics;
  for (int i = 0; i < 99; ++i) statistics.add(10e-6, 20e-3);
  statistics.add(3e-3, 100e-3, 2);
  EXPECT_EQ(statistics.count(), 100U);
  EXPECT_EQ(statistics.missed_deadlines, 2U);
  EXPECT_NEAR(statistics.durations.median(), 10e-6, 0.1e-6);
  EXPECT_EQ(statistics.durations.max(), 3e-3);
  EXPECT_NEAR(statistics.staleness.median(), 20e-3, 0.2e-3);
  EXPECT_EQ(statistics.staleness.max(), 100e-3);
}

TEST(TickStatistics, MergesAllThree) {
  TickStatistics a, b;
  a.add(1e-6, 1e-3, 1);
  b.add(3e-6, 5e-3, 4);
  b.add(3e-6, 5e-3);
  a.merge(b);
  EXPECT_EQ(a.count(), 3U);
  EXPECT_EQ(a.missed_deadlines, 5U);
  EXPECT_EQ(a.durations.max(), 3e-6);
  EXPECT_EQ(a.staleness.min(), 1e-3);
  EXPECT_EQ(a.staleness.max(), 5e-3);
}

TEST(TickStatistics, CanBeWatchedFromAnotherThreadThroughALatestValue) {
  constexpr std::uint64_t kTicks = 2000;
  const auto exchange = std::make_unique<LatestValue<TickStatistics>>();
  std::thread loop([&] {
    TickStatistics statistics;
    for (std::uint64_t i = 0; i < kTicks; ++i) {
      statistics.add(1e-6, 1e-3);
      exchange->write(statistics);
    }
  });
  std::uint64_t seen = 0;
  while (seen < kTicks) {
    if (!exchange->update()) std::this_thread::yield();
    const TickStatistics& statistics = exchange->get();
    EXPECT_GE(statistics.count(), seen);
    EXPECT_EQ(statistics.count(), statistics.staleness.count());
    seen = statistics.count();
  }
  loop.join();
}

}  // namespace
}  // namespace tegotae
