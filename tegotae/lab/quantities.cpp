// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/quantities.hpp>

#include <cmath>
#include <numbers>

namespace tegotae {

Quantity position_along(const Vector3& axis) {
  return [axis](const TickRecord& record, const SessionSettings&) { return axis.dot(record.X_WT.p.vector()); };
}

Quantity angle_about(const Vector3& axis) {
  return [axis](const TickRecord& record, const SessionSettings&) {
    const double half_sine = axis.dot(Vector3(record.X_WT.x, record.X_WT.y, record.X_WT.z));
    const double angle = 2.0 * std::atan2(half_sine, record.X_WT.w) * 180.0 / std::numbers::pi;
    return std::remainder(angle, 360.0);
  };
}

Quantity force_along(const Vector3& axis) {
  return [axis](const TickRecord& record, const SessionSettings&) { return axis.dot(record.wrench.force.vector()); };
}

Quantity torque_along(const Vector3& axis) {
  return [axis](const TickRecord& record, const SessionSettings&) { return axis.dot(record.wrench.torque.vector()); };
}

}  // namespace tegotae
