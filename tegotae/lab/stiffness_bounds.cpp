// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/stiffness_bounds.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tegotae {
namespace {

// 2 friction / step; without quantisation nothing limits.
double friction_bound(double friction, double step) noexcept {
  return step > 0.0 ? 2.0 * friction / step : std::numeric_limits<double>::infinity();
}

}  // namespace

StiffnessBounds stiffness_bounds(const StiffnessBoundInput& input) noexcept {
  const GripMechanics& grip = input.device.mechanics;
  const double l2 = input.metric_length * input.metric_length, period = input.period, own = std::abs(input.damping);
  const double delay = 0.5 * period + input.device.delay;
  StiffnessBounds bounds;
  bounds.linear_translation = (grip.damping + input.hand.damping + input.damping) / delay;
  bounds.linear_rotation = ((grip.rotational_damping + input.hand.rotational_damping) / l2 + input.damping) / delay;
  bounds.linear = std::min(bounds.linear_translation, bounds.linear_rotation);

  const double viscous = std::min(grip.damping, grip.rotational_damping / l2);
  bounds.colgate_schenkel = std::max(2.0 * (viscous - own) / period, 0.0);
  bounds.abbott_okamura =
      std::min({2.0 * viscous / period, friction_bound(grip.friction_force, input.device.capability.encoder_step),
                friction_bound(grip.friction_torque, input.device.encoder_angle) / l2});
  return bounds;
}

}  // namespace tegotae
