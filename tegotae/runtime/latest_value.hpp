// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace tegotae {

/// Bytes between data that different threads write, so that they do not take each other's cache line. Adjacent lines
/// are fetched in pairs on common x86 processors.
inline constexpr std::size_t kCacheLinePair = 128;

/// The latest value of one writer thread, for one reader thread (a triple buffer: one slot of the writer, one of the
/// reader, one between them that both swap by a single atomic exchange). Values may be skipped, never torn, never seen
/// in another order. Writing and reading are wait-free and allocate nothing.
template <class T>
class LatestValue {
  static_assert(std::is_trivially_copyable_v<T>, "values cross threads, processes and machines byte by byte");

 public:
  LatestValue() = default;
  LatestValue(const LatestValue&) = delete;
  LatestValue& operator=(const LatestValue&) = delete;

  /// Writer: the slot to fill before `publish`, without a copy of T. It holds an older value, not the last one.
  T& begin_write() noexcept { return slots_[write_slot_]; }

  /// Writer: makes the slot of `begin_write` the latest value. References to that slot end here.
  void publish() noexcept {
    write_slot_ = between_.exchange(write_slot_ | kNew, std::memory_order_acq_rel) & kSlotMask;
  }

  /// Writer: publishes a copy of `value`.
  void write(const T& value) noexcept {
    begin_write() = value;
    publish();
  }

  /// Reader: takes the latest value, if one was published since the last call: then true.
  bool update() noexcept {
    if ((between_.load(std::memory_order_relaxed) & kNew) == 0) return false;
    read_slot_ = between_.exchange(read_slot_, std::memory_order_acq_rel) & kSlotMask;
    return true;
  }

  /// Reader: the value that the last successful `update` took, T() before the first; valid until the next `update`.
  const T& get() const noexcept { return slots_[read_slot_]; }

 private:
  static constexpr std::uint32_t kSlotMask = 3;
  static constexpr std::uint32_t kNew = 4;  // the slot between holds a value that the reader has not taken

  std::array<T, 3> slots_{};
  alignas(kCacheLinePair) std::uint32_t write_slot_ = 0;
  alignas(kCacheLinePair) std::uint32_t read_slot_ = 1;
  alignas(kCacheLinePair) std::atomic<std::uint32_t> between_{2};
  static_assert(std::atomic<std::uint32_t>::is_always_lock_free);
};

}  // namespace tegotae
