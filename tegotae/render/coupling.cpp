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
  const Vector6 felt = stiffness * displacement + damping / dt * (displacement - before);
  return {felt.head<3>(), metric_length * metric_length * felt.tail<3>()};
}

}  // namespace tegotae
