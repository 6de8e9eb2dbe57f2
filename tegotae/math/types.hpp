// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace tegotae {

// Unaligned Eigen types: their layout does not depend on the instruction set that a program is
// compiled for, so an installed tegotae links with programs built with or without -march=native.
using Vector3 = Eigen::Matrix<double, 3, 1>;
using Matrix3 = Eigen::Matrix<double, 3, 3>;
using Vector6 = Eigen::Matrix<double, 6, 1, Eigen::DontAlign>;
using Matrix6 = Eigen::Matrix<double, 6, 6, Eigen::DontAlign>;

/// Unit quaternion. Constructed, written and read as (w, x, y, z).
using Quaternion = Eigen::Quaternion<double, Eigen::DontAlign>;

}  // namespace tegotae
