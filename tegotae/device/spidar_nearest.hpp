// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/spidar_geometry.hpp>
#include <tegotae/math/wrench.hpp>

namespace tegotae {

/// Tensions that display as nearly a part of a wrench as the motors can.
struct SpidarNearest {
  SpidarVector tensions;  ///< N, within the limits
  double scale = 0.0;     ///< the part s
  int steps = 0;          ///< of the active set
};

/// For poses where the strings reach no part of `wrench`, not even zero: within min <= t <= max and 0 <= s <= 1
///
///     minimises |W t - s w|^2 + a (1 - s)^2 |w|^2 + b |t - min|^2,   torques divided by `radius` (m),
///
/// the least stray wrench first, among equal ones the greatest part, and then small tensions: a and b are the small
/// tolerance::kSpidarPreferGreat and kSpidarPreferSmall. So at the border of the poses where some part is reachable the
/// wrench goes on without a jump. A strictly convex problem in nine bounded unknowns, solved by a primal active set (P.
/// Stark and R. Parker, Computational Statistics 10, 1995): each step solves for the free unknowns, goes as far as the
/// bounds let it, and frees the bound that pulls hardest. At the step limit the tensions are still within the bounds.
/// All arguments must be finite. Does not allocate.
SpidarNearest nearest_tensions(const SpidarWrenchMatrix& W, double radius, const SpidarVector& min,
                               const SpidarVector& max, const Wrench& wrench) noexcept;

}  // namespace tegotae
