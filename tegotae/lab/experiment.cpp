// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/experiment.hpp>
#include <tegotae/lab/input_error.hpp>
#include <tegotae/lab/paper_cube.hpp>
#include <tegotae/lab/paper_tools.hpp>
#include <tegotae/lab/tilt_sweep.hpp>

#include <fmt/format.h>

namespace tegotae {

std::vector<Variant> metric_length_variants() {
  SettingsRequest one_metre, gyration;
  one_metre.metric_length = 1.0;
  gyration.metric_length = 0.0;
  return {{"one-metre", "metric length 1 m, the paper's equations literally", one_metre},
          {"gyration", "metric length of the tool's own gyration length", gyration}};
}

std::span<const Experiment> experiments() {
  static const std::vector<Experiment> all = {
      paper_cube_experiment(),    tool_18_experiment(),    tool_230_round_experiment(),
      tool_230_flat_experiment(), tilt_sweep_experiment(),
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
