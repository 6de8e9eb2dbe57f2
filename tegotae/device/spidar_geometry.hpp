// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/pose.hpp>
#include <tegotae/math/types.hpp>

#include <array>
#include <limits>
#include <string>

namespace tegotae {

inline constexpr int kSpidarStrings = 8;

/// One number a string: lengths (m), tensions (N), counts (pulses).
using SpidarVector = Eigen::Matrix<double, kSpidarStrings, 1, Eigen::DontAlign>;

/// Columns (u_i, r_i x u_i): the wrench of 1 N in each string on the grip, about its origin, axes of S.
using SpidarWrenchMatrix = Eigen::Matrix<double, 6, kSpidarStrings, Eigen::DontAlign>;

/// A string, from the pulley of its motor to a knot on the grip.
struct SpidarString {
  Vector3 motor_S = Vector3::Zero();     ///< m, where the string leaves the pulley
  Vector3 knot_G = Vector3::Zero();      ///< m
  double metres_per_pulse = 1.66555e-5;  ///< of its encoder; negative where the count falls as the string grows longer
  double volts_per_newton = 0.3653;      ///< of its motor's amplifier, signed
  double min_tension = 0.3;              ///< N, that keeps the string taut
  double max_tension = 20.0;             ///< N
};

/// A SPIDAR with eight strings. Frame S: the middle of the frame, right-handed, x to the right, y away from the person,
/// z up, as in MJCF scenes. Frame G: the grip; at calibration it is held at S, unrotated.
struct SpidarGeometry {
  std::string name;
  std::array<SpidarString, kSpidarStrings> strings;

  /// N, tension that would stretch a string by its own length (Young's modulus times cross-section); infinite: none.
  double axial_stiffness = std::numeric_limits<double>::infinity();
};

/// A point of S from the tables of SPIDARs, whose frame is left-handed: x right, y up, z away. Swapping y and z is the
/// mirror that makes it right-handed and puts z up.
inline Vector3 from_left_handed(const Vector3& p) noexcept { return {p.x(), p.z(), p.y()}; }

/// The strings with the grip at X_SG. Does not allocate.
struct SpidarStrings {
  SpidarVector lengths;         ///< m, from motor to knot
  SpidarWrenchMatrix wrenches;  ///< its negative transpose is the derivative of the lengths by (dp, dtheta), axes of S
};
SpidarStrings spidar_strings(const SpidarGeometry& geometry, const Pose& X_SG) noexcept;

/// Greatest distance of a knot from the grip's origin, m: the length that turns rotation into motion.
double knot_radius(const SpidarGeometry& geometry) noexcept;

// By string, N.

SpidarVector min_tensions(const SpidarGeometry& geometry) noexcept;
SpidarVector max_tensions(const SpidarGeometry& geometry) noexcept;

/// What the amplifiers are told for `tensions` (N), V.
SpidarVector spidar_volts(const SpidarGeometry& geometry, const SpidarVector& tensions) noexcept;

/// Throws std::invalid_argument, with a sentence that names string and mend, where a number cannot be: not finite, no
/// tension between the limits, a pulse of no length, a string of no length at the centre, a knot radius of zero.
void check_numbers(const SpidarGeometry& geometry);

}  // namespace tegotae
