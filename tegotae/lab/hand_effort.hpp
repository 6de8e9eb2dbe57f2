// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/simulated_grip.hpp>
#include <tegotae/device/trajectory.hpp>
#include <tegotae/model/scene_geometry.hpp>
#include <tegotae/runtime/tick_record.hpp>

#include <span>

namespace tegotae {

/// The greatest that a hand presses with.
struct EffortLimits {
  double force = 0.0;   ///< N
  double torque = 0.0;  ///< N m, about the grip
};

/// Where `hand` must mean `tool` to be so that its spring carries what an exact playback of a motion displayed
/// (`played`, the records from its start at `start` s on): a hand that just followed the motion would yield to it, and
/// press with a fraction of the experiment's force. The wrench is the mean over 0.1 s about each tick, as no hand
/// presses by leaps, and no more than `limits`. Throws std::invalid_argument where there are no records.
Trajectory with_effort(std::span<const TickRecord> played, double start, const Tool& tool, const HandImpedance& hand,
                       const EffortLimits& limits);

}  // namespace tegotae
