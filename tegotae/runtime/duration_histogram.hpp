// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

namespace tegotae {

/// Percentiles of durations without keeping them: a histogram of log-linear buckets, each octave in 64 equal parts (the
/// idea of Tene's HdrHistogram). A percentile is within 0.8 % of a duration of that rank, from 50 ns (less than any
/// tick) to 13 s (more than any stall that a run survives); shorter and longer ones count in the end buckets.
/// 14 KB in place; `add` is a few nanoseconds and allocates nothing. Trivially copyable: one thread adds; others
/// read after it has ended, or a copy that came through a LatestValue.
class DurationHistogram {
 public:
  static constexpr double kShortest = 50e-9;  ///< s
  static constexpr int kOctaves = 28;

  /// Counts `seconds`. NaN counts as infinite.
  void add(double seconds) noexcept;

  /// Adds all that `other` has counted.
  void merge(const DurationHistogram& other) noexcept;

  std::uint64_t count() const noexcept { return count_; }
  double min() const noexcept { return count_ == 0 ? 0.0 : min_; }  ///< s, exact; 0 if empty
  double max() const noexcept { return max_; }                      ///< s, exact; 0 if empty

  /// The duration (s) that at least the part `fraction` (0 to 1) of all counted ones does not exceed (nearest rank:
  /// the ceil(fraction * count)-th shortest); 0 if empty.
  double percentile(double fraction) const noexcept;
  double median() const noexcept { return percentile(0.5); }

 private:
  static constexpr int kPartBits = 6;  // 64 parts an octave: half a part is 1/128 of the lower bound at most
  static constexpr std::size_t kBuckets = static_cast<std::size_t>(kOctaves) << kPartBits;

  static std::size_t bucket_of(double seconds) noexcept;
  static double middle_of(std::size_t bucket) noexcept;

  std::array<std::uint64_t, kBuckets> buckets_{};
  std::uint64_t count_ = 0;
  double min_ = 0.0, max_ = 0.0;
};
static_assert(std::is_trivially_copyable_v<DurationHistogram>);

}  // namespace tegotae
