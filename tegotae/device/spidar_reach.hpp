// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/spidar_geometry.hpp>
#include <tegotae/math/wrench.hpp>

namespace tegotae {

/// What the motors reach at a pose.
struct SpidarReach {
  double force = 0.0;   ///< N, the greatest that is reachable in every direction, without torque
  double torque = 0.0;  ///< N m, likewise without force
  /// The direction that limits most (torque in newtons at the knots' radius; unit), on the grip, axes of S: where force
  /// or torque is 0, one along which the strings do not push. Zero where they do not act on all components of wrench.
  Vector6 weakest = Vector6::Zero();
};

/// The reachable wrenches are cut by the facets n . w <= reach (spidar_null_space.hpp), so the greatest ball of pure
/// forces about 0 has the radius min reach/|n_force|, and of pure torques min reach/|n_torque|. Does not allocate.
SpidarReach spidar_reach(const SpidarGeometry& geometry, const Pose& X_SG) noexcept;

/// Refuses a geometry that cannot hold the grip at the centre against a push from every side: without force closure
/// (positive tensions that balance, and with them wrenches of every direction) within its motors' limits. Throws
/// std::invalid_argument, one sentence with the direction that it cannot push along, and the mend. Its numbers are
/// checked first (check_numbers). Allocates.
void check_force_closure(const SpidarGeometry& geometry);

}  // namespace tegotae
