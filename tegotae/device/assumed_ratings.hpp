// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/runtime/haptic_interface.hpp>

namespace tegotae {

/// What stands in for ratings that a maker does not state. A guess by reason, on the cautious side; none was measured.
namespace assumed {

/// m. A rotational rating is what the rating in translation, K or B, does at this arm, half a grip: K l^2, B l^2.
inline constexpr double kArm = 0.05;

/// s. A damper of rating B = K t: as the rated spring does, it changes the force by K x where the hand goes x in t, and
/// makers' velocities are means over up to 20 ms, half of that late.
inline constexpr double kTime = 0.01;

/// N s/m. With a velocity that is late by t = 10 ms a damper on a free mass m swings up from B = (pi/2) m/t on: 31 at
/// 0.2 kg, what the grips of such devices weigh. Four fifths of that, for sampling.
inline constexpr double kMostDamping = 25.0;

}  // namespace assumed

/// `capability` with the ratings that it leaves infinite (damping; rotational stiffness and damping where it displays a
/// torque) put to those that follow from its rated stiffness; as it is where no stiffness is stated. What a maker
/// states stays.
InterfaceCapability with_assumed_ratings(InterfaceCapability capability) noexcept;

}  // namespace tegotae
