// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/compared_experiment.hpp>

#include <tegotae/device/playback_interface.hpp>
#include <tegotae/lab/comparison_figure.hpp>
#include <tegotae/lab/input_error.hpp>
#include <tegotae/lab/scene_file.hpp>
#include <tegotae/lab/session.hpp>
#include <tegotae/lab/tick_troubles.hpp>

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <utility>

namespace tegotae {
namespace {

// Beside the run of a method, for the progress: the solution of a motion with exact geometry takes its time.
constexpr double kReferenceWeight = 20.0;

/// A world loaded anew, as a run moves it, and how the method is run in it.
struct Preparation {
  std::unique_ptr<MujocoWorld> world;
  SessionSettings settings;
};

Preparation prepare(const Experiment& experiment, const std::string& method) {
  const std::filesystem::path scene = find_scene(experiment.scene);
  Preparation prepared{load_mujoco_world(scene, experiment.tool), {}};
  const SettingsRequest wanted =
      compared_settings(experiment, method).or_else(settings_of(prepared.world->haptic_settings(), scene));
  prepared.settings = decide_settings(wanted, prepared.world->geometry().tool);
  return prepared;
}

// Where the hand holds the tool at each tick of `run_simulated`.
std::vector<Pose> poses_of(const Trajectory& motion, double period) {
  PlaybackInterface interface(motion);
  InterfaceState state;
  std::vector<Pose> poses;
  const double duration = motion.end() - motion.start();
  const long ticks = static_cast<long>(std::floor(duration / period * (1.0 + 1e-12))) + 1;
  for (long tick = 0; tick < ticks; ++tick) {
    interface.read(static_cast<double>(tick) * period, state);
    poses.push_back(state.X_WT);
  }
  return poses;
}

}  // namespace

SettingsRequest compared_settings(const Experiment& experiment, const std::string& method) {
  SettingsRequest same, rates;
  same.method = method;
  same.metric_length = 0.0;
  rates.physics_rate = 20.0;
  rates.haptic_rate = 1000.0;
  if (!experiment.variants.empty()) same = same.or_else(experiment.variants.front().settings);
  SettingsRequest wanted = same.or_else(experiment.settings).or_else(rates);
  if (!has_constraint_set(method)) wanted.constraint_set.reset();
  return wanted;
}

ComparedExperiment::ComparedExperiment(const Experiment& experiment, const ComparisonRequest& request,
                                       ExperimentComparison& result)
    : experiment_(experiment),
      request_(request),
      result_(result),
      records_(request.methods.size()),
      left_(request.methods.size() + 1) {
  result_.name = experiment.name;
  result_.summary = experiment.summary;
  result_.rows.resize(request.methods.size());
  for (size_t i = 0; i < request.methods.size(); ++i) result_.rows[i].method = request.methods[i];
}

void ComparedExperiment::add_works(std::vector<Work>& works) {
  works.push_back({kReferenceWeight, [this](const Progress& progress) { compute_reference(progress); },
                   [this](const std::string& why) {
                     reference_failure_ = "the reference failed: " + why;
                     count_down();
                   }});
  for (size_t i = 0; i < result_.rows.size(); ++i) {
    works.push_back({1.0, [this, i](const Progress& progress) { run(i, progress); },
                     [this, i](const std::string& why) {
                       fail(i, why);
                       count_down();
                     }});
  }
}

void ComparedExperiment::compute_reference(const Progress& progress) {
  const Preparation prepared = prepare(experiment_, request_.methods.front());
  const double period = 1.0 / prepared.settings.haptic_rate;
  const SceneGeometry& scene = prepared.world->geometry();
  const std::vector<Pose> poses = poses_of(experiment_.motion(scene.tool), period);
  reference_ = experiment_.reference({scene, poses, period, prepared.settings}, progress);
  progress(1.0);
  count_down();
}

void ComparedExperiment::run(size_t method, const Progress& progress) {
  ComparisonRow& row = result_.rows[method];
  Preparation prepared = prepare(experiment_, row.method);
  row.settings = prepared.settings;
  Trajectory motion = experiment_.motion(prepared.world->geometry().tool);
  Session session(std::move(prepared.world), std::move(motion), row.settings);
  std::vector<TickRecord> records;
  TickTroubles troubles;
  session.run_simulated(
      [&](const TickRecord& record) {
        records.push_back(record);
        troubles.add(record);
        return true;
      },
      progress);
  progress(1.0);
  row.of_run = run_metrics(records, session.world().geometry(), row.settings);
  for (const std::string& trouble : {troubles.sentence(), session.trouble()}) {
    if (!trouble.empty()) row.warnings.push_back(trouble);
  }
  records_[method] = std::move(records);
  count_down();
}

void ComparedExperiment::fail(size_t method, const std::string& why) {
  result_.rows[method].state = RowState::kFailed;
  result_.rows[method].failure = why;
}

void ComparedExperiment::count_down() {
  if (--left_ == 0) finish();
}

void ComparedExperiment::judge(size_t method) {
  ComparisonRow& row = result_.rows[method];
  if (!reference_failure_.empty() && row.state != RowState::kFailed) return fail(method, reference_failure_);
  if (!reference_ || records_[method].empty() || row.state == RowState::kFailed) return;
  try {
    row.against_reference = reference_metrics(records_[method], *reference_);
    row.state = RowState::kDone;
  } catch (const std::exception& error) {
    fail(method, error.what());
  }
}

void ComparedExperiment::draw() {
  std::vector<ComparedRun> runs;
  for (size_t i = 0; i < records_.size(); ++i) {
    if (result_.rows[i].state == RowState::kDone) runs.push_back({result_.rows[i].method, records_[i]});
  }
  if (runs.empty()) return;
  try {
    draw_comparison(experiment_, runs, *reference_, request_.figures);
    result_.figure = experiment_.name;
  } catch (const InputError& error) {
    figure_failure_ = error.what();
  }
}

void ComparedExperiment::finish() {
  if (std::exchange(finished_, true)) return;
  for (size_t i = 0; i < records_.size(); ++i) judge(i);
  const bool is_stopped = request_.stop != nullptr && *request_.stop;
  if (!request_.figures.empty() && !is_stopped) draw();
  records_ = {};
  reference_.reset();
}

}  // namespace tegotae
