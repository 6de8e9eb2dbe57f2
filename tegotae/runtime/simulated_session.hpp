// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/runtime/haptic_interface.hpp>
#include <tegotae/runtime/haptic_tick.hpp>
#include <tegotae/runtime/physics_loop.hpp>

#include <functional>

namespace tegotae {

/// Called once a tick with what it did; false ends the run. In simulated time on the caller's thread; in real time on
/// the recorder's thread, never on the haptic one.
using TickObserver = std::function<bool(const TickRecord&)>;

/// Runs both rates in simulated time, on the caller's thread, from time 0 for `duration` (s). Nothing depends on the
/// wall clock but `tick_us`: the same inputs give the same records, bit for bit. A model made from the state at t
/// becomes visible one physics period later, as it would at best with a physics that needs its whole period; the first
/// one is there from the start. The last tick is the last whose time does not exceed the duration.
void run_simulated(PhysicsLoop& physics, HapticTick& haptics, HapticInterface& interface, double haptic_period,
                   double duration, const TickObserver& observer);

}  // namespace tegotae
