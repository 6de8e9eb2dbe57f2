// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/simulated_presets.hpp>
#include <tegotae/device/simulated_spidar.hpp>
#include <tegotae/device/spidar_interface.hpp>
#include <tegotae/device/spidar_presets.hpp>
#include <tegotae/math/rotation.hpp>

#include <cmath>
#include <memory>
#include <utility>

namespace tegotae::test {

/// Set-up of tests of a SPIDAR's driver.

inline constexpr double kSpidarPeriod = 1e-3;  // s

inline SpidarSettings spidar_settings(const char* preset = "x3r") {
  SpidarSettings settings;
  settings.geometry = spidar_preset(preset).geometry;
  return settings;
}

/// What the encoders count with the grip at X_SG.
inline SpidarVector counts_at(const SpidarGeometry& geometry, const Pose& X_SG) {
  const SpidarVector way = spidar_strings(geometry, X_SG).lengths - spidar_strings(geometry, {}).lengths;
  SpidarVector counts;
  for (int i = 0; i < kSpidarStrings; ++i) {
    counts[i] = std::round(way[i] / geometry.strings[static_cast<std::size_t>(i)].metres_per_pulse);
  }
  return counts;
}

inline double turn_between(const Pose& a, const Pose& b) { return rotation_vector(a.q * b.q.conjugate()).norm(); }

inline Trajectory held_still(const Pose& X_WT = {}) { return Trajectory({{0.0, X_WT}}); }

/// A simulated SPIDAR that is what its driver takes it for, in a moderate hand.
inline SimulatedSpidarSettings simulated_settings(const SpidarSettings& driver) {
  SimulatedSpidarSettings device;
  device.geometry = driver.geometry;
  device.X_WS = driver.X_WS;
  device.hand = simulated_hand("moderate");
  return device;
}

inline std::unique_ptr<SimulatedSpidar> simulated_spidar(const SpidarSettings& driver, Trajectory intended) {
  return std::make_unique<SimulatedSpidar>(simulated_settings(driver),
                                           std::make_unique<IntendedTrajectory>(std::move(intended)));
}

}  // namespace tegotae::test
