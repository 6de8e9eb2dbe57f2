// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/spidar_geometry.hpp>

#include <cstdint>

namespace tegotae {

enum class SpidarFit : std::uint8_t {
  kConverged,
  kNotFinite,     ///< a length or the guess is
  kSingular,      ///< the strings do not tell of some motion of the grip, near here
  kNotConverged,  ///< within the steps allowed
};

/// The grip's pose as eight lengths tell it.
struct SpidarPose {
  Pose X_SG;  ///< the guess, where the fit failed
  SpidarFit fit = SpidarFit::kNotFinite;
  double misfit = 0.0;  ///< m, RMS of measured less computed lengths: two redundant strings show what is wrong
  int steps = 0;
};

/// The pose whose string lengths are nearest to `lengths` (m) in the sum of squares, from the pose `guess` near it.
/// Gauss-Newton on the rigid motions: with residual e = L(X) - lengths and the strings' wrench matrix W, which is
/// -(dL/dX)^T, each step solves (W W^T) d = W e, rotation in units of the knots' radius, and moves the grip by d, its
/// rotation vector in the axes of S: no angles, so no orientation is special. A step that fits worse is halved. Ends
/// when a step is under tolerance::kSpidarStep. More than one pose may fit: the guess chooses. Does not allocate.
SpidarPose spidar_pose(const SpidarGeometry& geometry, const SpidarVector& lengths, const Pose& guess) noexcept;

/// Covariance of the pose (dp in m; rotation vector in rad; axes of S) from the rounding of eight counts alone.
/// Each length is off by an independent error, uniform over a pulse q and so of variance q^2/12; the covariance of any
/// linear unbiased estimate is at least that of weighted least squares, (W C^-1 W^T)^-1 with C = diag(q_i^2/12)
/// (Gauss and Markov; for a normal error of that variance it is the bound of Cramer and Rao). All NaN where the strings
/// are singular. Does not allocate.
Matrix6 spidar_quantisation(const SpidarGeometry& geometry, const Pose& X_SG) noexcept;

}  // namespace tegotae
