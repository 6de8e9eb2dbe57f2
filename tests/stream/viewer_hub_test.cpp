// SPDX-License-Identifier: Apache-2.0
#include <tegotae/stream/viewer_hub.hpp>

#include <tests/stream/served.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace tegotae {
namespace {

using test::shared;
using ::testing::ElementsAre;
using ::testing::IsEmpty;

class ViewerHubTest : public ::testing::Test {
 protected:
  // Who was woken since the last call.
  std::vector<ViewerId> woken() { return std::exchange(woken_, {}); }

  std::string next(ViewerId viewer) {
    const ViewerOutbox::Next next = hub_.next(viewer);
    if (const auto* text = std::get_if<SharedText>(&next)) return **text;
    if (const auto* order = std::get_if<CloseOrder>(&next)) return "close: " + order->reason;
    return "";
  }

  ViewerServerOptions options_ = [] {
    ViewerServerOptions options;
    options.max_viewers = 2;
    options.max_waiting_messages = 2;
    return options;
  }();
  std::vector<ViewerId> woken_;
  ViewerHub hub_{options_, [this](const std::vector<ViewerId>& viewers) {
                   woken_.insert(woken_.end(), viewers.begin(), viewers.end());
                 }};
};

TEST_F(ViewerHubTest, WakesOnceForAllThatWaits) {
  EXPECT_EQ(hub_.enter(), 1U);
  hub_.send(1, shared("greeting"));
  hub_.publish(shared("s1"));
  hub_.publish(shared("s2"));
  EXPECT_THAT(woken(), ElementsAre(1));
  EXPECT_EQ(next(1), "greeting");
  hub_.publish(shared("s3"));
  EXPECT_EQ(next(1), "s3");
  EXPECT_THAT(woken(), IsEmpty());  // who sends asks by itself for what is next
  EXPECT_EQ(next(1), "");
  hub_.publish(shared("s4"));
  EXPECT_THAT(woken(), ElementsAre(1));
}

TEST_F(ViewerHubTest, HasPlaceForSoManyAndUsesNoNumberTwice) {
  EXPECT_EQ(hub_.enter(), 1U);
  EXPECT_EQ(hub_.enter(), 2U);
  EXPECT_TRUE(hub_.full());
  EXPECT_FALSE(hub_.enter());
  hub_.left(1);
  EXPECT_EQ(hub_.enter(), 3U);
  EXPECT_EQ(hub_.count(), 2U);
}

TEST_F(ViewerHubTest, StrangersGetNothingButTheirGreeting) {
  hub_.enter();
  hub_.enter();
  hub_.send(2, shared("greeting"));
  hub_.publish(shared("state"));
  hub_.send_all(shared("notice"));
  hub_.send(7, shared("to nobody"));
  EXPECT_THAT(woken(), ElementsAre(2));
  EXPECT_EQ(next(1), "");
  EXPECT_EQ(next(2), "greeting");
  EXPECT_EQ(next(2), "state");
  EXPECT_EQ(next(2), "notice");
}

TEST_F(ViewerHubTest, TooMuchWaitingCloses) {
  hub_.enter();
  for (int i = 0; i < 2; ++i) hub_.send(1, shared("m"));
  EXPECT_FALSE(hub_.closing(1));
  woken();
  hub_.send(1, shared("m"));
  EXPECT_TRUE(hub_.closing(1));
  EXPECT_THAT(woken(), ElementsAre(1));  // a text may be in flight that never arrives
  EXPECT_EQ(next(1), "close: too slow: too much waits to be read");
}

TEST_F(ViewerHubTest, TheOwnerCloses) {
  hub_.enter();
  hub_.close(1, CloseCode::kPolicy, "manners");
  hub_.close(1, CloseCode::kPolicy, "again");
  hub_.close(7, CloseCode::kPolicy, "nobody");
  EXPECT_THAT(woken(), ElementsAre(1));
  EXPECT_EQ(next(1), "close: manners");
}

TEST_F(ViewerHubTest, AfterTheEndNobodyJoins) {
  hub_.enter();
  hub_.finish(shared("last"));
  hub_.finish(shared("again"));
  EXPECT_THAT(woken(), ElementsAre(1));
  EXPECT_EQ(next(1), "last");
  EXPECT_EQ(next(1), "close: the server ends");
  EXPECT_FALSE(hub_.enter());
}

TEST_F(ViewerHubTest, TellsTheOwnerAndCountsWhatItThrows) {
  std::vector<std::string> told;
  hub_.set_events({[&](ViewerId id) { told.push_back("joined " + std::to_string(id)); },
                   [&](ViewerId, std::string_view text) {
                     told.emplace_back(text);
                     throw std::runtime_error("callback");
                   },
                   {}});
  hub_.joined(1);
  hub_.received(1, "a");
  hub_.received(1, "b");
  hub_.left(1);
  EXPECT_THAT(told, ElementsAre("joined 1", "a", "b"));
  EXPECT_EQ(hub_.callback_failures(), 2U);
}

}  // namespace
}  // namespace tegotae
