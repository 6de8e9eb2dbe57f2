// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/experiment_run.hpp>

#include <string>

namespace tegotae {

/// The summary of an experiment as JSON: experiment, then by variant its settings, phases and counts; keys carry their
/// units. All that does not repeat from run to run stands under the key "timing" of each variant.
std::string summary_json(const ExperimentResult& result);

}  // namespace tegotae
