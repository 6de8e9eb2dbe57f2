// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/runtime/duration_histogram.hpp>

#include <cstdint>
#include <type_traits>

namespace tegotae {

/// What a loop tells of its ticks (or physics steps) at the end of a run. Written by the loop's thread only; trivially
/// copyable, so read after the thread has ended or through a LatestValue. Nothing in it allocates after construction.
struct TickStatistics {
  DurationHistogram durations;         ///< computation of a tick, s
  DurationHistogram staleness;         ///< age of what the tick worked on (haptics: the model; physics: the pose), s
  std::uint64_t missed_deadlines = 0;  ///< periods that began without their tick, as an earlier one was not done

  /// Counts one tick: how long it took, how old its data were (s), how many periods were missed before it.
  void add(double duration, double age, std::uint64_t missed = 0) noexcept {
    durations.add(duration);
    staleness.add(age);
    missed_deadlines += missed;
  }

  void merge(const TickStatistics& other) noexcept {
    durations.merge(other.durations);
    staleness.merge(other.staleness);
    missed_deadlines += other.missed_deadlines;
  }

  std::uint64_t count() const noexcept { return durations.count(); }
};
static_assert(std::is_trivially_copyable_v<TickStatistics>);

}  // namespace tegotae
