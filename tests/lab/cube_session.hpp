// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/axes.hpp>
#include <tegotae/lab/motion.hpp>
#include <tegotae/lab/session.hpp>
#include <tegotae/math/rotation.hpp>

#include <functional>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace tegotae {

inline constexpr double kHalfEdge = 0.1;  // m, of the cube in scenes/paper-cube.xml
inline constexpr double kStiffness = 9000.0;

/// What the whole pipeline displays, with the paper's method, as its cube plays `motion` over the floor.
inline std::vector<TickRecord> play_cube(Trajectory motion, SettingsRequest request) {
  request.method = "paper";
  const char* const scene = TEGOTAE_SCENES "/paper-cube.xml";
  auto world = load_mujoco_world(scene, "tool");
  const SessionSettings settings =
      decide_settings(request.or_else(settings_of(world->haptic_settings(), scene)), world->geometry().tool);
  Session session(std::move(world), std::move(motion), settings);
  std::vector<TickRecord> records;
  session.run_simulated(
      [&](const TickRecord& record) {
        records.push_back(record);
        return true;
      },
      [](double) {});
  return records;
}

/// Poses of the cube turned about z, sampled at 1 kHz: `height` (m) and `angle` (rad) at a time.
inline Trajectory cube_motion(double duration, const std::function<double(double)>& height,
                              const std::function<double(double)>& angle) {
  return sampled(0.0, duration, [&](double time) {
    return Pose{{0.0, height(time), 0.0}, rotation_from_vector(angle(time) * Vector3::UnitZ())};
  });
}

inline SettingsRequest with_metric_length(double metric_length) {
  SettingsRequest request;
  request.metric_length = metric_length;
  return request;
}

/// A turn about z, rad.
inline double angle_of(const TickRecord& record) { return 2.0 * std::atan2(record.X_WT.z, record.X_WT.w); }

}  // namespace tegotae
