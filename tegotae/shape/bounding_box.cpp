// SPDX-License-Identifier: Apache-2.0
#include <tegotae/shape/bounding_box.hpp>

#include <tegotae/shape/support.hpp>

#include <limits>

namespace tegotae {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

BoundingBox plane_box(const Pose& X_WS) noexcept {
  BoundingBox box{Vector3::Constant(-kInfinity), Vector3::Constant(kInfinity)};
  const Vector3 n_W = X_WS.q * Vector3::UnitZ();
  // Only a normal along an axis, to rounding, closes a side.
  constexpr double kAligned = 1.0 - 1e-15;
  for (int axis = 0; axis < 3; ++axis) {
    if (n_W(axis) >= kAligned) box.upper(axis) = X_WS.p(axis);
    if (n_W(axis) <= -kAligned) box.lower(axis) = X_WS.p(axis);
  }
  return box;
}

}  // namespace

BoundingBox bounding_box(const Shape& shape, const Pose& X_WB) noexcept {
  const Pose X_WS = X_WB * shape.X_BS;
  if (!shape.is_bounded()) return plane_box(X_WS);
  const Matrix3 R_SW = X_WS.rotation().transpose();
  BoundingBox box;
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3 direction = R_SW.col(axis);
    box.upper(axis) = X_WS.p(axis) + direction.dot(support(shape, direction).p);
    box.lower(axis) = X_WS.p(axis) + direction.dot(support(shape, -direction).p);
  }
  return box;
}

}  // namespace tegotae
