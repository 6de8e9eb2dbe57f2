// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/experiment.hpp>
#include <tegotae/runtime/statistics.hpp>
#include <tegotae/runtime/tick_record.hpp>

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace tegotae {

/// Least, greatest and mean of a number over the ticks of a phase.
struct Spread {
  double min = 0.0, max = 0.0, mean = 0.0;
};

/// What a phase of a run came to.
struct PhaseSummary {
  Phase phase;
  std::uint64_t ticks = 0;
  std::uint64_t missed_deadlines = 0;  ///< haptic periods without a tick since the tick before the phase's first; none
                                       ///< in simulated time
  std::array<Spread, 3> force;         ///< x, y, z of the method's wrench, N
  std::array<Spread, 3> torque;        ///< about the tool's centre of mass, N m
  Spread force_norm, torque_norm;
  Spread reported_force, reported_torque;          ///< along the experiment's axes
  double force_at_end = 0.0, torque_at_end = 0.0;  ///< along the same axes, in the last tick of the phase
  Spread contacts;                                 ///< contact points that push
  Spread deepest;                                  ///< m
  double greatest_force_step = 0.0;                ///< of the method's force from a tick of the phase to the next, N
  double greatest_torque_step = 0.0;               ///< of its torque, N m
  DurationHistogram tick_times;                    ///< s
};

/// What a run came to.
struct RunSummary {
  std::vector<PhaseSummary> phases;
  std::map<std::string, std::uint64_t> statuses;       ///< ticks by status of the method
  std::map<std::string, std::uint64_t> safety_events;  ///< ticks by what the safety stage did
  std::uint64_t dropped = 0;                           ///< planes and points beyond the model's capacity, all ticks
  TickStatistics haptics;                              ///< of the records
};

/// The summary of the records of one run of `experiment`, in order of time, made at `haptic_rate` (Hz).
RunSummary summarise(const Experiment& experiment, std::span<const TickRecord> records, double haptic_rate);

}  // namespace tegotae
