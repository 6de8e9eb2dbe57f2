// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/passivity.hpp>
#include <tegotae/lab/session_settings.hpp>
#include <tegotae/runtime/duration_histogram.hpp>
#include <tegotae/runtime/live_link.hpp>
#include <tegotae/stream/view_frame.hpp>

#include <array>
#include <cstdint>
#include <deque>

namespace tegotae {

/// Makes the frames of a view from the ticks of a run: what they displayed lately, how they went, and all that is
/// counted of them. In order of time, on an ordinary thread.
class FrameMaker {
 public:
  /// Of a session with these settings and this tool (its centre of mass `p_TCm`, m, in its frame).
  FrameMaker(const SessionSettings& settings, const Vector3& p_TCm);

  /// One record a tick.
  void add(const TickRecord& record);

  /// The frame of the newest tick: n, time, poses, wrench, samples and numbers. The rest is left for the caller.
  ViewFrame frame(const ContactView& contacts, const MovingBodies& bodies);

  /// Tick times so far, for the frames that carry them.
  ViewedHistogram histogram() const;

  /// Other settings from the next tick on; what was counted stays.
  void change(const SessionSettings& settings);

 private:
  void count(const TickRecord& record);
  void count(const MovingBodies& bodies);
  double physics_rate() const;
  ViewedNumbers numbers() const;

  /// Bins of the histogram: from 1 us, sixteen a decade, to 10 ms.
  static constexpr int kBinsPerDecade = 16;
  static constexpr int kBins = 4 * kBinsPerDecade;

  struct Steps {
    double time = 0.0;
    std::uint64_t count = 0;
  };

  SessionSettings settings_;
  PassivityObserver passivity_;

  TickRecord newest_;
  std::uint64_t frames_ = 0, ticks_ = 0, missed_ = 0;
  DurationHistogram durations_, physics_steps_;
  std::array<std::uint64_t, kBins> bins_{};
  std::deque<ViewedSample> samples_;  ///< of the last 50 ms
  std::deque<std::uint32_t> events_;  ///< of the same ticks
  std::deque<double> last_second_;    ///< times of ticks
  std::deque<Steps> physics_last_second_;
};

}  // namespace tegotae
