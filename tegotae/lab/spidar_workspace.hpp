// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/spidar_geometry.hpp>
#include <tegotae/device/spidar_reach.hpp>

#include <array>
#include <filesystem>

namespace tegotae {

/// How far a SPIDAR's strings hold its grip: from the middle of the frame, unrotated, along and about the axes of S, to
/// where they cease to push to every side (force closure within the motors' limits).
struct SpidarWorkspace {
  struct Limit {
    double backward = 0.0, forward = 0.0;  ///< along or about the axis' negative and positive side; both positive
  };
  SpidarReach at_centre;
  std::array<Limit, 3> way;    ///< m, along x, y and z
  std::array<Limit, 3> angle;  ///< rad, about x, y and z; at most pi
};

/// To 10 um and 0.01 degree. Throws std::invalid_argument as check_force_closure.
SpidarWorkspace spidar_workspace(const SpidarGeometry& geometry);

/// Maps of the greatest force and torque that the motors reach in every direction. With the grip unrotated, in the
/// three planes through the middle of the frame: "workspace-position.svg" and ".png"; in the middle, over the angle
/// about each axis: "workspace-rotation.svg" and ".png". Beside each its numbers, as ".csv" with units, and its gnuplot
/// script. Replaces such files in `folder`, which is made where it is not there. Throws InputError, and as
/// spidar_workspace.
void draw_spidar_workspace(const SpidarGeometry& geometry, const std::filesystem::path& folder);

}  // namespace tegotae
