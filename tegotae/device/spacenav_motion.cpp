// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/spacenav_motion.hpp>

#include <tegotae/math/rotation.hpp>

#include <algorithm>
#include <cmath>

namespace tegotae {
namespace {

// -1 to 1, none within the dead zone, without a step at its end.
double part_of_full(int counts, double dead_zone) noexcept {
  const double part = std::clamp(static_cast<double>(counts) / SpacenavDeflection::kFull, -1.0, 1.0);
  const double beyond = std::max(std::abs(part) - dead_zone, 0.0) / (1.0 - dead_zone);
  return std::copysign(beyond, part);
}

}  // namespace

// A mirror of z makes the frame right-handed. It turns the sense of rotations as well, so that of both only the z
// component changes its sign.
Vector6 SpacenavMotion::wanted(const SpacenavDeflection& deflection) const noexcept {
  const auto part = [this](int counts) { return part_of_full(counts, settings_.dead_zone); };
  const auto& [x, y, z] = deflection.push;
  const auto& [rx, ry, rz] = deflection.turn;
  Vector6 result;
  result.head<3>() = settings_.axes.to_world({part(x), part(y), -part(z)});
  result.tail<3>() = settings_.axes.to_world({part(rx), part(ry), -part(rz)});
  return result;
}

void SpacenavMotion::advance(double time, const SpacenavDeflection& deflection) noexcept {
  const double dt = has_begun_ ? std::clamp(time - time_, 0.0, kLongestStep) : 0.0;
  time_ = time;
  has_begun_ = true;
  if (!(dt > 0.0)) return;
  const Vector6 before = deflection_;
  deflection_ += (1.0 - std::exp(-dt / kTimeConstant)) * (wanted(deflection) - deflection_);
  if (settings_.mode == SpacenavSettings::Mode::kRate) {
    V_WT_ = {settings_.speed * deflection_.head<3>(), settings_.turning_speed * deflection_.tail<3>()};
    X_WT_.p += dt * V_WT_.linear;
    X_WT_.q = (rotation_from_vector(dt * V_WT_.angular) * X_WT_.q).normalized();
    return;
  }
  const Quaternion q_before = X_WT_.q;
  X_WT_ = {settings_.reach * deflection_.head<3>(), rotation_from_vector(settings_.tilt * deflection_.tail<3>())};
  V_WT_ = {settings_.reach * (deflection_ - before).head<3>() / dt,
           rotation_vector(X_WT_.q * q_before.conjugate()) / dt};
}

}  // namespace tegotae
