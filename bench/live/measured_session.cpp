// SPDX-License-Identifier: Apache-2.0
#include <bench/live/measured_session.hpp>
#include <bench/live/served_program.hpp>
#include <tegotae/lab/scripted_motion.hpp>
#include <tegotae/math/types.hpp>

#include <fmt/format.h>

#include <chrono>
#include <cstdlib>
#include <memory>
#include <stdexcept>
#include <thread>

namespace tegotae::bench {
namespace {

constexpr double kAfterMotion = 0.5;  // s, for the last states that tell of it

double load_of_last_minute() {
  double load = 0.0;
  getloadavg(&load, 1);
  return load;
}

// One session: the program, and those that come to look at it.
class Session {
 public:
  explicit Session(SessionFigures& figures)
      : figures_(figures),
        program_({figures.plan.program, "serve", "--port", "0", "--record", figures.plan.recording.string()}),
        motion_seconds_(find_scripted_motion(figures.plan.motion).motion(Vector3::UnitZ()).end()) {}

  void run() {
    play();
    figures_.real_time_threads = program_.real_time_threads();
    for (int block = 0; block < figures_.plan.blocks; ++block) {
      if (block % 2 == 0) {
        play_block(figures_.without, nullptr);
      } else {
        Viewers viewers(program_.port(), figures_.plan.viewers);
        play_block(figures_.with, &viewers);
      }
    }
    program_.stop();
  }

 private:
  void play() {
    play_motion(program_.port(), figures_.plan.motion);
    std::this_thread::sleep_for(std::chrono::duration<double>(motion_seconds_ + kAfterMotion));
  }

  void play_block(ConditionFigures& condition, Viewers* viewers) {
    const auto began = std::chrono::steady_clock::now();
    const double processor_time = program_.processor_time();
    if (viewers != nullptr) viewers->begin_measuring();
    for (int i = 0; i < figures_.plan.motions; ++i) play();
    if (viewers != nullptr) figures_.states.add(viewers->end_measuring());
    condition.program_processor_time += program_.processor_time() - processor_time;
    condition.seconds += std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count();
  }

  SessionFigures& figures_;
  ServedProgram program_;
  double motion_seconds_;
};

// The recording must show the warm-up and then what was planned.
void take_motions(SessionFigures& figures, const std::vector<RecordedMotion>& motions) {
  const SessionPlan& plan = figures.plan;
  const auto per_block = static_cast<std::size_t>(plan.motions);
  const std::size_t planned = 1 + per_block * static_cast<std::size_t>(plan.blocks);
  bool as_planned = motions.size() == planned;
  for (std::size_t i = 1; as_planned && i < planned; ++i) {
    ConditionFigures& condition = ((i - 1) / per_block) % 2 == 0 ? figures.without : figures.with;
    as_planned = motions[i].viewers == condition.viewers && !motions[i].tick_us.empty();
    condition.motions.push_back(motions[i]);
  }
  if (as_planned) return;
  std::string found;
  for (const RecordedMotion& motion : motions) {
    found += fmt::format(" {} viewers from {:.2f} to {:.2f} s;", motion.viewers, motion.begin, motion.end);
  }
  throw std::runtime_error("the recording does not show the motions that were planned:" + found);
}

}  // namespace

SessionFigures measure(const SessionPlan& plan) {
  SessionFigures figures;
  figures.plan = plan;
  figures.with.viewers = plan.viewers;
  figures.load_before = load_of_last_minute();
  Session(figures).run();
  take_motions(figures, recorded_motions(plan.recording));
  std::filesystem::remove(plan.recording);
  return figures;
}

}  // namespace tegotae::bench
