// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <time.h>

#include <cerrno>
#include <cmath>
#include <cstdint>

namespace tegotae {

/// Nanoseconds of the monotonic clock: the one clock of all loops of a run. A vDSO call, no entry to the kernel.
inline std::int64_t monotonic_nanoseconds() noexcept {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return std::int64_t{now.tv_sec} * 1'000'000'000 + now.tv_nsec;
}

/// Seconds between two readings of `monotonic_nanoseconds`.
constexpr double seconds_between(std::int64_t from, std::int64_t to) noexcept {
  return 1e-9 * static_cast<double>(to - from);
}

/// Wakes a loop at absolute times start + n * period, so that neither the loop's own work nor late wake-ups add up.
class PeriodicTimer {
 public:
  /// `period`: ns, at least 1 (less counts as 1). The first deadline is one period from now.
  explicit PeriodicTimer(std::int64_t period) noexcept
      : period_(period < 1 ? 1 : period), deadline_(monotonic_nanoseconds() + period_) {}

  /// Period of `rate` (Hz, positive, at most 1e9), ns.
  static std::int64_t period_of(double rate) noexcept { return std::llround(1e9 / rate); }

  /// Sleeps to the deadline, or not at all if it has passed, and sets the next one in the future. Returns the number of
  /// missed periods: those whose deadline passed while the caller was busy, or while the system did not wake it.
  /// One system call: belongs outside the tick.
  std::int64_t wait() noexcept {
    const timespec until{static_cast<time_t>(deadline_ / 1'000'000'000), static_cast<long>(deadline_ % 1'000'000'000)};
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &until, nullptr) == EINTR) {
    }
    woken_at_ = monotonic_nanoseconds();
    const std::int64_t missed = (woken_at_ - deadline_) / period_;
    due_ = deadline_ + missed * period_;
    deadline_ = due_ + period_;
    return missed;
  }

  std::int64_t due() const noexcept { return due_; }            ///< ns, deadline that the last `wait` answered
  std::int64_t woken_at() const noexcept { return woken_at_; }  ///< ns, when it returned; never before `due`
  std::int64_t period() const noexcept { return period_; }      ///< ns

 private:
  std::int64_t period_;
  std::int64_t deadline_;
  std::int64_t due_ = 0;
  std::int64_t woken_at_ = 0;
};

}  // namespace tegotae
