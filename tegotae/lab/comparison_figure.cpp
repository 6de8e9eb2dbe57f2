// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/comparison_figure.hpp>

#include <tegotae/lab/quantities.hpp>
#include <tegotae/lab/tolerances.hpp>

#include <algorithm>
#include <limits>

namespace tegotae {
namespace {

const Wrench kUnknown{Vector3::Constant(std::numeric_limits<double>::quiet_NaN()),
                      Vector3::Constant(std::numeric_limits<double>::quiet_NaN())};

// As if a run had displayed it, so that it is drawn as one: the reference, less `factor` times what was rendered.
// Where nothing is known there is a gap.
std::vector<TickRecord> reference_less(std::span<const ReferenceSample> reference, double factor,
                                       std::span<const TickRecord> rendered) {
  std::vector<TickRecord> records;
  for (size_t i = 0; i < rendered.size() && i < reference.size(); ++i) {
    TickRecord record;
    record.time = rendered[i].time;
    record.wrench = reference[i].defined ? reference[i].wrench - Wrench(rendered[i].wrench) * factor : kUnknown;
    records.push_back(record);
  }
  return records;
}

double force_of(const TickRecord& record, const SessionSettings& /*settings*/) {
  return record.wrench.force.vector().norm();
}

double torque_of(const TickRecord& record, const SessionSettings& /*settings*/) {
  return record.wrench.torque.vector().norm();
}

// Below these an error is not worth a look: far below what a hand feels (0.04 N at arms of centimetres).
constexpr double kLeastForceError = 1e-4;   // N
constexpr double kLeastTorqueError = 1e-6;  // N m

// Of the runs, then of the reference if there is any.
std::vector<Curve> rendered_curves(std::span<const ComparedRun> runs, bool is_defined, const Quantity& quantity) {
  std::vector<Curve> curves;
  for (const ComparedRun& run : runs) curves.push_back({run.method, curves.size(), quantity, false});
  if (is_defined) curves.push_back({"reference", runs.size(), quantity, true});
  return curves;
}

std::vector<Curve> error_curves(std::span<const ComparedRun> runs, const Quantity& quantity) {
  std::vector<Curve> curves;
  for (size_t i = 0; i < runs.size(); ++i) curves.push_back({"", runs.size() + 1 + i, quantity, false});
  return curves;
}

// As wide as the reference asks for and half of that on both sides, so that a method that is far off hides no other.
void fit_to_reference(std::span<const ReferenceSample> reference, const Vector3& axis, Vector3 Wrench::*part,
                      Panel& panel) {
  double least = std::numeric_limits<double>::infinity(), greatest = -least;
  for (const ReferenceSample& sample : reference) {
    if (!sample.defined) continue;
    least = std::min(least, axis.dot(sample.wrench.*part));
    greatest = std::max(greatest, axis.dot(sample.wrench.*part));
  }
  const double beyond = 0.5 * (greatest - least);
  if (!(beyond > tolerance::kNoTorque)) return;
  panel.bottom = least - beyond;
  panel.top = greatest + beyond;
}

std::vector<Panel> panels_of(const Experiment& experiment, std::span<const ComparedRun> runs,
                             std::span<const ReferenceSample> reference) {
  const bool is_defined = std::any_of(reference.begin(), reference.end(), [](const auto& r) { return r.defined; });
  const ReportedAxis &force = experiment.force_axis, &torque = experiment.torque_axis;
  Panel forces{"force along " + force.name + " [N]", rendered_curves(runs, is_defined, force_along(force.direction))};
  Panel torques{"torque about " + torque.name + " [N m]",
                rendered_curves(runs, is_defined, torque_along(torque.direction))};
  if (!is_defined) return {forces, torques};
  fit_to_reference(reference, force.direction, &Wrench::force, forces);
  fit_to_reference(reference, torque.direction, &Wrench::torque, torques);
  return {forces,
          {"error of force [N]", error_curves(runs, force_of), kLeastForceError},
          torques,
          {"error of torque [N m]", error_curves(runs, torque_of), kLeastTorqueError}};
}

}  // namespace

void draw_comparison(const Experiment& experiment, std::span<const ComparedRun> runs,
                     std::span<const ReferenceSample> reference, const std::filesystem::path& folder) {
  if (runs.empty()) return;
  Figure figure{.name = experiment.name, .title = experiment.name + ": force and torque of all methods"};
  figure.panels = panels_of(experiment, runs, reference);
  std::vector<std::vector<TickRecord>> derived = {reference_less(reference, 0.0, runs.front().records)};
  for (const ComparedRun& run : runs) derived.push_back(reference_less(reference, 1.0, run.records));
  const SessionSettings unused;
  std::vector<RunSamples> samples;
  for (const ComparedRun& run : runs) samples.push_back({run.records, unused});
  for (const std::vector<TickRecord>& records : derived) samples.push_back({records, unused});
  draw(figure, samples, folder);
}

}  // namespace tegotae
