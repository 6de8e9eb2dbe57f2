// SPDX-License-Identifier: Apache-2.0
#include <tegotae/runtime/duration_histogram.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>

namespace tegotae {
namespace {

constexpr int kMantissaBits = std::numeric_limits<double>::digits - 1;
static_assert(std::numeric_limits<double>::is_iec559);

}  // namespace

// The exponent and the leading mantissa bits of an IEEE double are, read as one integer, a log-linear scale.
std::size_t DurationHistogram::bucket_of(double seconds) noexcept {
  const double scaled = seconds / kShortest;
  if (!(scaled >= 1.0)) return 0;
  if (scaled >= static_cast<double>(std::uint64_t{1} << kOctaves)) return kBuckets - 1;
  constexpr int kShift = kMantissaBits - kPartBits;
  const std::uint64_t place = std::bit_cast<std::uint64_t>(scaled) >> kShift;
  return static_cast<std::size_t>(place - (std::bit_cast<std::uint64_t>(1.0) >> kShift));
}

double DurationHistogram::middle_of(std::size_t bucket) noexcept {
  const auto part = static_cast<double>(bucket & ((1U << kPartBits) - 1));
  const int octave = static_cast<int>(bucket >> kPartBits);
  return std::ldexp(1.0 + (part + 0.5) / (1U << kPartBits), octave) * kShortest;
}

void DurationHistogram::add(double seconds) noexcept {
  if (std::isnan(seconds)) seconds = std::numeric_limits<double>::infinity();
  ++buckets_[bucket_of(seconds)];
  min_ = count_ == 0 ? seconds : std::min(min_, seconds);
  max_ = count_ == 0 ? seconds : std::max(max_, seconds);
  ++count_;
}

void DurationHistogram::merge(const DurationHistogram& other) noexcept {
  if (other.count_ == 0) return;
  for (std::size_t i = 0; i < kBuckets; ++i) buckets_[i] += other.buckets_[i];
  min_ = count_ == 0 ? other.min_ : std::min(min_, other.min_);
  max_ = count_ == 0 ? other.max_ : std::max(max_, other.max_);
  count_ += other.count_;
}

double DurationHistogram::percentile(double fraction) const noexcept {
  if (count_ == 0) return 0.0;
  const double wanted = std::ceil(std::clamp(fraction, 0.0, 1.0) * static_cast<double>(count_));
  const std::uint64_t rank = std::clamp(static_cast<std::uint64_t>(wanted), std::uint64_t{1}, count_);
  std::uint64_t below = 0;
  for (std::size_t i = 0; i < kBuckets; ++i) {
    below += buckets_[i];
    if (below >= rank) return std::clamp(middle_of(i), min_, max_);
  }
  return max_;
}

}  // namespace tegotae
