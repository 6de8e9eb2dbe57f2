// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/physics_rate.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace tegotae {
namespace {

constexpr double kPeriods[] = {2e-3, 4e-3, 6e-3, 8e-3, 10e-3, 16e-3, 20e-3, 30e-3, 40e-3, 50e-3};  // s
constexpr double kShareOfCore = 1.0 / 3.0;  // leaves the rest to the haptic thread and to steps longer than the median
constexpr double kModelTime = 0.2e-3;       // s, to make a model of tens of near objects

}  // namespace

double shortest_publish_period(double step_time, double max_substep) noexcept {
  for (const double period : kPeriods) {
    const double substeps = std::ceil(period / max_substep * (1.0 - 1e-9));
    if ((substeps + 1.0) * step_time + kModelTime <= kShareOfCore * period) return period;
  }
  return *std::rbegin(kPeriods);
}

PhysicsRateChoice measured_physics_rate(const MujocoWorld& world, double haptic_rate) {
  const double step_time = world.measure_step_time();
  const double rate = std::min(1.0 / shortest_publish_period(step_time, world.max_substep()), haptic_rate);
  return {rate, fmt::format("physics at {:g} Hz, chosen as a step of the scene takes {:.3f} ms on this machine", rate,
                            step_time * 1e3)};
}

}  // namespace tegotae
