// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/experiment.hpp>

#include <string>

namespace tegotae {

/// What the experiments on contact tasks have in common: the body `tool` in `scene`, friction as given, the tool's own
/// gyration length as metric length, one run. Motion, phases, axes, figures and notes are the caller's to set.
Experiment contact_experiment(const std::string& name, const std::string& summary, const std::string& scene,
                              double friction);

/// Position along `way`, and the force and the torque that the experiment reports, over time. Set its axes first.
Figure wrench_over_time(const Experiment& experiment, const std::string& title, const ReportedAxis& way);

}  // namespace tegotae
