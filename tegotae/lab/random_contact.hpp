// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/passivity.hpp>
#include <tegotae/lab/stability.hpp>

#include <cstdint>

namespace tegotae {

/// A hand that means to move `tool` at random over the floor z = 0 for `duration` (s): a sum of sines for the depth of
/// its lowest point (about 3 mm either way), for its place (20 mm) and for its turning (up to about a radian from the
/// tool's own orientation), so that vertices, edges and faces touch, slide, roll and leave. The same `seed` gives the
/// same motion.
Trajectory random_contact(const Tool& tool, double duration, std::uint32_t seed);

/// What the passivity observer saw of a method in closed loop.
struct EnergyRow {
  std::string method;
  double metric_length = 0.0;  ///< m
  double stiffness = 0.0;      ///< N/m
  double duration = 0.0;       ///< s
  int contacts = 0;
  double time_in_contact = 0.0;  ///< s
  double given = 0.0;            ///< J, to the hand
  double allowed = 0.0;          ///< J, the sampled spring's own
  double excess = 0.0;           ///< J, beyond it
  double worst_contact = 0.0;    ///< J, the greatest excess of one contact
  double greatest_force = 0.0;   ///< N
};

/// Of the measurement that is reported: s, and the seed of the motion.
inline constexpr double kEnergyDuration = 60.0;
inline constexpr std::uint32_t kEnergySeed = 1;

/// The cube in `random_contact`, rendered at setup.settings.stiffness.
EnergyRow measure_energy(const StabilitySetup& setup, double duration, std::uint32_t seed, const Progress& progress);

}  // namespace tegotae
