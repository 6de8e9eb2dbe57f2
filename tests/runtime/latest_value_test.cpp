// SPDX-License-Identifier: Apache-2.0
#include <tegotae/model/intermediate_representation.hpp>
#include <tegotae/runtime/latest_value.hpp>

#include <tests/allocation_counter.hpp>

#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <thread>

namespace tegotae {
namespace {

// Large enough that a torn read would be likely, were it possible.
struct Message {
  std::uint64_t sequence = 0;
  std::array<std::uint64_t, 255> words{};
};

void fill(Message& message, std::uint64_t sequence) {
  message.sequence = sequence;
  for (std::size_t i = 0; i < message.words.size(); ++i) message.words[i] = sequence * 0x9e3779b97f4a7c15U + i;
}

bool is_whole(const Message& message) {
  for (std::size_t i = 0; i < message.words.size(); ++i) {
    if (message.words[i] != message.sequence * 0x9e3779b97f4a7c15U + i) return false;
  }
  return true;
}

TEST(LatestValue, BeginsWithTheDefaultAndNothingNew) {
  LatestValue<Message> exchange;
  EXPECT_FALSE(exchange.update());
  EXPECT_EQ(exchange.get().sequence, 0U);
}

TEST(LatestValue, GivesEachValueOnceAndSkipsToTheLatest) {
  LatestValue<int> exchange;
  exchange.write(1);
  EXPECT_TRUE(exchange.update());
  EXPECT_EQ(exchange.get(), 1);
  EXPECT_FALSE(exchange.update());
  EXPECT_EQ(exchange.get(), 1) << "stays valid";
  for (int i = 2; i <= 7; ++i) exchange.write(i);
  EXPECT_EQ(exchange.get(), 1) << "nothing changes under the reader's hands";
  EXPECT_TRUE(exchange.update());
  EXPECT_EQ(exchange.get(), 7);
  EXPECT_FALSE(exchange.update());
}

TEST(LatestValue, WritesInPlaceAndPublishesOnDemand) {
  LatestValue<int> exchange;
  exchange.begin_write() = 5;
  EXPECT_FALSE(exchange.update()) << "not published yet";
  exchange.publish();
  EXPECT_TRUE(exchange.update());
  EXPECT_EQ(exchange.get(), 5);
}

TEST(LatestValue, WriterNeverHoldsTheReadersSlot) {
  LatestValue<int> exchange;
  for (int i = 1; i < 1000; ++i) {
    exchange.write(i);
    if (i % 7 == 0) {
      EXPECT_TRUE(exchange.update());
    }
    EXPECT_NE(&exchange.begin_write(), &exchange.get());
  }
}

TEST(LatestValue, TwoThreadsSeeWholeValuesInOrderAndReachTheLast) {
  constexpr std::uint64_t kMessages = 200'000;
  const auto exchange = std::make_unique<LatestValue<Message>>();
  std::thread writer([&] {
    for (std::uint64_t i = 1; i <= kMessages; ++i) {
      fill(exchange->begin_write(), i);
      exchange->publish();
    }
  });
  std::uint64_t last = 0, torn = 0, out_of_order = 0;
  while (last < kMessages) {  // the last value is always reached
    if (!exchange->update()) {
      std::this_thread::yield();
      continue;
    }
    torn += is_whole(exchange->get()) ? 0 : 1;
    out_of_order += exchange->get().sequence > last ? 0 : 1;
    last = exchange->get().sequence;
  }
  writer.join();
  EXPECT_EQ(torn, 0U);
  EXPECT_EQ(out_of_order, 0U);
  EXPECT_EQ(last, kMessages);
  EXPECT_FALSE(exchange->update());
}

TEST(LatestValue, AllocatesNothingInOperation) {
  const auto exchange = std::make_unique<LatestValue<IntermediateRepresentation>>();
  const test::AllocationCounter counter;
  for (std::uint64_t i = 1; i <= 100; ++i) {
    exchange->begin_write().sequence = i;
    exchange->publish();
    ASSERT_TRUE(exchange->update());
    ASSERT_EQ(exchange->get().sequence, i);
  }
  EXPECT_EQ(counter.count(), 0U);
}

}  // namespace
}  // namespace tegotae
