// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/display_summary.hpp>

#include <tegotae/math/rotation.hpp>

#include <algorithm>
#include <cmath>

namespace tegotae {
namespace {

// The sums of squares, until `finish`.
void add(DisplayErrors& errors, double force, double torque) {
  ++errors.ticks;
  errors.force_rms += force * force;
  errors.torque_rms += torque * torque;
  errors.force_max = std::max(errors.force_max, force);
  errors.torque_max = std::max(errors.torque_max, torque);
}

void finish(DisplayErrors& errors) {
  if (errors.ticks == 0) return;
  errors.force_rms = std::sqrt(errors.force_rms / static_cast<double>(errors.ticks));
  errors.torque_rms = std::sqrt(errors.torque_rms / static_cast<double>(errors.ticks));
}

}  // namespace

DisplaySummary display_summary(std::span<const TickRecord> records) {
  DisplaySummary summary;
  for (const TickRecord& record : records) {
    const Wrench commanded = record.displayed, error = Wrench(record.interface_wrench) - commanded;
    const double force = error.force.norm(), torque = error.torque.norm();
    add(summary.all, force, torque);
    if (record.falls_short) {
      ++summary.shortfalls;
    } else {
      add(summary.reachable, force, torque);
    }
    summary.greatest_force = std::max(summary.greatest_force, commanded.force.norm());
    summary.greatest_torque = std::max(summary.greatest_torque, commanded.torque.norm());
    const Pose X_WT = record.X_WT, X_WH = record.X_WH;
    summary.hand_way = std::max(summary.hand_way, (X_WH.p - X_WT.p).norm());
    summary.hand_angle = std::max(summary.hand_angle, rotation_vector(X_WH.q * X_WT.q.conjugate()).norm());
  }
  finish(summary.all);
  finish(summary.reachable);
  return summary;
}

}  // namespace tegotae
