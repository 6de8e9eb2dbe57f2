// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/spidar_geometry.hpp>
#include <tegotae/math/wrench.hpp>

#include <cstdint>

namespace tegotae {

enum class SpidarDisplay : std::uint8_t {
  kExact,      ///< the wrench asked for
  kScaled,     ///< the greatest part of it that the motors reach, in its direction
  kNearest,    ///< they reach no part of it, not even zero: as near one as they can (spidar_nearest.hpp)
  kSingular,   ///< the strings do not act on some component of wrench here: least tensions
  kNotFinite,  ///< something given is: least tensions
};

/// Tensions for a wrench, and what they display.
struct SpidarTensions {
  SpidarVector tensions = SpidarVector::Zero();  ///< N, within the limits
  Wrench displayed;                              ///< on the grip, about its origin, axes of S
  Wrench shortfall;                              ///< asked for less displayed
  double scale = 0.0;                            ///< displayed as a part of asked for, in [0, 1]
  SpidarDisplay display = SpidarDisplay::kNotFinite;
};

/// Among tensions t with min <= t <= max that display s w, the ones with
///
///     the greatest s <= 1, and then the least |t - min|^2.
///
/// So the wrench is exact where it is reachable and else keeps its direction. Far from the centre, where the strings
/// cannot even balance, no s is: then the tensions are those of the least stray wrench. The measure of the spread is
/// from the least tensions, not from the mean: it is strictly convex, so the tensions are unique and follow pose and
/// wrench without jumps, and no string pulls more than it must, for its motor's heat and its friction; while the
/// deviation from the mean leaves open how hard all strings pull against each other wherever equal tensions balance.
///
/// Exact in a bounded number of operations. s: the least ratio reach/(n . w) of all facets of the reachable wrenches
/// (spidar_null_space.hpp). t = W^+ s w + N z then is the projection of a point on the polygon that sixteen limits cut
/// from the plane of z: limit by limit, and where one is broken the best point on its line within the earlier ones
/// (R. Seidel, Discrete Comput. Geom. 6, 1991). `W` is the wrench matrix at the pose, `radius` the knots' (m). Least
/// tensions where W or w is not finite. Does not allocate.
SpidarTensions spidar_tensions(const SpidarWrenchMatrix& W, double radius, const SpidarVector& min,
                               const SpidarVector& max, const Wrench& wrench) noexcept;

}  // namespace tegotae
