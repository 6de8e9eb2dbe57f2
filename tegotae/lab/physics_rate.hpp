// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/world/mujoco_world.hpp>

#include <string>

namespace tegotae {

/// A rate of the physics steps, and why.
struct PhysicsRateChoice {
  double rate = 0.0;   ///< Hz
  std::string reason;  ///< a sentence for people
};

/// The shortest period (s) in which physics takes at most a third of a core: one of some between 2 and 50 ms, 50 ms
/// where none is long enough. In a period the world takes as many substeps of `max_substep` (s) as fit it, each
/// `step_time` (s), and makes a model, for which one more substep and 0.2 ms are counted.
double shortest_publish_period(double step_time, double max_substep) noexcept;

/// Chooses by the step time of `world` measured now on this machine, for a run in real time. No rate is above
/// `haptic_rate` (Hz).
PhysicsRateChoice measured_physics_rate(const MujocoWorld& world, double haptic_rate);

}  // namespace tegotae
