// SPDX-License-Identifier: Apache-2.0
#include <tegotae/runtime/spsc_ring.hpp>

#include <tests/allocation_counter.hpp>

#include <gtest/gtest.h>

#include <array>
#include <thread>

namespace tegotae {
namespace {

TEST(SpscRing, KeepsOrderOverManyTurns) {
  SpscRing<int> ring(4);
  int taken = 0, expected = 0;
  for (int i = 0; i < 1000; ++i) {
    EXPECT_TRUE(ring.push(2 * i));
    EXPECT_TRUE(ring.push(2 * i + 1));
    EXPECT_TRUE(ring.pop(taken));
    EXPECT_EQ(taken, expected++);
    EXPECT_TRUE(ring.pop(taken));
    EXPECT_EQ(taken, expected++);
  }
  EXPECT_FALSE(ring.pop(taken));
  EXPECT_EQ(ring.dropped(), 0U);
}

TEST(SpscRing, DropsAndCountsTheNewestWhenFull) {
  SpscRing<int> ring(3);
  EXPECT_EQ(ring.capacity(), 4U);
  for (int i = 0; i < 4; ++i) EXPECT_TRUE(ring.push(i));
  for (int i = 4; i < 9; ++i) EXPECT_FALSE(ring.push(i));
  EXPECT_EQ(ring.dropped(), 5U);
  int taken = -1;
  for (int i = 0; i < 4; ++i) {
    EXPECT_TRUE(ring.pop(taken));
    EXPECT_EQ(taken, i) << "what was in stays in";
  }
  EXPECT_TRUE(ring.push(9));
  EXPECT_TRUE(ring.pop(taken));
  EXPECT_EQ(taken, 9);
}

TEST(SpscRing, CapacityOfOneWorks) {
  SpscRing<int> ring(0);
  int taken = 0;
  EXPECT_EQ(ring.capacity(), 1U);
  EXPECT_TRUE(ring.push(1));
  EXPECT_FALSE(ring.push(2));
  EXPECT_TRUE(ring.pop(taken));
  EXPECT_FALSE(ring.pop(taken));
}

struct Record {
  std::uint64_t number = 0;
  std::array<std::uint64_t, 31> words{};
};

Record record_of(std::uint64_t number) {
  Record record;
  record.number = number;
  for (std::size_t i = 0; i < record.words.size(); ++i) record.words[i] = number + i;
  return record;
}

// Every record arrives once, whole and in order, or is counted as dropped.
void stress(std::size_t capacity, std::uint64_t records, bool producer_waits) {
  SpscRing<Record> ring(capacity);
  std::atomic<bool> done{false};
  std::thread producer([&] {
    for (std::uint64_t i = 1; i <= records; ++i) {
      const Record record = record_of(i);
      while (!ring.push(record) && producer_waits) std::this_thread::yield();
    }
    done.store(true, std::memory_order_release);
  });
  std::uint64_t taken = 0, last = 0, faults = 0;
  Record record;
  for (bool last_look = false; !last_look;) {
    last_look = done.load(std::memory_order_acquire);
    while (ring.pop(record)) {
      const Record whole = record_of(record.number);
      faults += record.number > last && record.words == whole.words ? 0 : 1;
      last = record.number;
      ++taken;
    }
    std::this_thread::yield();
  }
  producer.join();
  EXPECT_EQ(faults, 0U);
  EXPECT_EQ(taken, producer_waits ? records : records - ring.dropped());
}

TEST(SpscRing, TwoThreadsLoseNothingThatWasPushed) {
  stress(64, 200'000, true);
  stress(64, 200'000, false);
  stress(1, 5'000, true);
}

TEST(SpscRing, PushAllocatesNothing) {
  SpscRing<Record> ring(16);
  const Record record = record_of(1);
  const test::AllocationCounter counter;
  for (int i = 0; i < 100; ++i) ring.push(record);
  EXPECT_EQ(counter.count(), 0U);
  EXPECT_EQ(ring.dropped(), 84U);
}

}  // namespace
}  // namespace tegotae
