// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/live_inbox.hpp>

#include <gtest/gtest.h>

#include <string>
#include <thread>

namespace tegotae {
namespace {

std::string hand_at(double x) { return R"({"type": "hand", "pose": [)" + std::to_string(x) + ", 0, 0, 1, 0, 0, 0]}"; }

const viewer_command::Hand* hand_of(const LiveInbox::Event& event) {
  const auto* command = std::get_if<ViewerCommand>(&event.what);
  return command != nullptr ? std::get_if<viewer_command::Hand>(command) : nullptr;
}

TEST(LiveInbox, GivesAllOnceInItsOrder) {
  LiveInbox inbox;
  inbox.joined(3);
  inbox.received(3, R"({"type": "pause"})");
  inbox.received(3, "no JSON");
  inbox.left(3);
  const auto events = inbox.take();
  ASSERT_EQ(events.size(), 4u);
  EXPECT_TRUE(std::holds_alternative<LiveInbox::Joined>(events[0].what));
  EXPECT_TRUE(std::holds_alternative<ViewerCommand>(events[1].what));
  ASSERT_TRUE(std::holds_alternative<LiveInbox::Refused>(events[2].what));
  EXPECT_NE(std::get<LiveInbox::Refused>(events[2].what).why, "");
  EXPECT_TRUE(std::holds_alternative<LiveInbox::Left>(events[3].what));
  for (const auto& event : events) EXPECT_EQ(event.viewer, 3u);
  EXPECT_TRUE(inbox.take().empty());
}

TEST(LiveInbox, OfAHandsPosesOnlyTheNewestWaits) {
  LiveInbox inbox;
  for (int i = 0; i < 1000; ++i) inbox.received(1, hand_at(0.01 * i));
  inbox.received(2, hand_at(7.0));
  inbox.received(1, R"({"type": "release"})");
  const auto events = inbox.take();
  ASSERT_EQ(events.size(), 3u);
  ASSERT_NE(hand_of(events[0]), nullptr);
  EXPECT_DOUBLE_EQ(hand_of(events[0])->X_WT.p.x(), 9.99);
  ASSERT_NE(hand_of(events[1]), nullptr);
  EXPECT_EQ(events[1].viewer, 2u);
}

TEST(LiveInbox, IsBoundedAndLosesNobodyWhoComesOrGoes) {
  LiveInbox inbox;
  for (int i = 0; i < 100000; ++i) inbox.received(1, R"({"type": "step"})");
  inbox.left(1);
  inbox.joined(2);
  const auto events = inbox.take();
  EXPECT_LT(events.size(), 5000u);
  EXPECT_TRUE(std::holds_alternative<LiveInbox::Left>(events[events.size() - 2].what));
  EXPECT_TRUE(std::holds_alternative<LiveInbox::Joined>(events.back().what));
}

TEST(LiveInbox, IsFilledFromAnotherThread) {
  LiveInbox inbox;
  constexpr int kMessages = 5000;
  std::thread server([&] {
    for (ViewerId viewer = 1; viewer <= kMessages; ++viewer) inbox.joined(viewer);
  });
  ViewerId last = 0;
  while (last < kMessages) {
    for (const auto& event : inbox.take()) {
      ASSERT_EQ(event.viewer, last + 1);
      last = event.viewer;
    }
  }
  server.join();
}

}  // namespace
}  // namespace tegotae
