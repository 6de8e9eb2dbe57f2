// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/hand_effort.hpp>

#include <tegotae/math/rotation.hpp>
#include <tegotae/runtime/vector_limits.hpp>

#include <utility>
#include <vector>

namespace tegotae {
namespace {

constexpr double kHalfWindow = 0.05 + 1e-9;  // s; times are sums of periods, rounded

Wrench about_grip(const TickRecord& record, const Tool& tool) {
  return Wrench(record.wrench).shifted(record.X_WT.pose().q * tool.mass.centre_of_mass);
}

// At equilibrium the hand's spring pulls against the wrench on the grip.
Pose pressing(const Pose& X_WT, const Wrench& wrench, const HandImpedance& hand) {
  const Vector3 turned = -wrench.torque / hand.rotational_stiffness;
  return {X_WT.p - wrench.force / hand.stiffness, (rotation_from_vector(turned) * X_WT.q).normalized()};
}

}  // namespace

Trajectory with_effort(std::span<const TickRecord> played, double start, const Tool& tool, const HandImpedance& hand,
                       const EffortLimits& limits) {
  std::vector<Trajectory::Sample> samples;
  Wrench sum;  // of the records from `first` up to `last`
  size_t first = 0, last = 0;
  for (const TickRecord& record : played) {
    for (; last < played.size() && played[last].time <= record.time + kHalfWindow; ++last) {
      sum = sum + about_grip(played[last], tool);
    }
    for (; played[first].time < record.time - kHalfWindow; ++first) sum = sum - about_grip(played[first], tool);
    Wrench mean = sum * (1.0 / static_cast<double>(last - first));
    mean = {saturated(mean.force, limits.force), saturated(mean.torque, limits.torque)};
    samples.push_back({start + record.time, pressing(record.X_WT, mean, hand)});
  }
  return Trajectory(std::move(samples));
}

}  // namespace tegotae
