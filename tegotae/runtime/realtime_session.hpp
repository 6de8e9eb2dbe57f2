// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/runtime/haptic_interface.hpp>
#include <tegotae/runtime/haptic_tick.hpp>
#include <tegotae/runtime/live_link.hpp>
#include <tegotae/runtime/physics_loop.hpp>
#include <tegotae/runtime/realtime_thread.hpp>
#include <tegotae/runtime/statistics.hpp>

#include <atomic>
#include <functional>
#include <string>

namespace tegotae {

/// How a real-time run went. What the tick itself took and how old its models were, and what the system did to it.
struct RealtimeReport {
  TickStatistics haptics;     ///< tick durations, age of the model at each tick, missed periods
  TickStatistics physics;     ///< step durations, age of the haptic message at each step, missed periods
  DurationHistogram wake_up;  ///< s from a haptic deadline to the thread's waking
  RealtimeRights haptic_rights, physics_rights;
  std::uint64_t dropped_records = 0;  ///< ticks that the observer did not get, as it was too slow
  std::string physics_error;          ///< not empty: the world threw, physics stopped and the wrench faded
};

/// Called once a tick on a thread of its own, neither haptic nor physics; false ends the run.
using RealtimeObserver = std::function<bool(const TickRecord&)>;

/// Runs both rates in real time, each on a thread of its own (SCHED_FIFO and locked memory where the system grants
/// them), for `duration` (s), or until `stop` becomes true (from any thread or a signal handler) or the observer says
/// so. Models and impulses cross by wait-free latest-value exchange; a model becomes visible as soon as it is made. The
/// first one is made before the haptic thread starts. The last command to the interface is zero, whatever ended the
/// run: its time, `stop`, the observer, or an exception of the observer, of the link's callbacks, of the first model or
/// of a thread that cannot be started (std::system_error), each of which is thrown on once zero has been said. A zero
/// that the interface did not take is said again. With `live` the run can be watched and steered; a world that throws
/// then ends it.
RealtimeReport run_realtime(PhysicsLoop& physics, HapticTick& haptics, HapticInterface& interface, double haptic_period,
                            double duration, const std::atomic<bool>& stop, const RealtimeObserver& observer,
                            LiveLink* live = nullptr);

}  // namespace tegotae
