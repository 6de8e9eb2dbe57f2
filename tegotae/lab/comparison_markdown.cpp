// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/comparison_markdown.hpp>

#include <fmt/format.h>

#include <cmath>
#include <string_view>
#include <vector>

namespace tegotae {
namespace {

using Cells = std::vector<std::string>;

std::string line_of(const Cells& cells) {
  std::string line = "|";
  for (const std::string& cell : cells) line += " " + cell + " |";
  return line + "\n";
}

std::string rule_under(const Cells& head) {
  std::string line = "|---|";
  for (size_t i = 1; i < head.size(); ++i) line += "---:|";
  return line + "\n";
}

// Three significant digits, and no exponent where a reader would not want one.
std::string number(double value) {
  if (!std::isfinite(value)) return "not finite";
  return std::abs(value) >= 1000.0 ? fmt::format("{:.0f}", value) : fmt::format("{:.3g}", value);
}

// Where the reference has no force (or no torque) at all there is no part of it. Less than a hundredth of a thousandth
// is rounding, or nearly.
std::string percent(double part, double peak) {
  if (!(peak > 0.0)) return "–";
  return part > 0.0 && part < 1e-5 ? "< 0.001" : number(100.0 * part);
}

std::string state_text(const ComparisonRow& row) { return row.state == RowState::kFailed ? "failed" : "not reached"; }

std::string overview_cell(const ComparisonRow& row, const Deviation& deviation) {
  if (row.state != RowState::kDone) return state_text(row);
  return percent(deviation.relative_rmse(), deviation.peak) + " / " +
         percent(deviation.relative_worst(), deviation.peak);
}

std::string overview_of(const ComparisonResult& result, std::string_view what, Deviation ReferenceMetrics::*member) {
  std::string text = fmt::format("{}: RMSE / worst error in % of the reference's peak\n\n", what);
  Cells head = {"experiment"};
  for (const std::string& method : result.methods) head.push_back(method);
  text += line_of(head) + rule_under(head);
  for (const ExperimentComparison& experiment : result.experiments) {
    Cells cells = {experiment.name};
    for (const ComparisonRow& row : experiment.rows) {
      cells.push_back(overview_cell(row, row.against_reference.*member));
    }
    text += line_of(cells);
  }
  return text;
}

const Cells kErrorHead = {"method",           "force RMSE [N]",
                          "[% of peak]",      "worst [N]",
                          "[% of peak]",      "torque RMSE [N m]",
                          "[% of peak]",      "worst [N m]",
                          "[% of peak]",      "change of force a tick beyond the reference's [N]",
                          "of torque [mN m]", "greatest change of force a tick [N]",
                          "of torque [mN m]"};

Cells error_cells(const ComparisonRow& row) {
  const Deviation& force = row.against_reference.force;
  const Deviation& torque = row.against_reference.torque;
  Cells cells = {row.method};
  for (const Deviation* d : {&force, &torque}) {
    cells.push_back(number(d->rmse));
    cells.push_back(percent(d->relative_rmse(), d->peak));
    cells.push_back(number(d->worst));
    cells.push_back(percent(d->relative_worst(), d->peak));
  }
  cells.push_back(number(force.change_beyond));
  cells.push_back(number(torque.change_beyond * 1e3));
  cells.push_back(number(force.greatest_change));
  cells.push_back(number(torque.greatest_change * 1e3));
  return cells;
}

const Cells kRunHead = {"method",
                        "spurious torque [N m]",
                        "ghost contact [ticks]",
                        "ghost force [N]",
                        "penetration of the proxy [um]",
                        "energy injected [J]",
                        "energy given [J]",
                        "sampled spring's own [J]",
                        "ticks not ok",
                        "missed deadlines",
                        "tick median [us]",
                        "p99 [us]",
                        "p99.9 [us]"};

Cells run_cells(const ComparisonRow& row) {
  const ReferenceMetrics& held = row.against_reference;
  const RunMetrics& run = row.of_run;
  const DurationHistogram& times = run.tick_times;
  return {row.method,
          number(held.spurious_torque),
          std::to_string(held.ghost_run),
          number(held.ghost_force),
          number(run.proxy_penetration * 1e6),
          number(run.energy_excess),
          number(run.energy_given),
          number(run.energy_own),
          std::to_string(run.not_ok),
          "0",
          number(times.median() * 1e6),
          number(times.percentile(0.99) * 1e6),
          number(times.percentile(0.999) * 1e6)};
}

std::string table_of(const ExperimentComparison& experiment, const Cells& head, Cells (*cells)(const ComparisonRow&)) {
  std::string text = line_of(head) + rule_under(head);
  for (const ComparisonRow& row : experiment.rows) {
    text += row.state == RowState::kDone ? line_of(cells(row)) : line_of({row.method, state_text(row)});
  }
  return text + "\n";
}

std::string settings_of_rows(const ExperimentComparison& experiment) {
  for (const ComparisonRow& row : experiment.rows) {
    if (row.state != RowState::kDone) continue;
    const SessionSettings& settings = row.settings;
    const ReferenceMetrics& held = row.against_reference;
    return fmt::format(
        "k = {:g} N/m, d = {:g} N s/m, l = {:.4g} m, physics {:g} Hz, haptics {:g} Hz. {} ticks, {} with a reference, "
        "of which {} judged; the reference snaps in {}; its peaks: {} N, {} N m.\n\n",
        settings.stiffness, settings.damping, settings.metric_length, settings.physics_rate, settings.haptic_rate,
        held.ticks, held.defined, held.judged, held.snapping, number(held.force.peak), number(held.torque.peak));
  }
  return {};
}

std::string section_of(const ExperimentComparison& experiment) {
  std::string text =
      fmt::format("\n## {}\n\n{}.\n\n{}", experiment.name, experiment.summary, settings_of_rows(experiment));
  text += table_of(experiment, kErrorHead, error_cells) + table_of(experiment, kRunHead, run_cells);
  for (const ComparisonRow& row : experiment.rows) {
    if (!row.failure.empty()) text += fmt::format("- {} failed: {}\n", row.method, row.failure);
    for (const std::string& warning : row.warnings) text += fmt::format("- {}: {}\n", row.method, warning);
  }
  if (!experiment.figure.empty()) text += fmt::format("\n![{0}](figures/{0}.svg)\n", experiment.figure);
  return text;
}

// Marked where nothing unstable was found.
std::string limit_text(const StabilityRow& row) {
  const bool is_bounded = std::isfinite(row.limit.smallest_unstable);
  return fmt::format("{}{:.4g} ({:.3f})", is_bounded ? "" : "> ", row.limit.largest_stable, row.ratio_to_linear());
}

std::string limit_at(const StabilityOfMethod& method, std::string_view contact) {
  for (const StabilityRow& row : method.limits) {
    if (row.contact == contact) return limit_text(row);
  }
  return "–";
}

constexpr std::string_view kLegend =
    "Simulated time: all but the tick times repeats bit for bit, and no deadline can be missed. The wrench is the "
    "method's, before the safety stage. RMSE: over all ticks with a reference. Worst error, change beyond the "
    "reference's and spurious torque: without the ticks within 3 of one where the reference itself snaps. Spurious "
    "torque: greatest torque where the reference has none (under 1e-9 N m). Ghost contact: most ticks on end with more "
    "than 0.04 N, and the greatest force of all, where the reference touches nothing. Penetration: of the tool at the "
    "pose where the method says that the world lets it be, by certified distances and least parting translations of "
    "the static bodies' convex pieces; a method without such a pose has the interface's. Energy injected: beyond the "
    "sampled spring's own, the integral of k T v^2/2. The references keep the 2 um of skin that `proxy` keeps: a "
    "method without it is k times 2 um off where it is otherwise exact. Only `proxy` has friction; in experiments with "
    "friction the errors of the others show that.\n";

constexpr std::string_view kOverviewLegend =
    "The worst error leaves out ticks within 3 of one where the reference itself snaps, the RMSE does not, and may so "
    "be the greater one. –: the reference's peak is 0.\n";

}  // namespace

std::string comparison_overview(const ComparisonResult& result) {
  if (result.experiments.empty()) return "No experiment was compared.\n";
  return overview_of(result, "Force", &ReferenceMetrics::force) + "\n" +
         overview_of(result, "Torque", &ReferenceMetrics::torque) + "\n" + std::string(kOverviewLegend);
}

std::string stability_table(const ComparisonResult& result) {
  if (result.stability.empty()) return {};
  std::string text =
      "Largest stable stiffness in N/m and its ratio to (b + B)/(T/2 + t_d); energy in random contact\n\n";
  Cells head = {"method"};
  for (const TouchedFeature& feature : touched_features()) head.emplace_back(feature.name);
  for (const char* name : {"energy injected [J]", "energy given [J]", "sampled spring's own [J]"})
    head.emplace_back(name);
  text += line_of(head) + rule_under(head);
  for (const StabilityOfMethod& method : result.stability) {
    Cells cells = {method.method};
    for (const TouchedFeature& feature : touched_features()) cells.push_back(limit_at(method, feature.name));
    if (method.energy) {
      for (const double joule : {method.energy->excess, method.energy->given, method.energy->allowed}) {
        cells.push_back(number(joule));
      }
    }
    cells.resize(head.size(), "–");
    text += line_of(cells);
  }
  for (const StabilityOfMethod& method : result.stability) {
    if (!method.failure.empty()) text += fmt::format("\n- {}: {}\n", method.method, method.failure);
  }
  return text;
}

std::string comparison_markdown(const ComparisonResult& result) {
  std::string text = "# Comparison of methods\n\n";
  if (result.interrupted) text += "**Interrupted: what was not reached until then is marked.**\n\n";
  text += comparison_overview(result) + "\n" + std::string(kLegend);
  for (const ExperimentComparison& experiment : result.experiments) text += section_of(experiment);
  const std::string stability = stability_table(result);
  return stability.empty() ? text : text + "\n## Stability\n\n" + stability;
}

}  // namespace tegotae
