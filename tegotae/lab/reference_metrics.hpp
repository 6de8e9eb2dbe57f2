// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/reference.hpp>
#include <tegotae/runtime/tick_record.hpp>

#include <span>

namespace tegotae {

/// How far force (N) or torque about the tool's centre of mass (N m) is from the reference's. With v_i the method's
/// vector at tick i, r_i the reference's and e_i = |v_i - r_i|:
struct Deviation {
  double peak = 0.0;             ///< max |r_i| over defined ticks
  double rmse = 0.0;             ///< sqrt(mean e_i^2) over defined ticks
  double worst = 0.0;            ///< max e_i over judged ticks
  double worst_time = 0.0;       ///< s, of that tick
  double change_beyond = 0.0;    ///< max |(v_i - v_(i-1)) - (r_i - r_(i-1))| where both ticks are judged
  double greatest_change = 0.0;  ///< max |v_i - v_(i-1)| over all ticks, whatever the reference says

  double relative_rmse() const noexcept { return rmse / peak; }    ///< of the peak; not finite where that is 0
  double relative_worst() const noexcept { return worst / peak; }  ///< of the peak; not finite where that is 0
};

/// A run held to its reference. A tick is *defined* where the reference is, and *judged* where besides no tick within
/// `kSnapTicks` of it snaps: when the right answer leaps, being a tick early or late is no error of the wrench.
struct ReferenceMetrics {
  static constexpr int kSnapTicks = 3;

  Deviation force, torque;
  long ticks = 0, defined = 0, judged = 0, snapping = 0;
  double spurious_torque = 0.0;  ///< N m, greatest |torque| at judged ticks where the reference's is under kNoTorque
  int ghost_run = 0;         ///< most ticks on end with a force above kFeltForce where the reference touches nothing
  double ghost_force = 0.0;  ///< N, greatest force at any tick where the reference touches nothing
};

/// What the method rendered (TickRecord::wrench: before the safety stage, which is the same for all methods) against
/// `reference`, a sample a record. A wrench that is not finite counts as an infinite error. Throws
/// std::invalid_argument where there is not one sample a record.
ReferenceMetrics reference_metrics(std::span<const TickRecord> records, std::span<const ReferenceSample> reference);

}  // namespace tegotae
