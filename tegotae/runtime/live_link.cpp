// SPDX-License-Identifier: Apache-2.0
#include <tegotae/runtime/live_link.hpp>

#include <algorithm>
#include <cmath>

namespace tegotae {

void LiveLink::grant_step(double physics_period, double haptic_period) noexcept {
  steps_granted.fetch_add(1, std::memory_order_relaxed);
  const int ticks = static_cast<int>(std::lround(physics_period / haptic_period));
  ticks_granted.fetch_add(std::max(ticks, 1), std::memory_order_relaxed);
}

}  // namespace tegotae
