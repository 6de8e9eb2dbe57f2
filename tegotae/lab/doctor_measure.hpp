// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/doctor.hpp>
#include <tegotae/lab/progress.hpp>
#include <tegotae/runtime/duration_histogram.hpp>
#include <tegotae/runtime/realtime_thread.hpp>

namespace tegotae {

/// How late a thread woke that asked for real-time rights.
struct WakeUps {
  RealtimeRights rights;
  DurationHistogram late;    ///< s, from each deadline to the thread's waking
  std::uint64_t missed = 0;  ///< periods that nothing woke in
};

/// Wakes a thread each `period` for `duration` (s), which does nothing else. Progress is told on the caller's thread.
/// Throws std::system_error where the thread cannot be started.
WakeUps measure_wake_ups(double period, double duration, const Progress& progress);

/// Judges the wake-ups by the 99.9th percentile: up to a tenth of the period, ok; and by the 99th: above half of the
/// period a tick has no time left, not possible.
Finding wake_up_finding(const WakeUps& wake_ups, double period);

/// How long (s) each tick took of a probe that presses on the shipped scene `table.xml` and draws circles on it, both
/// loops in simulated time, some thousand ticks. Throws InputError, SceneError.
DurationHistogram measure_ticks(const Progress& progress);

/// Judges them by the 99.9th percentile: up to half of the period, ok; and by the 99th: above the period, not possible.
Finding tick_finding(const DurationHistogram& ticks, double period);

}  // namespace tegotae
