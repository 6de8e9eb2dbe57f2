// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/spidar_geometry.hpp>
#include <tegotae/device/trajectory.hpp>

namespace tegotae {

/// Where a SPIDAR stands for a motion of a tool, and how the tool sits on its grip.
struct SpidarPlace {
  Pose X_WS;                                 ///< its frame in the world
  Quaternion q_GT = Quaternion::Identity();  ///< the tool's frame on the grip; the origins agree

  // Over the motion, the greatest that the motors reach in every direction, where that is least.

  double force = 0.0;   ///< N
  double torque = 0.0;  ///< N m
};

/// Puts the middle of the motion into the middle of the frame: of the box around its positions; and of its rotations,
/// the one that is nearest to the farthest of them, with the grip unrotated. S keeps z along `up_W` (unit, the world's
/// up). Its x is the world's, or turned by quarters about the vertical, as if the person sat at another side: whichever
/// leaves the motors most along the motion, the first where it hardly matters. Throws InputError, a sentence with the
/// time, where the motion leaves what the strings can hold.
SpidarPlace place_spidar(const SpidarGeometry& geometry, const Trajectory& motion, const Vector3& up_W);

}  // namespace tegotae
