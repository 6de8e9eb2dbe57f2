// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/experiment.hpp>
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
  std::filesystem::path folder;  ///< for the results; made where it is not there
  SettingsRequest settings;      ///< these win over the experiment's and its variants'
  bool real_time = false;
  const std::atomic<bool>* stop = nullptr;  ///< in real time: ends the experiment where it becomes true
};

/// One run of an experiment, done.
struct VariantResult {
  Variant variant;
  SessionSettings settings;
  std::vector<TickRecord> records;
  RunSummary summary;
  std::filesystem::path samples_file;
  std::optional<RealtimeReport> real_time;  ///< not set: time was simulated
};

struct ExperimentResult {
  std::vector<VariantResult> variants;
  std::vector<std::string> warnings;  ///< of the scene and of the runs, a sentence each
  std::filesystem::path summary_file;
};

/// Performs all variants, in simulated time or in real time, and writes samples.csv (first variant), samples-NAME.csv
/// (others) and summary.json into the folder. Throws InputError, SceneError.
ExperimentResult run_experiment(const Experiment& experiment, const ExperimentRequest& request,
                                const Progress& progress);

/// Draws the experiment's figures from the result; returns the folder that holds them. Throws InputError.
std::filesystem::path draw_figures(const Experiment& experiment, const ExperimentResult& result,
                                   const std::filesystem::path& folder);

}  // namespace tegotae
