// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/comparison_figure.hpp>
#include <tegotae/lab/quantities.hpp>

#include <limits>

namespace tegotae {
namespace {

// As if a run had displayed it, so that it is drawn as one; not a number where nothing is known, which is left out.
std::vector<TickRecord> reference_records(std::span<const TickRecord> like,
                                          std::span<const ReferenceSample> reference) {
  std::vector<TickRecord> records;
  for (size_t i = 0; i < like.size() && i < reference.size(); ++i) {
    TickRecord record;
    record.time = like[i].time;
    record.wrench = reference[i].defined ? reference[i].wrench
                                         : Wrench{Vector3::Constant(std::numeric_limits<double>::quiet_NaN()),
                                                  Vector3::Constant(std::numeric_limits<double>::quiet_NaN())};
    records.push_back(record);
  }
  return records;
}

std::vector<Curve> curves_of(std::span<const ComparedRun> runs, const Quantity& quantity) {
  std::vector<Curve> curves;
  for (const ComparedRun& run : runs) curves.push_back({run.method, curves.size(), quantity, false});
  curves.push_back({"reference", curves.size(), quantity, true});
  return curves;
}

}  // namespace

void draw_comparison(const Experiment& experiment, std::span<const ComparedRun> runs,
                     std::span<const ReferenceSample> reference, const std::filesystem::path& folder) {
  if (runs.empty()) return;
  Figure figure{.name = experiment.name, .title = experiment.name + ": force and torque of all methods"};
  figure.panels = {{"force along " + experiment.force_axis.name + " [N]",
                    curves_of(runs, force_along(experiment.force_axis.direction))},
                   {"torque about " + experiment.torque_axis.name + " [N m]",
                    curves_of(runs, torque_along(experiment.torque_axis.direction))}};
  const std::vector<TickRecord> right = reference_records(runs.front().records, reference);
  const SessionSettings unused;
  std::vector<RunSamples> samples;
  for (const ComparedRun& run : runs) samples.push_back({run.records, unused});
  samples.push_back({right, unused});
  draw(figure, samples, folder);
}

}  // namespace tegotae
