// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/trajectory.hpp>
#include <tegotae/lab/figure.hpp>
#include <tegotae/lab/reference.hpp>
#include <tegotae/lab/session_settings.hpp>
#include <tegotae/model/scene_geometry.hpp>

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace tegotae {

/// A part of an experiment that is summarised by itself.
struct Phase {
  std::string name;
  std::string summary;
  double begin = 0.0, end = 0.0;  ///< s; the end belongs to the next phase, but for the last
};

/// A direction along which the summary reports force or torque.
struct ReportedAxis {
  std::string name;  ///< "y"
  Vector3 direction = Vector3::UnitZ();
};

/// One of the runs that an experiment compares.
struct Variant {
  std::string name;
  std::string summary;
  SettingsRequest settings;        ///< these win over the experiment's
  std::string paper_summary = {};  ///< added to the summary where the method is the paper's
};

/// The two metric lengths between which the experiments of the paper are compared: 1 m, then the tool's own gyration
/// length.
std::vector<Variant> metric_length_variants();

/// In titles and labels of an experiment's figures: the metric length of the run that the curve (of a title: the first
/// curve) is drawn from, as "1 m" or "gyration length"; on an interface as it was held to.
inline constexpr std::string_view kMetricLengthText = "<metric length>";

/// A motion of a tool in a scene, and what to look at. Adding one: a file with a function that returns it, and a line
/// in experiment.cpp.
struct Experiment {
  std::string name;
  std::string summary;  ///< one line, for the list
  std::string scene;    ///< file among the scenes
  std::string tool;     ///< body in the scene
  std::function<Trajectory(const Tool&)> motion;
  std::vector<Phase> phases;
  SettingsRequest settings;       ///< beyond what the scene says; these win over it
  std::vector<Variant> variants;  ///< at least one; the first is written to samples.csv
  ReportedAxis force_axis, torque_axis;
  std::vector<Figure> figures;
  Reference reference;           ///< what methods are held to; none: not set
  std::string notes;             ///< what ought to be felt, a few sentences
  std::string paper_notes = {};  ///< what to look at with the paper's method: added to the notes where it is that
};

/// The experiment as it is performed and described with the method called `method`. For `paper`: titles and summaries
/// with what they say of the paper. For any other: without that, and without the curves of reference, which hold for
/// the paper's method alone; variants that differ in the set of constraints become one.
Experiment described_for(const Experiment& experiment, std::string_view method);

/// All experiments, in the order of the list.
std::span<const Experiment> experiments();

/// Throws InputError, with the names, where there is none called `name`.
const Experiment& find_experiment(std::string_view name);

}  // namespace tegotae
