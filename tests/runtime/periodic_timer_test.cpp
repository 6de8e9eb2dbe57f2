// SPDX-License-Identifier: Apache-2.0
#include <tegotae/runtime/periodic_timer.hpp>

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <thread>

#include <pthread.h>

namespace tegotae {
namespace {

constexpr std::int64_t kMillisecond = 1'000'000;

TEST(MonotonicClock, DoesNotRunBackwards) {
  std::int64_t last = monotonic_nanoseconds();
  for (int i = 0; i < 100'000; ++i) {
    const std::int64_t now = monotonic_nanoseconds();
    ASSERT_GE(now, last);
    last = now;
  }
  EXPECT_DOUBLE_EQ(seconds_between(1'500'000'000, 1'500'250'000), 250e-6);
}

TEST(PeriodicTimer, PeriodOfARate) {
  EXPECT_EQ(PeriodicTimer::period_of(1000.0), kMillisecond);
  EXPECT_EQ(PeriodicTimer::period_of(20.0), 50 * kMillisecond);
  EXPECT_EQ(PeriodicTimer::period_of(3000.0), 333'333);
}

// Every period since the start is either answered or reported as missed, and never early: without drift, however late
// the machine wakes us.
TEST(PeriodicTimer, AnswersOrReportsEveryPeriod) {
  const std::int64_t before = monotonic_nanoseconds();
  PeriodicTimer timer(kMillisecond);
  const std::int64_t after = monotonic_nanoseconds();
  std::int64_t periods = 0, last_due = 0;
  for (int i = 0; i < 50; ++i) {
    const std::int64_t missed = timer.wait();
    ASSERT_GE(missed, 0);
    periods += 1 + missed;
    ASSERT_GE(timer.woken_at(), timer.due()) << "never early";
    ASSERT_LT(timer.woken_at() - timer.due(), kMillisecond) << "else a further period is missed";
    ASSERT_GT(timer.due(), last_due);
    last_due = timer.due();
    ASSERT_GE(timer.due(), before + periods * kMillisecond);
    ASSERT_LE(timer.due(), after + periods * kMillisecond);
  }
}

TEST(PeriodicTimer, CountsThePeriodsThatABusyCallerMissed) {
  PeriodicTimer timer(kMillisecond);
  timer.wait();
  std::this_thread::sleep_for(std::chrono::milliseconds(20));  // at least: so at least 19 deadlines pass in it
  EXPECT_GE(timer.wait(), 18);
}

TEST(PeriodicTimer, SignalsDoNotWakeItEarly) {
  struct sigaction action {};
  struct sigaction old {};
  action.sa_handler = [](int) {};
  sigaction(SIGUSR1, &action, &old);
  const pthread_t waiting = pthread_self();
  std::thread sender([waiting] {
    for (int i = 0; i < 10; ++i) {
      pthread_kill(waiting, SIGUSR1);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  });
  PeriodicTimer timer(20 * kMillisecond);
  timer.wait();
  EXPECT_GE(timer.woken_at(), timer.due());
  sender.join();
  sigaction(SIGUSR1, &old, nullptr);
}

TEST(PeriodicTimer, PeriodOfLessThanANanosecondIsOne) {
  PeriodicTimer timer(0);
  EXPECT_EQ(timer.period(), 1);
  EXPECT_GE(timer.wait(), 0);
}

}  // namespace
}  // namespace tegotae
