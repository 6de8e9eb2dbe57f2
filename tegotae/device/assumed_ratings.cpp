// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/assumed_ratings.hpp>

#include <algorithm>
#include <cmath>

namespace tegotae {
namespace {

void assume(double& rating, double value) noexcept {
  if (std::isinf(rating)) rating = value;
}

}  // namespace

InterfaceCapability with_assumed_ratings(InterfaceCapability capability) noexcept {
  if (!std::isfinite(capability.max_stiffness)) return capability;
  constexpr double kSquare = assumed::kArm * assumed::kArm;  // m^2
  assume(capability.max_damping, std::min(assumed::kTime * capability.max_stiffness, assumed::kMostDamping));
  if (capability.max_torque <= 0.0) return capability;
  assume(capability.max_rotational_stiffness, kSquare * capability.max_stiffness);
  assume(capability.max_rotational_damping, kSquare * capability.max_damping);
  return capability;
}

}  // namespace tegotae
