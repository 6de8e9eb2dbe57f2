// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/experiment.hpp>

#include <tegotae/lab/edge_tasks.hpp>
#include <tegotae/lab/friction_tasks.hpp>
#include <tegotae/lab/input_error.hpp>
#include <tegotae/lab/paper_cube.hpp>
#include <tegotae/lab/paper_tools.hpp>
#include <tegotae/lab/thin_plate.hpp>
#include <tegotae/lab/tight_fits.hpp>
#include <tegotae/lab/tilt_sweep.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace tegotae {
namespace {

void tell_of_paper(Experiment& experiment) {
  for (Variant& variant : experiment.variants) {
    if (!variant.paper_summary.empty()) variant.summary += ", " + variant.paper_summary;
  }
  for (Figure& figure : experiment.figures) {
    if (!figure.paper_title.empty()) figure.title += " " + figure.paper_title;
  }
  if (!experiment.notes.empty() && !experiment.paper_notes.empty()) experiment.notes += " ";
  experiment.notes += experiment.paper_notes;
}

// Without a set of constraints the variants that ask for one are the same run.
void drop_constraint_sets(Experiment& experiment) {
  const auto asks = [](const Variant& variant) { return variant.settings.constraint_set.has_value(); };
  std::vector<Variant>& variants = experiment.variants;
  if (!std::all_of(variants.begin(), variants.end(), asks)) return;
  variants.resize(1);
  variants[0].name = "only";
  variants[0].summary = "the method has no choice of constraint set";
  variants[0].settings.constraint_set.reset();
}

void drop_curves(Experiment& experiment) {
  for (Figure& figure : experiment.figures) {
    for (Panel& panel : figure.panels) {
      std::erase_if(panel.curves, [&](const Curve& curve) {
        return curve.is_reference || curve.variant >= experiment.variants.size();
      });
    }
  }
}

}  // namespace

Experiment described_for(const Experiment& experiment, std::string_view method) {
  Experiment described = experiment;
  if (method == "paper") {
    tell_of_paper(described);
    return described;
  }
  drop_constraint_sets(described);
  drop_curves(described);
  for (Figure& figure : described.figures) figure.title += fmt::format(" (method {})", method);
  return described;
}

std::vector<Variant> metric_length_variants() {
  SettingsRequest one_metre, gyration;
  one_metre.metric_length = 1.0;
  gyration.metric_length = 0.0;
  return {{"one-metre", "metric length 1 m", one_metre, "the paper's equations literally"},
          {"gyration", "metric length of the tool's own gyration length", gyration}};
}

std::span<const Experiment> experiments() {
  static const std::vector<Experiment> all = {
      paper_cube_experiment(),
      tool_18_experiment(),
      tool_230_round_experiment(),
      tool_230_flat_experiment(),
      tilt_sweep_experiment(),
      table_edge_experiment(),
      overhang_experiment(),
      knurl_experiment(),
      thin_plate_press_experiment(),
      thin_plate_strike_experiment(),
      slot_narrow_experiment(),
      slot_play_experiment(),
      wedge_experiment(),
      peg_in_hole_experiment(),
      slope_experiment(),
      drag_face_experiment(),
      drag_edge_experiment(),
      drag_vertex_experiment(),
      twist_square_experiment(),
      twist_disc_experiment(),
  };
  return all;
}

const Experiment& find_experiment(std::string_view name) {
  std::string names;
  for (const Experiment& experiment : experiments()) {
    if (experiment.name == name) return experiment;
    names.append(names.empty() ? "" : ", ").append(experiment.name);
  }
  throw InputError(fmt::format("there is no experiment '{}'; there are: {}.", name, names));
}

}  // namespace tegotae
