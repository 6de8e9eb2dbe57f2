// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/runtime/latest_value.hpp>

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <vector>

namespace tegotae {

/// Queue of one producer thread and one consumer thread (Lamport's ring, each side remembering the other's place so
/// that it rarely reads it). Wait-free; a full ring drops the record that is pushed and counts it, so the producer
/// never waits. Allocates on construction only.
template <class T>
class SpscRing {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  /// Holds at least `min_capacity` records (rounded up to a power of two).
  explicit SpscRing(std::size_t min_capacity) : slots_(std::bit_ceil(std::max<std::size_t>(min_capacity, 1))) {}
  SpscRing(const SpscRing&) = delete;
  SpscRing& operator=(const SpscRing&) = delete;

  std::size_t capacity() const noexcept { return slots_.size(); }

  /// Producer: false and counted if the ring is full.
  bool push(const T& record) noexcept {
    const std::uint64_t place = written_.load(std::memory_order_relaxed);
    if (place - read_as_seen_ == slots_.size()) {
      read_as_seen_ = read_.load(std::memory_order_acquire);
      if (place - read_as_seen_ == slots_.size()) {
        dropped_.store(dropped_.load(std::memory_order_relaxed) + 1, std::memory_order_relaxed);
        return false;
      }
    }
    slots_[place & (slots_.size() - 1)] = record;
    written_.store(place + 1, std::memory_order_release);
    return true;
  }

  /// Consumer: takes the oldest record; false if there is none.
  bool pop(T& record) noexcept {
    const std::uint64_t place = read_.load(std::memory_order_relaxed);
    if (place == written_as_seen_) {
      written_as_seen_ = written_.load(std::memory_order_acquire);
      if (place == written_as_seen_) return false;
    }
    record = slots_[place & (slots_.size() - 1)];
    read_.store(place + 1, std::memory_order_release);
    return true;
  }

  /// Records that a full ring has refused so far. Any thread.
  std::uint64_t dropped() const noexcept { return dropped_.load(std::memory_order_relaxed); }

 private:
  std::vector<T> slots_;
  // Written by the producer.
  alignas(kCacheLinePair) std::atomic<std::uint64_t> written_{0};
  std::uint64_t read_as_seen_ = 0;
  std::atomic<std::uint64_t> dropped_{0};
  // Written by the consumer.
  alignas(kCacheLinePair) std::atomic<std::uint64_t> read_{0};
  std::uint64_t written_as_seen_ = 0;
};

}  // namespace tegotae
