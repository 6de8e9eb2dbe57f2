// SPDX-License-Identifier: Apache-2.0
#include <tegotae/stream/message_rate.hpp>

#include <gtest/gtest.h>

#include <chrono>

namespace tegotae {
namespace {

using namespace std::chrono_literals;

TEST(MessageRate, CountsInWindowsOfASecond) {
  MessageRate rate(3);
  const MessageRate::Time start{1h};
  EXPECT_TRUE(rate.count(start));
  EXPECT_TRUE(rate.count(start + 500ms));
  EXPECT_TRUE(rate.count(start + 999ms));
  EXPECT_FALSE(rate.count(start + 999ms));
  EXPECT_TRUE(rate.count(start + 1s));
}

TEST(MessageRate, AnEvenPaceIsAllowedForEver) {
  MessageRate rate(500);
  MessageRate::Time now{1h};
  for (int i = 0; i < 100'000; ++i, now += 2ms) ASSERT_TRUE(rate.count(now)) << i;
}

}  // namespace
}  // namespace tegotae
