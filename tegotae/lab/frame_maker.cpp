// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/frame_maker.hpp>

#include <tegotae/lab/unix_time.hpp>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace tegotae {
namespace {

constexpr double kSampleSpan = 0.05;  // s
constexpr double kRateSpan = 1.0;     // s
constexpr double kFirstEdge = 1.0;    // us

Coupling coupling_of(const SessionSettings& settings) {
  return {settings.stiffness, settings.damping, settings.metric_length, settings.rotational_damping};
}

}  // namespace

FrameMaker::FrameMaker(const SessionSettings& settings, const Vector3& p_TCm)
    : settings_(settings), passivity_(coupling_of(settings), p_TCm) {}

void FrameMaker::change(const SessionSettings& settings) {
  settings_ = settings;
  passivity_.change(coupling_of(settings));
}

void FrameMaker::add(const TickRecord& record) {
  count(record);
  newest_ = record;
  samples_.push_back({record.time, record.displayed});
  events_.push_back(record.safety_events);
  last_second_.push_back(record.time);
  while (samples_.front().time < record.time - kSampleSpan) {
    samples_.pop_front();
    events_.pop_front();
  }
  while (last_second_.front() < record.time - kRateSpan) last_second_.pop_front();
  passivity_.add(record);
}

// Time that a run stood still is not in the records' times, so a gap is a missed period.
void FrameMaker::count(const TickRecord& record) {
  const double periods = (record.time - newest_.time) * settings_.haptic_rate;
  if (ticks_ > 0 && periods > 1.5) missed_ += static_cast<std::uint64_t>(std::lround(periods)) - 1;
  ++ticks_;
  durations_.add(1e-6 * record.tick_us);
  const double bin = std::floor(std::log10(std::max(record.tick_us, 1e-3) / kFirstEdge) * kBinsPerDecade);
  ++bins_[static_cast<std::size_t>(std::clamp(bin, 0.0, kBins - 1.0))];
}

ViewFrame FrameMaker::frame(const ContactView& contacts, const MovingBodies& bodies) {
  ViewFrame frame;
  frame.n = ++frames_;
  frame.time = newest_.time;
  frame.made_ms = unix_milliseconds();
  frame.X_WT = newest_.X_WT;
  frame.X_WP = newest_.X_WP;
  frame.displayed = newest_.displayed;
  frame.bodies.assign(bodies.used().begin(), bodies.used().end());
  frame.contacts = contacts;
  frame.samples.assign(samples_.begin(), samples_.end());
  count(bodies);
  frame.numbers = numbers();
  frame.numbers.contacts = contacts.point_count;
  return frame;
}

ViewedNumbers FrameMaker::numbers() const {
  ViewedNumbers numbers;
  numbers.tick_median_us = 1e6 * durations_.median();
  numbers.tick_p99_us = 1e6 * durations_.percentile(0.99);
  numbers.tick_p999_us = 1e6 * durations_.percentile(0.999);
  numbers.tick_max_us = 1e6 * durations_.max();
  numbers.ticks = ticks_;
  const double span = last_second_.empty() ? 0.0 : last_second_.back() - last_second_.front();
  numbers.haptic_rate = span > 0.0 ? static_cast<double>(last_second_.size() - 1) / span : 0.0;
  numbers.physics_rate = physics_rate();
  numbers.physics_step_ms = 1e3 * physics_steps_.median();
  numbers.staleness_ms = 1e3 * newest_.model_age;
  numbers.missed = missed_;
  numbers.near_objects = newest_.near_objects;
  numbers.active = newest_.active;
  numbers.constraints = newest_.constraints;
  numbers.dropped = newest_.dropped;
  numbers.iterations = newest_.solver_iterations;
  numbers.depth = newest_.deepest;
  numbers.energy = passivity_.excess();
  numbers.status = static_cast<RenderStatus>(newest_.status);
  for (const std::uint32_t events : events_) numbers.safety_events |= events;
  return numbers;
}

// A run that is paused shows the same step again and again.
void FrameMaker::count(const MovingBodies& bodies) {
  if (!physics_last_second_.empty() && physics_last_second_.back().count == bodies.steps) return;
  if (bodies.steps > 0) physics_steps_.add(bodies.step_duration);
  physics_last_second_.push_back({bodies.time, bodies.steps});
  while (physics_last_second_.front().time < bodies.time - kRateSpan) physics_last_second_.pop_front();
}

double FrameMaker::physics_rate() const {
  const Steps &first = physics_last_second_.front(), &last = physics_last_second_.back();
  const double span = last.time - first.time;
  return span > 0.0 ? static_cast<double>(last.count - first.count) / span : 0.0;
}

ViewedHistogram FrameMaker::histogram() const {
  ViewedHistogram histogram;
  for (int i = 0; i <= kBins; ++i) {
    histogram.edges_us.push_back(kFirstEdge * std::pow(10.0, static_cast<double>(i) / kBinsPerDecade));
  }
  histogram.counts.assign(bins_.begin(), bins_.end());
  return histogram;
}

}  // namespace tegotae
