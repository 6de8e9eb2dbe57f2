// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bench/live/recorded_motions.hpp>
#include <bench/live/viewers.hpp>

#include <filesystem>
#include <string>
#include <vector>

namespace tegotae::bench {

struct SessionPlan {
  std::string program = TEGOTAE_PROGRAM;
  std::filesystem::path recording = std::filesystem::temp_directory_path() / "bench_live.mcap";
  int viewers = 10;
  int blocks = 6;
  int motions = 2;  ///< a block
  std::string motion = "circle";
};

/// All blocks of one kind.
struct ConditionFigures {
  int viewers = 0;
  std::vector<RecordedMotion> motions;
  double program_processor_time = 0.0;  ///< s
  double seconds = 0.0;                 ///< in which that was taken
};

struct SessionFigures {
  SessionPlan plan;
  double load_before = 0.0;   ///< of the machine, mean of a minute, before the first block
  int real_time_threads = 0;  ///< of the program: haptics and physics, where the system grants it
  ConditionFigures without, with;
  ViewerFigures states;
};

/// Runs a session as planned. A first motion warms up and is not counted. Throws std::exception where the program
/// cannot be measured, or its recording does not show the planned motions.
SessionFigures measure(const SessionPlan& plan);

}  // namespace tegotae::bench
