// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/experiment.hpp>
#include <tegotae/lab/reference_metrics.hpp>
#include <tegotae/lab/scene_file.hpp>
#include <tegotae/lab/session.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace tegotae {

/// An experiment performed in simulated time with `proxy`, and what its reference says of each tick.
struct Performance {
  SceneGeometry scene;
  SessionSettings settings;
  std::vector<TickRecord> records;
  std::vector<ReferenceSample> reference;
  ReferenceMetrics metrics;
};

inline Performance perform(const Experiment& experiment, size_t variant = 0) {
  auto world = load_mujoco_world(find_scene(experiment.scene), experiment.tool);
  const Tool& tool = world->geometry().tool;
  SettingsRequest request;
  request.method = "proxy";
  Performance result;
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
  for (const TickRecord& record : result.records) X_WT.push_back(record.X_WT);
  const double period = 1.0 / result.settings.haptic_rate;
  result.reference = experiment.reference({result.scene, X_WT, period, result.settings}, [](double) {});
  result.metrics = reference_metrics(result.records, result.reference);
  return result;
}

/// What `proxy` must show in every static experiment: RMSE of force and torque within 1 % and the worst error within
/// 5 % of the peak, no change from tick to tick beyond the reference's that is felt, no ghost. A torque whose peak is
/// less than `least_torque` (N m) is held to parts of that.
inline void expect_kept_to_reference(const Performance& done, double least_torque, double torque_rmse = 0.01) {
  const ReferenceMetrics& metrics = done.metrics;
  EXPECT_GT(metrics.judged, 0.6 * static_cast<double>(done.records.size()));
  EXPECT_LE(metrics.snapping, 10);
  EXPECT_LE(metrics.force.rmse, 0.01 * metrics.force.peak);
  EXPECT_LE(metrics.force.worst, 0.05 * metrics.force.peak) << "at " << metrics.force.worst_time;
  const double torque = std::max(metrics.torque.peak, least_torque);
  EXPECT_LE(metrics.torque.rmse, torque_rmse * torque);
  EXPECT_LE(metrics.torque.worst, 0.05 * torque) << "at " << metrics.torque.worst_time;
  EXPECT_LE(metrics.force.change_beyond, 0.04);
  EXPECT_LE(metrics.torque.change_beyond, 2e-3);
  EXPECT_LE(metrics.ghost_run, 2);
  for (const TickRecord& record : done.records) {
    ASSERT_EQ(record.status, static_cast<std::uint8_t>(RenderStatus::kOk)) << record.time;
  }
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
