// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/summary.hpp>

#include <tegotae/render/render_types.hpp>
#include <tegotae/runtime/safety.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace tegotae {
namespace {

template <class Number>
Spread spread_of(std::span<const TickRecord> records, Number&& number) {
  if (records.empty()) return {};
  Spread spread{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity(), 0.0};
  for (const TickRecord& record : records) {
    const double value = number(record);
    spread.min = std::min(spread.min, value);
    spread.max = std::max(spread.max, value);
    spread.mean += value;
  }
  spread.mean /= static_cast<double>(records.size());
  return spread;
}

// Whole periods from the tick before the first to the last, less those that had theirs. `before`: null, the run begins
// with the first tick.
std::uint64_t missed_in(std::span<const TickRecord> records, const TickRecord* before, double haptic_rate) {
  if (records.empty()) return 0;
  const double begin = before != nullptr ? before->time : records.front().time - 1.0 / haptic_rate;
  const long periods = std::lround((records.back().time - begin) * haptic_rate);
  return static_cast<std::uint64_t>(std::max(0L, periods - static_cast<long>(records.size())));
}

PhaseSummary summary_of(const Experiment& experiment, const Phase& phase, std::span<const TickRecord> records) {
  PhaseSummary summary;
  summary.phase = phase;
  summary.ticks = records.size();
  for (size_t i = 0; i < 3; ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    summary.force[i] = spread_of(records, [&](const TickRecord& r) { return r.wrench.force.vector()[axis]; });
    summary.torque[i] = spread_of(records, [&](const TickRecord& r) { return r.wrench.torque.vector()[axis]; });
  }
  const Vector3 along_force = experiment.force_axis.direction, along_torque = experiment.torque_axis.direction;
  summary.force_norm = spread_of(records, [](const TickRecord& r) { return r.wrench.force.vector().norm(); });
  summary.torque_norm = spread_of(records, [](const TickRecord& r) { return r.wrench.torque.vector().norm(); });
  summary.reported_force =
      spread_of(records, [&](const TickRecord& r) { return along_force.dot(r.wrench.force.vector()); });
  summary.reported_torque =
      spread_of(records, [&](const TickRecord& r) { return along_torque.dot(r.wrench.torque.vector()); });
  if (!records.empty()) {
    summary.force_at_end = along_force.dot(records.back().wrench.force.vector());
    summary.torque_at_end = along_torque.dot(records.back().wrench.torque.vector());
  }
  summary.contacts = spread_of(records, [](const TickRecord& r) { return static_cast<double>(r.active); });
  summary.deepest = spread_of(records, [](const TickRecord& r) { return r.deepest; });
  for (size_t i = 1; i < records.size(); ++i) {
    const Wrench step = Wrench(records[i].wrench) - Wrench(records[i - 1].wrench);
    summary.greatest_force_step = std::max(summary.greatest_force_step, step.force.norm());
    summary.greatest_torque_step = std::max(summary.greatest_torque_step, step.torque.norm());
  }
  for (const TickRecord& record : records) summary.tick_times.add(record.tick_us * 1e-6);
  return summary;
}

// Half a microsecond: times of ticks are whole periods, but for rounding.
std::span<const TickRecord> between(std::span<const TickRecord> records, double begin, double end) {
  constexpr double kHalfMicrosecond = 5e-7;  // s
  const auto earlier = [](const TickRecord& record, double time) { return record.time < time - kHalfMicrosecond; };
  const auto first = std::lower_bound(records.begin(), records.end(), begin, earlier);
  const auto last = std::lower_bound(first, records.end(), end, earlier);
  return {first, last};
}

}  // namespace

RunSummary summarise(const Experiment& experiment, std::span<const TickRecord> records, double haptic_rate) {
  RunSummary summary;
  for (size_t i = 0; i < experiment.phases.size(); ++i) {
    const Phase& phase = experiment.phases[i];
    const bool is_last = i + 1 == experiment.phases.size();
    const double end = is_last ? std::numeric_limits<double>::infinity() : phase.end;
    const std::span<const TickRecord> ticks = between(records, phase.begin, end);
    const TickRecord* const before = ticks.data() == records.data() ? nullptr : ticks.data() - 1;
    summary.phases.push_back(summary_of(experiment, phase, ticks));
    summary.phases.back().missed_deadlines = missed_in(ticks, before, haptic_rate);
    summary.haptics.missed_deadlines += summary.phases.back().missed_deadlines;
  }
  for (size_t event = 0; event < kSafetyEvents; ++event) {
    summary.safety_events[name_of(static_cast<SafetyEvent>(event))] = 0;
  }
  for (const TickRecord& record : records) {
    ++summary.statuses[name_of(static_cast<RenderStatus>(record.status))];
    for (size_t event = 0; event < kSafetyEvents; ++event) {
      if ((record.safety_events >> event & 1U) != 0) ++summary.safety_events[name_of(static_cast<SafetyEvent>(event))];
    }
    summary.dropped += static_cast<std::uint64_t>(record.dropped);
    summary.haptics.add(record.tick_us * 1e-6, record.model_age);
  }
  return summary;
}

}  // namespace tegotae
