// SPDX-License-Identifier: Apache-2.0
#include <apps/commands.hpp>
#include <apps/interruption.hpp>
#include <apps/progress_line.hpp>
#include <apps/settings_options.hpp>
#include <apps/summary_table.hpp>
#include <apps/validators.hpp>
#include <tegotae/lab/experiment_run.hpp>
#include <tegotae/lab/input_error.hpp>

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace tegotae {
namespace {

struct ExperimentOptions {
  std::string name;
  std::string folder, recording;
  bool list = false;
  bool real_time = false;
  std::string interface, hand;
  SettingsOptions settings;
};

void print_list() {
  for (const Experiment& experiment : experiments()) fmt::print("{:<18}{}\n", experiment.name, experiment.summary);
}

const Experiment& chosen_experiment(const std::string& name) {
  try {
    return find_experiment(name);
  } catch (const InputError& error) {
    throw UsageError(error.what());
  }
}

// What would be without effect.
void refuse_without_interface(const ExperimentOptions& options) {
  const SettingsRequest& wanted = options.settings.request;
  const char* option = nullptr;
  if (!options.hand.empty()) option = "--hand";
  if (wanted.energy_bound) option = "--energy-bound";
  if (wanted.beyond_rating) option = "--beyond-rating";
  if (option == nullptr) return;
  throw UsageError(
      fmt::format("{} is of an interface in a hand, and without one the motion is played exactly; add --interface "
                  "NAME, say --interface simulated:parallel.",
                  option));
}

std::optional<InterfaceRequest> chosen_interface(const ExperimentOptions& options) {
  if (options.interface.empty()) {
    refuse_without_interface(options);
    return std::nullopt;
  }
  try {
    return interface_request(options.interface, options.hand.empty() ? "moderate" : options.hand);
  } catch (const InputError& error) {
    throw UsageError(error.what());
  }
}

// So that a run on an interface replaces none without it.
std::filesystem::path default_folder(const Experiment& experiment, const std::optional<InterfaceRequest>& interface) {
  const std::string on = interface ? "-" + file_name_of(interface->choice) : "";
  return std::filesystem::path("out") / (experiment.name + on);
}

ExperimentResult perform(const Experiment& experiment, const ExperimentRequest& request) {
  ProgressLine progress(experiment.name);
  return run_experiment(experiment, request, [&](double part) { progress.show(part); });
}

// A signal ends gnuplot too, which then fails; what counts is the signal.
std::filesystem::path figures_of(const ExperimentResult& result, const std::filesystem::path& folder) {
  try {
    return draw_figures(result, folder);
  } catch (const InputError&) {
    if (!interrupted()) throw;
    throw Interruption(fmt::format("interrupted while drawing; the samples in {} are whole.", folder.string()));
  }
}

void run(const ExperimentOptions& options) {
  if (options.list) return print_list();
  if (options.name.empty()) throw UsageError("name an experiment; 'tegotae experiment --list' shows them.");
  const Experiment& experiment = chosen_experiment(options.name);
  ExperimentRequest request;
  request.settings = options.settings.checked();
  request.interface = chosen_interface(options);
  request.folder = options.folder;
  if (options.folder.empty()) request.folder = default_folder(experiment, request.interface);
  request.recording = options.recording;
  request.real_time = options.real_time;
  request.stop = &interrupted();
  listen_for_interruption();

  const ExperimentResult result = perform(experiment, request);
  for (const std::string& warning : result.warnings) fmt::print(stderr, "tegotae: warning: {}\n", warning);
  fmt::print("{}", summary_table(result));
  if (result.interrupted) {
    throw Interruption(fmt::format("interrupted; what was recorded until then stands in {}, without figures.",
                                   request.folder.string()));
  }
  const std::filesystem::path figures = figures_of(result, request.folder);
  fmt::print("\nfigures: {}\n", figures.string());
}

}  // namespace

void add_experiment_command(CLI::App& program) {
  auto options = std::make_shared<ExperimentOptions>();
  CLI::App* const command =
      program.add_subcommand("experiment", "Perform an experiment: samples, summary and figures.");
  command->add_option("NAME", options->name, "Experiment to perform")->type_name("");
  command->add_flag("--list", options->list, "List the experiments");
  command->add_flag("--realtime", options->real_time,
                    "Run physics and haptics at their rates in real time, each on a thread of its own; without it time "
                    "is simulated and the result repeats bit for bit");
  command
      ->add_option("--out", options->folder,
                   "Folder for the results; default: out/NAME, with --interface out/NAME-INTERFACE")
      ->type_name("DIR")
      ->check(not_empty("a folder"));
  command->add_option("--record", options->recording, "Recording (MCAP) to write of the first variant")
      ->type_name("FILE")
      ->check(not_empty("a file"));
  command
      ->add_option(
          "--interface", options->interface,
          "Simulated interface that displays the wrench to a simulated hand, which means the tool to follow the "
          "motion: " +
              simulated_interface_names() + "; default: none, the motion is played exactly")
      ->type_name("NAME")
      ->check(not_empty("an interface"));
  command
      ->add_option("--hand", options->hand,
                   "Hand that holds the simulated interface: relaxed, moderate or firm; default: moderate; with "
                   "--interface")
      ->type_name("NAME")
      ->check(not_empty("a hand"));
  options->settings.add_method(*command);
  options->settings.add_limits(*command);
  command->callback([options] { run(*options); });
}

}  // namespace tegotae
