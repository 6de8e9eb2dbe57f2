// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/coupling.hpp>

namespace tegotae {

Matrix6 Coupling::stiffness_matrix() const noexcept {
  const double rotational = stiffness * metric_length * metric_length;
  Vector6 diagonal;
  diagonal << stiffness, stiffness, stiffness, rotational, rotational, rotational;
  return diagonal.asDiagonal().toDenseMatrix();
}

Wrench Coupling::wrench(const Vector6& displacement, const Vector6& before, double dt) const noexcept {
  const double l2 = metric_length * metric_length;
  const Vector6 rate = (displacement - before) / dt;
  return {stiffness * displacement.head<3>() + damping * rate.head<3>(),
          stiffness * l2 * displacement.tail<3>() + rotational_damping.value_or(damping * l2) * rate.tail<3>()};
}

}  // namespace tegotae
