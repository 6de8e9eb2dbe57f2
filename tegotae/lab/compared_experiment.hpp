// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/comparison.hpp>
#include <tegotae/lab/works.hpp>

#include <atomic>
#include <optional>
#include <string>
#include <vector>

namespace tegotae {

/// One experiment while it is being compared: a work for the reference and one a method, on any threads; whichever ends
/// last draws the figure and frees the records. All arguments must outlive it.
class ComparedExperiment {
 public:
  ComparedExperiment(const Experiment& experiment, const ComparisonRequest& request, ExperimentComparison& result);

  void add_works(std::vector<Work>& works);

  /// Once no work is under way: holds what was reached to the reference, where that has not been done yet.
  void finish();

  const std::string& figure_failure() const noexcept { return figure_failure_; }

 private:
  void compute_reference(const Progress& progress);
  void run(size_t method, const Progress& progress);
  void fail(size_t method, const std::string& why);
  void count_down();
  void judge(size_t method);
  void draw();

  const Experiment& experiment_;
  const ComparisonRequest& request_;
  ExperimentComparison& result_;
  std::optional<std::vector<ReferenceSample>> reference_;
  std::string reference_failure_, figure_failure_;
  std::vector<std::vector<TickRecord>> records_;  // a run a method, empty where it is not done
  std::atomic<size_t> left_;
  bool finished_ = false;
};

}  // namespace tegotae
