// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/comparison.hpp>

#include <tegotae/lab/compared_experiment.hpp>
#include <tegotae/lab/compared_stability.hpp>
#include <tegotae/lab/works.hpp>

#include <memory>

namespace tegotae {

ComparisonResult run_comparison(const ComparisonRequest& request, const Progress& progress) {
  ComparisonResult result;
  result.methods = request.methods;
  result.experiments.resize(request.experiments.size());
  std::vector<Work> works;
  std::vector<std::unique_ptr<ComparedExperiment>> experiments;
  for (size_t i = 0; i < request.experiments.size(); ++i) {
    experiments.push_back(std::make_unique<ComparedExperiment>(request.experiments[i], request, result.experiments[i]));
    experiments.back()->add_works(works);
  }
  ComparedStability stability(request.methods);
  if (request.stability) stability.add_works(works);

  perform_works(works, request.threads, request.stop, progress);

  result.interrupted = request.stop != nullptr && *request.stop;
  for (const auto& experiment : experiments) {
    experiment->finish();
    if (result.figure_failure.empty()) result.figure_failure = experiment->figure_failure();
  }
  result.stability_setup = stability.setup();
  result.stability_hand = ComparedStability::kHand;
  if (request.stability) result.stability = stability.rows();
  return result;
}

}  // namespace tegotae
