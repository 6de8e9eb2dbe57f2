// SPDX-License-Identifier: Apache-2.0
#include <tegotae/stream/viewer_outbox.hpp>

#include <tests/stream/served.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace tegotae {
namespace {

using test::shared;

// All that goes, in order; a close order as "close CODE", once.
std::vector<std::string> drain(ViewerOutbox& outbox) {
  std::vector<std::string> all;
  for (;;) {
    const ViewerOutbox::Next next = outbox.next();
    if (const auto* text = std::get_if<SharedText>(&next)) {
      all.push_back(**text);
    } else {
      if (const auto* order = std::get_if<CloseOrder>(&next)) {
        all.push_back("close " + std::to_string(static_cast<int>(order->code)));
      }
      return all;
    }
  }
}

TEST(ViewerOutbox, OfStatesOnlyTheNewestWaitsInItsPlace) {
  ViewerOutbox outbox(10, 1000);
  outbox.publish(shared("s1"));
  EXPECT_TRUE(outbox.send(shared("m1")));
  outbox.publish(shared("s2"));
  EXPECT_TRUE(outbox.send(shared("m2")));
  EXPECT_THAT(drain(outbox), ::testing::ElementsAre("m1", "s2", "m2"));
  EXPECT_THAT(drain(outbox), ::testing::IsEmpty());
}

TEST(ViewerOutbox, MessagesAreLimitedInNumberAndSize) {
  ViewerOutbox few(2, 1000);
  few.publish(shared("state"));
  EXPECT_TRUE(few.send(shared("m1")));
  EXPECT_TRUE(few.send(shared("m2")));
  EXPECT_FALSE(few.send(shared("m3")));
  EXPECT_THAT(drain(few), ::testing::ElementsAre("state", "m1", "m2"));
  EXPECT_TRUE(few.send(shared("m4")));

  ViewerOutbox small(10, 5);
  EXPECT_TRUE(small.send(shared("longer than all that may wait")));
  EXPECT_FALSE(small.send(shared("m")));
  drain(small);
  EXPECT_EQ(small.waiting_bytes(), 0U);
  EXPECT_TRUE(small.send(shared("m")));
  EXPECT_EQ(small.waiting_bytes(), 1U);
}

TEST(ViewerOutbox, ACloseDropsWhatWaits) {
  ViewerOutbox outbox(2, 1000);
  EXPECT_TRUE(outbox.send(shared("m1")));
  outbox.publish(shared("state"));
  outbox.close({CloseCode::kPolicy, "why"});
  EXPECT_TRUE(outbox.closing());
  EXPECT_TRUE(outbox.send(shared("m2")));
  outbox.publish(shared("state"));
  outbox.finish(shared("last"), {CloseCode::kGoingAway, "the end"});
  EXPECT_THAT(drain(outbox), ::testing::ElementsAre("close 1008"));
}

TEST(ViewerOutbox, AtTheEndMessagesGoFirstAndStatesDoNot) {
  ViewerOutbox outbox(1, 1000);
  EXPECT_TRUE(outbox.send(shared("m1")));
  outbox.publish(shared("state"));
  outbox.finish(shared("last"), {CloseCode::kGoingAway, "the end"});
  EXPECT_TRUE(outbox.send(shared("after")));
  EXPECT_THAT(drain(outbox), ::testing::ElementsAre("m1", "last", "close 1001"));
  ViewerOutbox without(1, 1000);
  without.finish(nullptr, {CloseCode::kGoingAway, "the end"});
  EXPECT_THAT(drain(without), ::testing::ElementsAre("close 1001"));
}

}  // namespace
}  // namespace tegotae
