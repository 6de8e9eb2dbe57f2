// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/kept_guard.hpp>

#include <tests/device/waiting.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>

#include <atomic>
#include <string>

namespace tegotae {
namespace {

using ::testing::HasSubstr;

// Waits for its owner, as a guard does.
const GuardProgram kSleeper = {"/bin/sh", {"-c", "cat >/dev/null"}};

void never_called() { ADD_FAILURE() << "a guard could be kept"; }

TEST(KeptGuard, OneThatWasEndedOrStoppedIsReplacedAndTold) {
  for (const int signal : {SIGKILL, SIGSTOP}) {
    pid_t second = 0;
    {
      KeptGuard guard(kSleeper, never_called);
      const pid_t first = guard.pid();
      EXPECT_TRUE(guard.take_news().empty());
      kill(first, signal);
      ASSERT_TRUE(test::comes_true([&] { return guard.pid() != first; })) << signal;
      second = guard.pid();
      EXPECT_EQ(kill(first, 0), -1) << "it is gone";
      EXPECT_EQ(kill(second, 0), 0);
      const std::vector<std::string> news = guard.take_news();
      ASSERT_EQ(news.size(), 1U);
      EXPECT_THAT(news[0], HasSubstr("another was started"));
      EXPECT_TRUE(guard.take_news().empty()) << "told once";
      EXPECT_FALSE(guard.has_failed());
    }
    EXPECT_EQ(kill(second, 0), -1) << "it was waited for";
  }
}

TEST(KeptGuard, GuardsThatEndAtOnceAreGivenUpAndSaidOnce) {
  std::atomic<int> failures{0};
  KeptGuard guard({"/bin/sh", {"-c", "exit 0"}}, [&] { ++failures; });
  ASSERT_TRUE(test::comes_true([&] { return failures > 0; }));
  EXPECT_TRUE(guard.has_failed());
  const std::vector<std::string> news = guard.take_news();
  ASSERT_FALSE(news.empty());
  EXPECT_THAT(news.back(), HasSubstr("no other can be kept"));
  EXPECT_EQ(failures, 1);
}

TEST(KeptGuard, AProgramThatIsNotThereIsRefused) {
  EXPECT_THROW(KeptGuard({"/no/such/program", {}}, never_called), InterfaceError);
}

}  // namespace
}  // namespace tegotae
