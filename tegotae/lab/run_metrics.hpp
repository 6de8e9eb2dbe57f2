// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/session_settings.hpp>
#include <tegotae/runtime/duration_histogram.hpp>
#include <tegotae/runtime/tick_record.hpp>

#include <span>

namespace tegotae {

/// What a run came to by itself, without a reference.
struct RunMetrics {
  /// m, greatest depth of the tool at X_WP, where the method says that the world lets it be, in the static bodies
  /// (PosePenetration). Of a method without such a pose: at the interface's.
  double proxy_penetration = 0.0;

  // Of the method's wrench, before the safety stage, by PassivityObserver.
  double energy_given = 0.0;   ///< J, to the hand
  double energy_own = 0.0;     ///< J, the sampled spring's own, integral of k T v^2/2
  double energy_excess = 0.0;  ///< J, injected beyond it

  long not_ok = 0;               ///< ticks whose status is not ok
  DurationHistogram tick_times;  ///< s of the wall clock; the one thing that does not repeat
};

/// Of `records`, in order of time, one a tick, made in `scene` with `settings`.
RunMetrics run_metrics(std::span<const TickRecord> records, const SceneGeometry& scene,
                       const SessionSettings& settings);

}  // namespace tegotae
