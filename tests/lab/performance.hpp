// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/experiment.hpp>
#include <tegotae/lab/scene_file.hpp>
#include <tegotae/lab/session.hpp>
#include <tegotae/lab/tolerances.hpp>
#include <tegotae/math/rotation.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace tegotae {

/// An experiment performed in simulated time with `proxy`, and what its reference says at every tick, or at every
/// `stride`th one.
struct Performance {
  SceneGeometry scene;
  SessionSettings settings;
  std::vector<TickRecord> records;
  std::vector<ReferenceSample> reference;  ///< of the records 0, stride, 2 stride, ...
  size_t stride = 1;

  const TickRecord& record_of(size_t sample) const { return records[sample * stride]; }
};

inline Performance perform(const Experiment& experiment, const Reference& reference, size_t stride = 1,
                           size_t variant = 0) {
  auto world = load_mujoco_world(find_scene(experiment.scene), experiment.tool);
  const Tool& tool = world->geometry().tool;
  SettingsRequest request;
  request.method = "proxy";
  Performance result;
  result.stride = stride;
  result.scene = world->geometry();
  result.settings = decide_settings(request.or_else(experiment.variants[variant].settings)
                                        .or_else(experiment.settings)
                                        .or_else(settings_of(world->haptic_settings(), find_scene(experiment.scene))),
                                    tool);
  Trajectory motion = experiment.motion(tool);
  Session session(std::move(world), std::move(motion), result.settings);
  session.run_simulated(
      [&](const TickRecord& record) {
        result.records.push_back(record);
        return true;
      },
      [](double) {});
  std::vector<Pose> X_WT;
  for (size_t i = 0; i < result.records.size(); i += stride) X_WT.push_back(result.records[i].X_WT);
  const double period = static_cast<double>(stride) / result.settings.haptic_rate;
  result.reference = reference({result.scene, X_WT, period, result.settings}, [](double) {});
  return result;
}

/// How far what was displayed was from the reference. Ticks that the reference does not define, and those within three
/// ticks of where it snaps, are left out.
struct Deviation {
  double peak = 0.0;      ///< greatest norm of the reference, N or N m
  double rms = 0.0;       ///< of the difference, N or N m
  double worst = 0.0;     ///< N or N m
  double worst_at = 0.0;  ///< s
  double jump = 0.0;      ///< greatest change from tick to tick beyond the reference's, N or N m
  double jump_at = 0.0;   ///< s
  size_t compared = 0;    ///< ticks
};

struct Comparison {
  Deviation force, torque;
  double ghost = 0.0;  ///< s, longest time with a wrench after the reference has become free
};

namespace detail {

inline std::vector<std::uint8_t> counted_samples(const Performance& done) {
  const std::vector<ReferenceSample>& reference = done.reference;
  std::vector<std::uint8_t> counted(reference.size());
  const size_t near = (3 + done.stride - 1) / done.stride;
  for (size_t i = 0; i < reference.size(); ++i) counted[i] = reference[i].defined ? 1 : 0;
  for (size_t i = 0; i < reference.size(); ++i) {
    if (!reference[i].snaps) continue;
    const size_t end = std::min(reference.size(), i + near + 1);
    for (size_t j = i < near ? 0 : i - near; j < end; ++j) counted[j] = 0;
  }
  return counted;
}

// Between two samples the reference is taken to change evenly.
template <class Displayed, class Right>
Deviation deviation(const Performance& done, Displayed displayed, Right right) {
  Deviation result;
  const std::vector<std::uint8_t> counted = counted_samples(done);
  double squares = 0.0;
  for (size_t i = 0; i < done.reference.size(); ++i) {
    if (counted[i] == 0) continue;
    const double error = (displayed(done.record_of(i)) - right(done.reference[i])).norm();
    squares += error * error;
    if (error > result.worst) result.worst = error, result.worst_at = done.record_of(i).time;
    result.peak = std::max(result.peak, right(done.reference[i]).norm());
    ++result.compared;
    if (i == 0 || counted[i - 1] == 0) continue;
    const double right_change =
        (right(done.reference[i]) - right(done.reference[i - 1])).norm() / static_cast<double>(done.stride);
    for (size_t tick = (i - 1) * done.stride + 1; tick <= i * done.stride; ++tick) {
      const double change = (displayed(done.records[tick]) - displayed(done.records[tick - 1])).norm() - right_change;
      if (change > result.jump) result.jump = change, result.jump_at = done.records[tick].time;
    }
  }
  if (result.compared > 0) result.rms = std::sqrt(squares / static_cast<double>(result.compared));
  return result;
}

}  // namespace detail

inline Comparison compare_with_reference(const Performance& done) {
  Comparison result;
  result.force = detail::deviation(
      done, [](const TickRecord& record) { return Vector3(record.wrench.force); },
      [](const ReferenceSample& sample) { return sample.wrench.force; });
  result.torque = detail::deviation(
      done, [](const TickRecord& record) { return Vector3(record.wrench.torque); },
      [](const ReferenceSample& sample) { return sample.wrench.torque; });
  double free_since = -1.0;
  for (size_t i = 0; i < done.reference.size(); ++i) {
    const TickRecord& record = done.record_of(i);
    if (!done.reference[i].defined || done.reference[i].touches)
      free_since = -1.0;
    else if (free_since < 0.0)
      free_since = record.time;
    const double felt =
        Vector3(record.wrench.force).norm() + Vector3(record.wrench.torque).norm() / done.settings.metric_length;
    if (free_since >= 0.0 && felt > tolerance::kFreeWrench)
      result.ghost = std::max(result.ghost, record.time - free_since);
  }
  return result;
}

/// Greatest change of force (N) and torque (N m) from tick to tick between two times, s.
struct Chatter {
  double force = 0.0, torque = 0.0;
};
inline Chatter chatter_between(const Performance& done, double begin, double end) {
  Chatter result;
  for (size_t i = 1; i < done.records.size(); ++i) {
    const TickRecord &before = done.records[i - 1], &now = done.records[i];
    if (before.time < begin || now.time > end) continue;
    result.force = std::max(result.force, (Vector3(now.wrench.force) - Vector3(before.wrench.force)).norm());
    result.torque = std::max(result.torque, (Vector3(now.wrench.torque) - Vector3(before.wrench.torque)).norm());
  }
  return result;
}

/// The record at a time, s.
inline const TickRecord& at_time(const Performance& done, double time) {
  return done.records.at(static_cast<size_t>(std::lround(time * done.settings.haptic_rate)));
}

}  // namespace tegotae
