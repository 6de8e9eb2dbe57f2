// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/simulated_hand_interface.hpp>
#include <tegotae/lab/session_settings.hpp>
#include <tegotae/runtime/simulated_session.hpp>

namespace tegotae {

/// Safety limits that never act, so that what is measured is the method: no ramp, no energy bound, no rate limit, no
/// saturation.
SafetyLimits no_safety_limits(const SessionSettings& settings);

/// Renders `scene`, in which nothing but the tool moves, to a simulated hand that holds the tool, in simulated time
/// from 0 for `duration` (s), the safety stage out of action. Repeats bit for bit. Throws std::invalid_argument where
/// the method refuses the settings.
void run_closed_loop(const SceneGeometry& scene, const SessionSettings& settings, SimulatedHandInterface& interface,
                     double duration, const TickObserver& observer);

/// The same with the safety stage in action.
void run_closed_loop(const SceneGeometry& scene, const SessionSettings& settings, const SafetyLimits& limits,
                     SimulatedHandInterface& interface, double duration, const TickObserver& observer);

}  // namespace tegotae
