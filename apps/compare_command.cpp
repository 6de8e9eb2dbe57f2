// SPDX-License-Identifier: Apache-2.0
#include <apps/commands.hpp>
#include <apps/interruption.hpp>
#include <apps/progress_line.hpp>
#include <apps/validators.hpp>
#include <tegotae/lab/comparison.hpp>
#include <tegotae/lab/comparison_json.hpp>
#include <tegotae/lab/comparison_markdown.hpp>
#include <tegotae/lab/input_error.hpp>
#include <tegotae/lab/text_file.hpp>
#include <tegotae/render/rendering_method.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <memory>
#include <string>
#include <thread>
#include <vector>

namespace tegotae {
namespace {

struct CompareOptions {
  std::string folder = "out/compare";
  std::vector<std::string> methods, experiments;
  bool no_stability = false, no_figures = false;
  unsigned threads = std::max(1U, std::thread::hardware_concurrency());
};

// Without those that are named before.
std::vector<std::string> distinct(const std::vector<std::string>& names) {
  std::vector<std::string> once;
  for (const std::string& name : names) {
    if (std::find(once.begin(), once.end(), name) == once.end()) once.push_back(name);
  }
  return once;
}

std::vector<std::string> chosen_methods(const CompareOptions& options) {
  std::vector<std::string> names;
  if (options.methods.empty()) {
    for (const MethodName& method : method_names()) names.emplace_back(method.name);
  }
  for (const std::string& name : distinct(options.methods)) {
    SettingsRequest request;
    request.method = name;
    check_ranges(request);
    names.push_back(name);
  }
  return names;
}

std::vector<Experiment> chosen_experiments(const CompareOptions& options) {
  std::vector<Experiment> chosen;
  if (options.experiments.empty()) {
    for (const Experiment& experiment : experiments()) {
      if (experiment.reference) chosen.push_back(experiment);
    }
  }
  for (const std::string& name : distinct(options.experiments)) {
    const Experiment& experiment = find_experiment(name);
    if (!experiment.reference) {
      throw UsageError(fmt::format("the experiment '{}' has no reference to hold methods to; leave it out.", name));
    }
    chosen.push_back(experiment);
  }
  return chosen;
}

ComparisonRequest request_of(const CompareOptions& options) {
  ComparisonRequest request;
  try {
    request.methods = chosen_methods(options);
    request.experiments = chosen_experiments(options);
  } catch (const InputError& error) {
    throw UsageError(error.what());
  }
  request.stability = !options.no_stability;
  if (!options.no_figures) request.figures = std::filesystem::path(options.folder) / "figures";
  request.threads = options.threads;
  request.stop = &interrupted();
  return request;
}

ComparisonResult perform(const ComparisonRequest& request) {
  ProgressLine line("compare");
  return run_comparison(request, [&](double part) { line.show(part); });
}

// So that nothing of an earlier comparison is taken for this one's, whatever becomes of it.
// Of whatever experiments the earlier comparison was.
void remove_earlier_results(const std::filesystem::path& folder) {
  std::error_code ignored;
  for (const char* name : {"comparison.md", "comparison.json"}) std::filesystem::remove(folder / name, ignored);
  for (const Experiment& experiment : experiments()) {
    for (const char* ending : {".svg", ".png", ".gnuplot", ".dat"}) {
      std::filesystem::remove(folder / "figures" / (experiment.name + ending), ignored);
    }
  }
}

void warn_of_failures(const ComparisonResult& result) {
  for (const ExperimentComparison& experiment : result.experiments) {
    for (const ComparisonRow& row : experiment.rows) {
      if (row.failure.empty()) continue;
      fmt::print(stderr, "tegotae: warning: {} on {}: {}\n", row.method, experiment.name, row.failure);
    }
  }
}

void run(const CompareOptions& options) {
  const ComparisonRequest request = request_of(options);
  const std::filesystem::path folder = options.folder;
  make_folder(folder);
  remove_earlier_results(folder);
  listen_for_interruption();
  const ComparisonResult result = perform(request);
  write_text(folder / "comparison.json", comparison_json(result));
  write_text(folder / "comparison.md", comparison_markdown(result));
  fmt::print("{}\n{}", comparison_overview(result), stability_table(result));
  warn_of_failures(result);
  if (result.interrupted) {
    throw Interruption(fmt::format("interrupted; what was done until then stands in {}.", folder.string()));
  }
  fmt::print("\nall metrics: {}\n", (folder / "comparison.md").string());
  if (!result.figure_failure.empty()) throw InputError(result.figure_failure);
}

}  // namespace

void add_compare_command(CLI::App& program) {
  auto options = std::make_shared<CompareOptions>();
  CLI::App* const command = program.add_subcommand(
      "compare",
      "Run every method on every experiment that has a reference, in simulated time, and measure stability: one table "
      "(Markdown and JSON) and a figure an experiment; all but the tick times repeats bit for bit.");
  command->add_option("--out", options->folder, "Folder for the results")
      ->type_name("DIR")
      ->check(not_empty("a folder"))
      ->capture_default_str();
  command->add_option("--method", options->methods, "Only these methods (see 'tegotae methods')")->type_name("NAME");
  command->add_option("--experiment", options->experiments, "Only these (see 'tegotae experiment --list')")
      ->type_name("NAME");
  command->add_flag("--no-stability", options->no_stability, "Leave out the largest stable stiffness");
  command->add_flag("--no-figures", options->no_figures, "Draw no figures");
  command->add_option("--threads", options->threads, "Runs at a time; changes nothing but the tick times")
      ->check(CLI::Range(1, 256))
      ->type_name("N")
      ->capture_default_str();
  command->callback([options] { run(*options); });
}

}  // namespace tegotae
