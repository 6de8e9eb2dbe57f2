// SPDX-License-Identifier: Apache-2.0
#include <tegotae/runtime/mailbox.hpp>

#include <tests/allocation_counter.hpp>

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <thread>

namespace tegotae {
namespace {

// Counts those that live.
struct Counted {
  explicit Counted(int value) : number(value) { ++alive; }
  Counted(Counted&& other) noexcept : number(other.number) { ++alive; }
  Counted(const Counted&) = delete;
  Counted& operator=(const Counted&) = delete;
  ~Counted() { --alive; }

  int number;
  static std::atomic<int> alive;
};
std::atomic<int> Counted::alive{0};

TEST(Mailbox, IsEmptyAtFirst) {
  Mailbox<int> mailbox;
  EXPECT_EQ(mailbox.take(), nullptr);
}

TEST(Mailbox, GivesEachObjectOnce) {
  Mailbox<int> mailbox;
  mailbox.give(3);
  auto* const envelope = mailbox.take();
  ASSERT_NE(envelope, nullptr);
  EXPECT_EQ(envelope->content, 3);
  EXPECT_EQ(mailbox.take(), nullptr);
  mailbox.give_back(envelope);
}

TEST(Mailbox, OfSeveralTheLastCounts) {
  Mailbox<Counted> mailbox;
  for (int i = 0; i < 5; ++i) mailbox.give(Counted(i));
  EXPECT_EQ(Counted::alive, 1) << "those that nobody took are gone";
  auto* const envelope = mailbox.take();
  ASSERT_NE(envelope, nullptr);
  EXPECT_EQ(envelope->content.number, 4);
  mailbox.give_back(envelope);
}

TEST(Mailbox, FreesWhatComesBackOnTheGiversSide) {
  {
    Mailbox<Counted> mailbox;
    mailbox.give(Counted(1));
    auto* const first = mailbox.take();
    mailbox.give(Counted(2));
    auto* const second = mailbox.take();
    mailbox.give_back(first);
    mailbox.give_back(second);
    EXPECT_EQ(Counted::alive, 2) << "the receiver frees nothing";
    mailbox.free_returned();
    EXPECT_EQ(Counted::alive, 0);
    mailbox.give(Counted(3));
    mailbox.give_back(mailbox.take());
    mailbox.give(Counted(4));
  }
  EXPECT_EQ(Counted::alive, 0) << "neither what came back nor what was never taken is left";
}

TEST(Mailbox, TheReceiverAllocatesAndFreesNothing) {
  Mailbox<std::unique_ptr<int>> mailbox;
  mailbox.give(std::make_unique<int>(1));
  const test::AllocationCounter allocations;
  auto* const envelope = mailbox.take();
  mailbox.give_back(envelope);
  EXPECT_EQ(mailbox.take(), nullptr);
  EXPECT_EQ(allocations.count(), 0u);
}

TEST(Mailbox, LosesAndDoublesNothingBetweenThreads) {
  constexpr int kGiven = 20000;
  {
    Mailbox<Counted> mailbox;
    std::atomic<bool> done{false};
    std::thread receiver([&] {
      int last = -1;
      for (bool ending = false; !ending;) {
        ending = done;
        auto* const envelope = mailbox.take();
        if (envelope == nullptr) continue;
        EXPECT_GT(envelope->content.number, last);
        last = envelope->content.number;
        mailbox.give_back(envelope);
      }
      EXPECT_EQ(last, kGiven - 1) << "the last one given is seen";
    });
    for (int i = 0; i < kGiven; ++i) mailbox.give(Counted(i));
    done = true;
    receiver.join();
  }
  EXPECT_EQ(Counted::alive, 0);
}

}  // namespace
}  // namespace tegotae
