// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/experiment.hpp>
#include <tegotae/lab/reference_metrics.hpp>
#include <tegotae/lab/run_metrics.hpp>
#include <tegotae/lab/stability_json.hpp>

#include <atomic>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace tegotae {

/// Which methods are to be compared, and on what.
struct ComparisonRequest {
  std::vector<std::string> methods;         ///< names; at least one
  std::vector<Experiment> experiments;      ///< each with a reference
  bool stability = true;                    ///< whether the largest stable stiffness is searched for
  std::filesystem::path figures;            ///< folder for them; empty: none is drawn
  unsigned threads = 1;                     ///< on which the runs are shared out; changes tick times alone
  const std::atomic<bool>* stop = nullptr;  ///< ends the comparison early where it becomes true
};

enum class RowState : std::uint8_t {
  kNotReached,  ///< the comparison was ended before
  kDone,
  kFailed,
};

/// One method on one experiment.
struct ComparisonRow {
  std::string method;
  RowState state = RowState::kNotReached;
  std::string failure;  ///< why, where it failed
  SessionSettings settings;
  ReferenceMetrics against_reference;
  RunMetrics of_run;
  std::vector<std::string> warnings;  ///< what went wrong without ending the run, a sentence each
};

struct ExperimentComparison {
  std::string name, summary;
  std::vector<ComparisonRow> rows;  ///< in the order of the request's methods
  std::string figure;               ///< name of its figure's files; empty: not drawn
};

/// Stability of one method in closed loop: `tegotae stability` with the cube's gyration length.
struct StabilityOfMethod {
  std::string method;
  std::vector<StabilityRow> limits;  ///< at the features of touched_features() that were reached
  std::optional<EnergyRow> energy;
  std::string failure;
};

struct ComparisonResult {
  std::vector<std::string> methods;
  std::vector<ExperimentComparison> experiments;
  StabilitySetup stability_setup;
  std::string stability_hand;
  std::vector<StabilityOfMethod> stability;  ///< a row a method; empty: not asked for
  std::string figure_failure;                ///< why a figure could not be drawn; empty: none failed
  bool interrupted = false;
};

/// What an experiment is compared with: its own settings and those of its first variant, the tool's gyration length as
/// the metric length of all methods, and physics at 20 Hz and haptics at 1 kHz where the experiment does not say
/// otherwise (a scene's rates do not count). A set of constraints goes to methods that have the choice only.
SettingsRequest compared_settings(const Experiment& experiment, const std::string& method);

/// Runs every method on every experiment in simulated time, holds it to the experiment's reference, which is computed
/// once, and measures stability; draws a figure an experiment. All but the tick times repeats bit for bit, whatever the
/// number of threads. What fails is told in its row and hinders nothing else.
ComparisonResult run_comparison(const ComparisonRequest& request, const Progress& progress);

}  // namespace tegotae
