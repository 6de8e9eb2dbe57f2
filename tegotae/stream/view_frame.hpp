// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/plain.hpp>
#include <tegotae/render/contact_view.hpp>
#include <tegotae/render/render_types.hpp>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace tegotae {

/// The wrench that a tick displayed.
struct ViewedSample {
  double time = 0.0;  ///< s, of the session
  PlainWrench displayed;
};

/// What a run is judged by while it goes. A number that is not known is NaN, and null in the message.
struct ViewedNumbers {
  double tick_median_us = 0.0, tick_p99_us = 0.0, tick_p999_us = 0.0, tick_max_us = 0.0;
  std::uint64_t ticks = 0;                       ///< since the session began
  double haptic_rate = 0.0, physics_rate = 0.0;  ///< Hz, as measured
  double physics_step_ms = 0.0;                  ///< median
  double staleness_ms = 0.0;                     ///< age of the model in the last tick
  std::uint64_t missed = 0;                      ///< haptic deadlines
  int near_objects = 0;
  int contacts = 0;  ///< contact points
  int active = 0, constraints = 0, dropped = 0, iterations = 0;
  double depth = 0.0;   ///< m, greatest penetration at the interface's pose
  double energy = 0.0;  ///< J, that the rendering has injected beyond what it took
  RenderStatus status = RenderStatus::kOk;
  std::uint32_t safety_events = 0;  ///< bit i: SafetyEvent i happened in the last 50 ms
};

/// Tick times: `counts[i]` of them between `edges_us[i]` and `edges_us[i + 1]`.
struct ViewedHistogram {
  std::vector<double> edges_us;
  std::vector<std::uint64_t> counts;
};

/// A recording that is being written.
struct ViewedRecording {
  std::string file;
  std::uint64_t ticks = 0;
};

/// A `state` message of the live view (docs/live-view.md): what a page shows of one moment. World axes, SI units.
struct ViewFrame {
  std::uint64_t n = 0;              ///< count of states, from 1
  double time = 0.0;                ///< s, of the session
  double made_ms = 0.0;             ///< since the Unix epoch, when it was put together
  PlainPose X_WT;                   ///< the tool's frame as it is held
  PlainPose X_WP;                   ///< as the world allows it
  std::optional<PlainPose> target;  ///< that the hand means; not set: a device or a recorded motion is the hand
  PlainWrench displayed;
  std::vector<PlainPose> bodies;  ///< of the moving bodies, by moving_index
  ContactView contacts;
  std::vector<ViewedSample> samples;  ///< of the last 50 ms, oldest first
  ViewedNumbers numbers;
  std::optional<ViewedHistogram> histogram;
  bool paused = false;
  std::optional<ViewedRecording> recording;
  std::optional<std::string> motion;  ///< scripted motion or experiment that plays
  std::optional<std::uint64_t> hand;  ///< number of the viewer that moves the tool
  int viewers = 0;
};

/// The message. Positions, wrenches and numbers have 7 significant digits, times all of theirs; what is not finite is
/// null. Allocates; some ten microseconds.
std::string encode(const ViewFrame& frame);

}  // namespace tegotae
