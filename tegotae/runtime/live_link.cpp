// SPDX-License-Identifier: Apache-2.0
#include <tegotae/runtime/live_link.hpp>

#include <algorithm>
#include <cmath>

namespace tegotae {

void LiveLink::grant_step(double physics_period, double haptic_period) noexcept {
  steps_granted.store(1, std::memory_order_relaxed);
  const int ticks = static_cast<int>(std::lround(physics_period / haptic_period));
  ticks_granted.store(std::max(ticks, 1), std::memory_order_relaxed);
}

void LiveLink::pause(bool stands_still) noexcept {
  paused.store(stands_still, std::memory_order_relaxed);
  steps_granted.store(0, std::memory_order_relaxed);
  ticks_granted.store(0, std::memory_order_relaxed);
}

}  // namespace tegotae
