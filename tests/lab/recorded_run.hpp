// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/motion.hpp>
#include <tegotae/lab/run_recording.hpp>
#include <tegotae/lab/session.hpp>

#include <gtest/gtest.h>

#include <filesystem>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace tegotae {

/// The table with free boxes, its tool going down onto it for `duration` (s) from 2 s on.
inline std::unique_ptr<Session> table_session(double duration) {
  const std::string scene = std::string(TEGOTAE_SCENES) + "/table.xml";
  auto world = load_mujoco_world(scene, "tool");
  const SessionSettings settings =
      decide_settings(settings_of(world->haptic_settings(), scene), world->geometry().tool);
  const Pose first = world->geometry().tool.X_WT;
  Trajectory motion = sampled(2.0, 2.0 + duration, [&](double time) {
    return Pose{first.p - Vector3(0.0, 0.0, 0.2 * (time - 2.0)), first.q};
  });
  return std::make_unique<Session>(std::move(world), std::move(motion), settings);
}

/// Records that run in simulated time; returns its ticks.
inline std::vector<TickRecord> record_table(const std::filesystem::path& file, double duration) {
  const auto session = table_session(duration);
  RunRecording recording(file, *session, session->notes(), "table.xml", "press");
  std::vector<TickRecord> ticks;
  session->run_simulated(
      [&](const TickRecord& record) {
        recording.write(record);
        ticks.push_back(record);
        return true;
      },
      [](double) {});
  recording.close();
  EXPECT_EQ(recording.error(), "");
  return ticks;
}

}  // namespace tegotae
