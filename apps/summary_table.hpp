// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/experiment_run.hpp>

#include <string>

namespace tegotae {

/// What an experiment came to, for a terminal: a table a variant, a row a phase, and where the files lie.
std::string summary_table(const ExperimentResult& result);

}  // namespace tegotae
