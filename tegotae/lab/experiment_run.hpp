// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/display_summary.hpp>
#include <tegotae/lab/experiment.hpp>
#include <tegotae/lab/experiment_interface.hpp>
#include <tegotae/lab/session.hpp>
#include <tegotae/lab/summary.hpp>

#include <atomic>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tegotae {

/// How an experiment is to be performed.
struct ExperimentRequest {
  std::filesystem::path folder;          ///< for the results; made where it is not there
  std::filesystem::path recording = {};  ///< of the first variant; empty: none
  SettingsRequest settings;              ///< these win over the experiment's and its variants'
  bool real_time = false;
  std::optional<InterfaceRequest> interface = {};  ///< not set: the motion is played exactly, whatever is displayed
  const std::atomic<bool>* stop = nullptr;         ///< ends the run and the experiment where it becomes true
};

/// One run of an experiment, done.
struct VariantResult {
  Variant variant;
  SessionSettings settings;
  std::vector<TickRecord> records;
  RunSummary summary;
  std::filesystem::path samples_file;
  std::optional<RealtimeReport> real_time;     ///< not set: time was simulated
  std::string physics_rate_choice = {};        ///< why physics ran at its rate, where that was measured
  std::optional<DisplaySummary> display = {};  ///< of a run on an interface
  std::string metric_length = {};              ///< as figures name it: "1 m", "gyration length"
};

struct ExperimentResult {
  Experiment experiment;  ///< as it was performed, described for the method
  std::vector<VariantResult> variants;
  std::vector<std::string> warnings;  ///< of the scene and of the runs, a sentence each
  std::filesystem::path summary_file;
  std::optional<InterfaceRequest> interface = {};  ///< that it was performed on
  bool interrupted = false;  ///< by `stop`: the last variant there is ended early, those after it were not begun
};

/// Performs all variants, in simulated time or in real time, and writes samples.csv (first variant), samples-NAME.csv
/// (others) and summary.json into the folder, from which such files and figures of an earlier run are removed first. In
/// real time, a physics rate that nobody set is measured. On an interface, the settings are held to what it is rated
/// for in its hand, which is a warning; figures of it are added. Throws InputError, SceneError.
ExperimentResult run_experiment(const Experiment& experiment, const ExperimentRequest& request,
                                const Progress& progress);

/// Draws the figures of a whole result; returns the folder that holds them. Throws InputError.
std::filesystem::path draw_figures(const ExperimentResult& result, const std::filesystem::path& folder);

}  // namespace tegotae
