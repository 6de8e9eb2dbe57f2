// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/runtime/haptic_interface.hpp>

#include <string_view>

namespace tegotae {

/// Between a device's axes D and the world's W: a permutation of axes with signs, right-handed to right-handed. The
/// grip's own axes are renamed alike, so that a grip that is unrotated in D is so in W.
class AxisMap {
 public:
  AxisMap() = default;
  /// `names`: the device's axes along the world's x, y and z, as "xyz" (the same) or "y-xz" (x is the device's y, y is
  /// the opposite of its x, z is its z). Throws std::invalid_argument for what is no such thing or is left-handed.
  explicit AxisMap(std::string_view names);

  const Matrix3& R_WD() const noexcept { return R_WD_; }
  Vector3 to_world(const Vector3& v_D) const noexcept { return R_WD_ * v_D; }
  Vector3 to_device(const Vector3& v_W) const noexcept { return R_WD_.transpose() * v_W; }
  /// The pose of the grip G, p_DG and R_DG, as X_WT. R_DG must be a rotation.
  Pose to_world(const Vector3& p_DG, const Matrix3& R_DG) const noexcept {
    return {R_WD_ * p_DG, Quaternion(R_WD_ * R_DG * R_WD_.transpose())};
  }

 private:
  Matrix3 R_WD_ = Matrix3::Identity();
};

}  // namespace tegotae
