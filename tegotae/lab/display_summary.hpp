// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/runtime/tick_record.hpp>

#include <span>

namespace tegotae {

/// How what the motors displayed differs from what they were commanded, over some ticks.
struct DisplayErrors {
  long ticks = 0;
  double force_rms = 0.0, force_max = 0.0;    ///< N, of the norm of the difference
  double torque_rms = 0.0, torque_max = 0.0;  ///< N m, likewise, about the tool's centre of mass
};

/// What a run in closed loop came to at the grip.
struct DisplaySummary {
  DisplayErrors all;
  DisplayErrors reachable;                             ///< of ticks in which the motors could display the command
  long shortfalls = 0;                                 ///< ticks in which they could not
  double greatest_force = 0.0, greatest_torque = 0.0;  ///< N, N m, commanded
  double hand_way = 0.0;                               ///< m, greatest way from the tool to where the hand meant it
  double hand_angle = 0.0;                             ///< rad, greatest angle likewise
};

/// Of the records of a run on a simulated interface.
DisplaySummary display_summary(std::span<const TickRecord> records);

}  // namespace tegotae
