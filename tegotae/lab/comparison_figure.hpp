// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/experiment.hpp>
#include <tegotae/lab/reference.hpp>
#include <tegotae/runtime/tick_record.hpp>

#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace tegotae {

/// A curve of the figure.
struct ComparedRun {
  std::string method;
  std::span<const TickRecord> records;
};

/// Draws force and torque over time along the experiment's axes, a curve a run and the reference dashed, and below each
/// the magnitude of the whole error, into files named as the experiment. A curve far from the reference is cut off at
/// the edge of its panel. Errors as `draw`.
void draw_comparison(const Experiment& experiment, std::span<const ComparedRun> runs,
                     std::span<const ReferenceSample> reference, const std::filesystem::path& folder);

}  // namespace tegotae
