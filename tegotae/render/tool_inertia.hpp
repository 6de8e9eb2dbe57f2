// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/types.hpp>
#include <tegotae/shape/mass_properties.hpp>

namespace tegotae {

/// The tool's inertia tensor about its centre of mass in its own axes, scaled to a mean of 1: (I_x + I_y + I_z) / 3
/// = 1. How heavy the tool is to turn about one axis against the others; lengths and masses are the methods' own.
/// Throws std::invalid_argument unless the tensor is finite, symmetric and positive definite.
Matrix3 unit_mean_inertia(const MassProperties& tool);

/// diag(linear, linear, linear, angular R S R^T): `shape_T` is S in the tool's axes, R the tool's orientation. Does not
/// allocate.
Matrix6 rigid_body_matrix(double linear, double angular, const Matrix3& shape_T, const Matrix3& R_WT) noexcept;

}  // namespace tegotae
