// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/experiment.hpp>

#include <string>
#include <vector>

namespace tegotae {

/// Of each variant of an experiment on a simulated interface, along the experiment's axes: force and torque, commanded
/// and displayed, and how far apart they are; the tool's pose, as the hand means it and as it is. Titles end in
/// `where`. Names of files: as those of samples, without a variant's name for the first.
std::vector<Figure> closed_loop_figures(const Experiment& experiment, const std::string& where);

}  // namespace tegotae
