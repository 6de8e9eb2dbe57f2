// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/offline_reference.hpp>

#include <tegotae/lab/separated_tool.hpp>
#include <tegotae/render/tolerances.hpp>

#include <algorithm>
#include <cmath>

namespace tegotae {
namespace {

// The tool leaps where it moves this many times the hand's way, and that much more.
constexpr double kLeapRatio = 5.0;
constexpr double kLeap = 10e-6;  // m
constexpr size_t kTicksPerReport = 50;

double skin_at(double stiffness) { return std::min(tolerance::kSkin, tolerance::kSkinForce / stiffness); }

// Follows the hand from `from` to `to` in even steps of at most `hand_step`.
void follow(SeparatedTool& tool, const Pose& from, const Pose& to, double hand_step, ReferenceSample& sample) {
  const double way = tool.way(displacement(from, to, tool.centre()));
  const int steps = std::max(1, static_cast<int>(std::ceil(way / hand_step)));
  for (int step = 1; step <= steps; ++step) {
    const Pose before = tool.pose();
    if (!tool.follow(interpolate(from, to, static_cast<double>(step) / steps))) sample.defined = false;
    const double moved = tool.way(displacement(before, tool.pose(), tool.centre()));
    if (moved > kLeapRatio * way / steps + kLeap) sample.snaps = true;
  }
}

std::vector<ReferenceSample> solve_task(const ReferenceTask& task, const Progress& progress, double hand_step) {
  SeparatedTool tool(task.scene, {.stiffness = task.settings.stiffness,
                                  .metric_length = task.settings.metric_length,
                                  .skin = skin_at(task.settings.stiffness)});
  std::vector<ReferenceSample> samples(task.X_WT.size());
  bool started = false;
  for (size_t tick = 0; tick < samples.size(); ++tick) {
    ReferenceSample& sample = samples[tick];
    if (started) {
      follow(tool, task.X_WT[tick - 1], task.X_WT[tick], hand_step, sample);
    } else {
      sample.defined = started = tool.start(task.X_WT[tick]);
    }
    if (started) {
      sample.wrench = tool.wrench();
      sample.touches = tool.touches();
    }
    if (progress && tick % kTicksPerReport == 0)
      progress(static_cast<double>(tick) / static_cast<double>(samples.size()));
  }
  return samples;
}

}  // namespace

Reference offline_reference(double hand_step) {
  return [hand_step](const ReferenceTask& task, const Progress& progress) {
    return solve_task(task, progress, hand_step);
  };
}

}  // namespace tegotae
