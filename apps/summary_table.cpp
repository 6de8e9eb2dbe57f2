// SPDX-License-Identifier: Apache-2.0
#include "summary_table.hpp"

#include <fmt/format.h>

#include <iterator>

namespace tegotae {
namespace {

std::string settings_line(const SessionSettings& settings) {
  return fmt::format("method {}, k = {:g} N/m, d = {:g} N s/m, l = {:.4g} m, physics {:g} Hz, haptics {:g} Hz",
                     settings.method, settings.stiffness, settings.damping, settings.metric_length,
                     settings.physics_rate, settings.haptic_rate);
}

// Rounded first, so that no "-0.000" appears.
std::string range(const Spread& spread) {
  const auto rounded = [](double value) { return std::round(value * 1e3) / 1e3 + 0.0; };
  return fmt::format("{:.3f} to {:.3f}", rounded(spread.min), rounded(spread.max));
}

std::string row(const PhaseSummary& summary) {
  constexpr double kMicrosecond = 1e-6;
  const DurationHistogram& times = summary.tick_times;
  return fmt::format("  {:<34}{:>18}{:>18}{:>12}   {:>7.1f} {:>7.1f} {:>7.1f} {:>7.1f}   {}\n",
                     summary.phase.name + "  " + summary.phase.summary, range(summary.reported_force),
                     range(summary.reported_torque),
                     fmt::format("{:g} to {:g}", summary.contacts.min, summary.contacts.max),
                     times.median() / kMicrosecond, times.percentile(0.99) / kMicrosecond,
                     times.percentile(0.999) / kMicrosecond, times.max() / kMicrosecond, "simulated time");
}

}  // namespace

std::string summary_table(const Experiment& experiment, const ExperimentResult& result) {
  std::string text = fmt::format("{}: {}\n", experiment.name, experiment.summary);
  auto out = std::back_inserter(text);
  for (const VariantResult& variant : result.variants) {
    fmt::format_to(out, "\n{}: {}\n  {}\n", variant.variant.name, variant.variant.summary,
                   settings_line(variant.settings));
    fmt::format_to(out, "  {:<34}{:>18}{:>18}{:>12}   {:<31}   {}\n", "phase",
                   fmt::format("force {} [N]", experiment.force_axis.name),
                   fmt::format("torque {} [N m]", experiment.torque_axis.name), "contacts",
                   "tick median, p99, p99.9, max [us]", "missed deadlines");
    for (const PhaseSummary& phase : variant.summary.phases) text += row(phase);
  }
  text += '\n';
  for (const VariantResult& variant : result.variants)
    fmt::format_to(out, "samples: {}\n", variant.samples_file.string());
  fmt::format_to(out, "summary: {}\n", result.summary_file.string());
  return text;
}

}  // namespace tegotae
