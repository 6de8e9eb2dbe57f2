// SPDX-License-Identifier: Apache-2.0
#include <tegotae/runtime/realtime_thread.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pthread.h>
#include <sched.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <thread>

namespace tegotae {
namespace {

using ::testing::HasSubstr;

struct Scheduling {
  int policy = 0;
  int priority = 0;
};

Scheduling scheduling_of_this_thread() {
  sched_param parameters{};
  Scheduling scheduling;
  pthread_getschedparam(pthread_self(), &scheduling.policy, &parameters);
  scheduling.priority = parameters.sched_priority;
  return scheduling;
}

void expect_consistent(const RealtimeRights& rights) {
  EXPECT_EQ(rights.explanation.empty(), rights.fifo && rights.memory_locked);
  if (!rights.fifo) {
    EXPECT_THAT(rights.explanation, HasSubstr("SCHED_FIFO"));
  }
  if (!rights.memory_locked) {
    EXPECT_THAT(rights.explanation, HasSubstr("Locked memory"));
  }
  if (!rights.explanation.empty()) {
    // Who is root already is not told to use sudo.
    EXPECT_THAT(rights.explanation, HasSubstr("Mend:"));
    EXPECT_THAT(rights.explanation, HasSubstr(geteuid() == 0 ? "the container or service" : "sudo"));
  }
}

TEST(RealtimeThread, ReportsWhatTheSystemDid) {
  std::thread thread([] {
    const RealtimeRights rights = request_realtime(1);
    const Scheduling scheduling = scheduling_of_this_thread();
    release_realtime();
    expect_consistent(rights);
    EXPECT_EQ(scheduling.policy == SCHED_FIFO, rights.fifo);
    EXPECT_EQ(scheduling.priority, rights.fifo ? 1 : 0);
    EXPECT_EQ(scheduling_of_this_thread().policy, SCHED_OTHER);
  });
  thread.join();
}

TEST(RealtimeThread, PriorityIsClampedToWhatTheSystemHas) {
  std::thread thread([] {
    const RealtimeRights rights = request_realtime(1000);
    const Scheduling scheduling = scheduling_of_this_thread();
    release_realtime();
    if (rights.fifo) {
      EXPECT_EQ(scheduling.priority, sched_get_priority_max(SCHED_FIFO));
    }
  });
  thread.join();
}

// What a user without rights gets: in a process of its own, as rights are not given back once they are gone.
TEST(RealtimeThreadDeathTest, WithoutPrivilegesItGoesOnAndSaysHowToMendIt) {
  GTEST_FLAG_SET(death_test_style, "fast");
  const auto unprivileged = [] {
    const rlimit none{0, 0};
    setrlimit(RLIMIT_RTPRIO, &none);
    setrlimit(RLIMIT_MEMLOCK, &none);
    if (geteuid() == 0 && setresuid(65534, 65534, 65534) != 0) _exit(3);
    const RealtimeRights rights = request_realtime(kHapticPriority);
    expect_consistent(rights);
    EXPECT_FALSE(rights.fifo);
    EXPECT_FALSE(rights.memory_locked);
    EXPECT_THAT(rights.explanation, HasSubstr("rtprio"));
    EXPECT_THAT(rights.explanation, HasSubstr("memlock"));
    _exit(::testing::Test::HasFailure() ? 1 : 0);
  };
  EXPECT_EXIT(unprivileged(), ::testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace tegotae
