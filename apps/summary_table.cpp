// SPDX-License-Identifier: Apache-2.0
#include <apps/summary_table.hpp>
#include <tegotae/runtime/safety.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <set>

namespace tegotae {
namespace {

std::string settings_line(const SessionSettings& settings) {
  return fmt::format("method {}, k = {:g} N/m, d = {:g} N s/m, l = {:.4g} m, physics {:g} Hz, haptics {:g} Hz",
                     settings.method, settings.stiffness, settings.damping, settings.metric_length,
                     settings.physics_rate, settings.haptic_rate);
}

// Rounded first, so that no "-0.000" appears.
double rounded(double value) { return std::round(value * 1e3) / 1e3 + 0.0; }

std::string range(const Spread& spread) {
  return fmt::format("{:.3f} to {:.3f}", rounded(spread.min), rounded(spread.max));
}

constexpr double kMicrosecond = 1e-6, kMillisecond = 1e-3;  // s

std::string title_of(const PhaseSummary& summary) { return summary.phase.name + "  " + summary.phase.summary; }

// Of the column of titles, wide enough for each phase.
size_t title_width(const RunSummary& summary) {
  size_t width = 35;
  for (const PhaseSummary& phase : summary.phases) width = std::max(width, title_of(phase).size());
  return width;
}

std::string row(const PhaseSummary& summary, size_t width, bool in_real_time) {
  const std::string title = title_of(summary);
  if (summary.ticks == 0) return fmt::format("  {:<{}}{:>20}\n", title, width, "not reached");
  const DurationHistogram& times = summary.tick_times;
  return fmt::format(
      "  {:<{}}{:>20}{:>12.3f}{:>20}{:>12.3f}{:>12}   {:>7.1f} {:>7.1f} {:>7.1f} {:>7.1f}   {}\n", title, width,
      range(summary.reported_force), rounded(summary.force_at_end), range(summary.reported_torque),
      rounded(summary.torque_at_end), fmt::format("{:g} to {:g}", summary.contacts.min, summary.contacts.max),
      times.median() / kMicrosecond, times.percentile(0.99) / kMicrosecond, times.percentile(0.999) / kMicrosecond,
      times.max() / kMicrosecond, in_real_time ? fmt::format("{}", summary.missed_deadlines) : "none: simulated time");
}

// What the run in real time was like.
std::string real_time_lines(const RealtimeReport& report) {
  const DurationHistogram &age = report.haptics.staleness, &wake_up = report.wake_up, &step = report.physics.durations;
  std::string text = fmt::format(
      "  real time: {} of {} ticks missed their deadline; wake-up late by {:.0f} us (median), {:.0f} us (p99.9)\n"
      "  model age {:.0f} ms (median), {:.0f} ms (max); physics step {:.2f} ms (median), {:.2f} ms (max)\n",
      report.haptics.missed_deadlines, report.haptics.missed_deadlines + report.haptics.count(),
      wake_up.median() / kMicrosecond, wake_up.percentile(0.999) / kMicrosecond, age.median() / kMillisecond,
      age.max() / kMillisecond, step.median() / kMillisecond, step.max() / kMillisecond);
  if (report.dropped_records > 0) text += fmt::format("  {} ticks are not in the samples\n", report.dropped_records);
  return text;
}

// What the interface made of what it was commanded, and what the safety stage kept from it.
std::string display_lines(const DisplaySummary& display, const RunSummary& summary) {
  const DisplayErrors& errors = display.reachable;
  return fmt::format(
      "  displayed less commanded: {:.3g} mN RMS, {:.3g} mN at most; {:.3g} and {:.3g} mN m; the motors fell short in "
      "{} "
      "of {} ticks\n"
      "  commanded at most {:.3g} N and {:.3g} N m; force saturated in {} ticks, torque in {}; the tool at most {:.1f} "
      "mm "
      "and {:.1f} degrees from where the hand meant it\n",
      1e3 * errors.force_rms, 1e3 * errors.force_max, 1e3 * errors.torque_rms, 1e3 * errors.torque_max,
      display.shortfalls, display.all.ticks, display.greatest_force, display.greatest_torque,
      summary.safety_events.at(name_of(SafetyEvent::kForceSaturated)),
      summary.safety_events.at(name_of(SafetyEvent::kTorqueSaturated)), 1e3 * display.hand_way,
      display.hand_angle * 180.0 / std::numbers::pi);
}

// What the system refused to the threads, each sentence once.
std::string rights_lines(const ExperimentResult& result) {
  std::set<std::string> sentences;
  for (const VariantResult& variant : result.variants) {
    if (!variant.real_time) return {};
    sentences.insert(variant.real_time->haptic_rights.explanation);
    sentences.insert(variant.real_time->physics_rights.explanation);
  }
  sentences.erase("");
  if (sentences.empty()) return "The threads ran under SCHED_FIFO with locked memory.\n";
  std::string text;
  for (const std::string& sentence : sentences) text += sentence + "\n";
  return text;
}

}  // namespace

std::string summary_table(const ExperimentResult& result) {
  const Experiment& experiment = result.experiment;
  std::string text = fmt::format("{}: {}\n", experiment.name, experiment.summary);
  auto out = std::back_inserter(text);
  for (const VariantResult& variant : result.variants) {
    fmt::format_to(out, "\n{}: {}\n  {}\n", variant.variant.name, variant.variant.summary,
                   settings_line(variant.settings));
    const size_t width = title_width(variant.summary);
    fmt::format_to(out, "  {:<{}}{:>20}{:>12}{:>20}{:>12}{:>12}   {:<31}   {}\n", "phase", width,
                   fmt::format("force {} [N]", experiment.force_axis.name), "at its end",
                   fmt::format("torque {} [N m]", experiment.torque_axis.name), "at its end", "contacts",
                   "tick median, p99, p99.9, max [us]", "missed deadlines");
    const bool in_real_time = variant.real_time.has_value();
    for (const PhaseSummary& phase : variant.summary.phases) text += row(phase, width, in_real_time);
    if (!variant.physics_rate_choice.empty()) fmt::format_to(out, "  {}\n", variant.physics_rate_choice);
    if (variant.display) text += display_lines(*variant.display, variant.summary);
    if (variant.real_time) text += real_time_lines(*variant.real_time);
  }
  text += '\n' + rights_lines(result);
  for (const VariantResult& variant : result.variants)
    fmt::format_to(out, "samples: {}\n", variant.samples_file.string());
  fmt::format_to(out, "summary: {}\n", result.summary_file.string());
  return text;
}

}  // namespace tegotae
