// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/reference_metrics.hpp>

#include <tegotae/lab/tolerances.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <vector>

namespace tegotae {
namespace {

// The magnitude, infinite where it is not a number, so that a maximum does not pass over it.
double size_of(const Vector3& vector) {
  const double norm = vector.norm();
  return std::isnan(norm) ? std::numeric_limits<double>::infinity() : norm;
}

std::vector<bool> judged_ticks(std::span<const ReferenceSample> reference) {
  std::vector<bool> judged;
  judged.reserve(reference.size());
  for (const ReferenceSample& sample : reference) judged.push_back(sample.defined);
  const auto count = static_cast<long>(reference.size());
  for (long i = 0; i < count; ++i) {
    if (!reference[static_cast<size_t>(i)].snaps) continue;
    const long last = std::min(count - 1, i + ReferenceMetrics::kSnapTicks);
    for (long j = std::max(0L, i - ReferenceMetrics::kSnapTicks); j <= last; ++j)
      judged[static_cast<size_t>(j)] = false;
  }
  return judged;
}

/// One of the two vectors of a wrench over the run.
struct Series {
  std::vector<Vector3> value, reference;
};

void add_change(const Series& series, const std::vector<bool>& judged, size_t i, Deviation& deviation) {
  const Vector3 change = series.value[i] - series.value[i - 1];
  deviation.greatest_change = std::max(deviation.greatest_change, size_of(change));
  if (!judged[i] || !judged[i - 1]) return;
  const Vector3 of_reference = series.reference[i] - series.reference[i - 1];
  deviation.change_beyond = std::max(deviation.change_beyond, size_of(change - of_reference));
}

Deviation deviation_of(const Series& series, std::span<const TickRecord> records,
                       std::span<const ReferenceSample> reference, const std::vector<bool>& judged) {
  Deviation deviation;
  double squares = 0.0, defined = 0.0;
  for (size_t i = 0; i < records.size(); ++i) {
    if (i > 0) add_change(series, judged, i, deviation);
    if (!reference[i].defined) continue;
    const double error = size_of(series.value[i] - series.reference[i]);
    deviation.peak = std::max(deviation.peak, size_of(series.reference[i]));
    squares += error * error;
    ++defined;
    if (!judged[i] || error <= deviation.worst) continue;
    deviation.worst = error;
    deviation.worst_time = records[i].time;
  }
  deviation.rmse = defined > 0.0 ? std::sqrt(squares / defined) : std::numeric_limits<double>::quiet_NaN();
  return deviation;
}

void add_ghosts(const Series& force, std::span<const ReferenceSample> reference, ReferenceMetrics& metrics) {
  int run = 0;
  for (size_t i = 0; i < reference.size(); ++i) {
    const bool is_free = reference[i].defined && !reference[i].touches;
    const double size = is_free ? size_of(force.value[i]) : 0.0;
    metrics.ghost_force = std::max(metrics.ghost_force, size);
    run = size > tolerance::kFeltForce ? run + 1 : 0;
    metrics.ghost_run = std::max(metrics.ghost_run, run);
  }
}

double spurious_torque(const Series& torque, const std::vector<bool>& judged) {
  double greatest = 0.0;
  for (size_t i = 0; i < judged.size(); ++i) {
    if (!judged[i] || !(torque.reference[i].norm() < tolerance::kNoTorque)) continue;
    greatest = std::max(greatest, size_of(torque.value[i]));
  }
  return greatest;
}

}  // namespace

ReferenceMetrics reference_metrics(std::span<const TickRecord> records, std::span<const ReferenceSample> reference) {
  if (records.size() != reference.size()) {
    throw std::invalid_argument(
        fmt::format("the reference has {} samples, and the run {} ticks.", reference.size(), records.size()));
  }
  const std::vector<bool> judged = judged_ticks(reference);
  Series force, torque;
  for (const TickRecord& record : records) {
    force.value.push_back(record.wrench.force);
    torque.value.push_back(record.wrench.torque);
  }
  ReferenceMetrics metrics;
  metrics.ticks = static_cast<long>(records.size());
  metrics.judged = std::count(judged.begin(), judged.end(), true);
  for (const ReferenceSample& sample : reference) {
    force.reference.push_back(sample.wrench.force);
    torque.reference.push_back(sample.wrench.torque);
    if (sample.defined) ++metrics.defined;
    if (sample.snaps) ++metrics.snapping;
  }
  metrics.force = deviation_of(force, records, reference, judged);
  metrics.torque = deviation_of(torque, records, reference, judged);
  metrics.spurious_torque = spurious_torque(torque, judged);
  add_ghosts(force, reference, metrics);
  return metrics;
}

}  // namespace tegotae
