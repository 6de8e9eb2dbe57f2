// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/run_recording.hpp>

#include <tegotae/lab/session_messages.hpp>

#include <cmath>
#include <cstdint>
#include <utility>

namespace tegotae {
namespace {

constexpr double kStateRate = 60.0;           // Hz, of the run's time
constexpr std::uint64_t kHistogramEach = 30;  // states: twice a second

std::string scene_of(const Session& session, const std::string& name) {
  SceneNames names = session_names(name, session.settings());
  names.interface = session.is_closed_loop() ? session.interface_name() : "recorded motion";
  return encode_scene(session.world().geometry(), names);
}

}  // namespace

RunRecording::RunRecording(const std::filesystem::path& file, Session& session, const std::vector<std::string>& notes,
                           const std::string& scene, std::string motion)
    : file_(file, notes, session.start(), session.sample_kind()),
      session_(session),
      frames_(session.settings(), session.tool().mass.centre_of_mass),
      motion_(std::move(motion)) {
  file_.write_scene(session.start(), scene_of(session, scene));
  file_.write_settings(session.start(), encode_settings(session.settings().method, shown_settings(session.settings())));
}

void RunRecording::write(const TickRecord& record) {
  constexpr double kRounding = 1e-6;  // of a state's period; sums of periods are not exact
  file_.write(record);
  frames_.add(record);
  time_ = record.time;
  is_current_ = false;
  const double states = std::floor(record.time * kStateRate + kRounding);
  if (states < next_state_) return;
  next_state_ = states + 1.0;
  write_state();
}

// Frames count time from the start of the run, recordings as the motion does.
void RunRecording::write_state() {
  ViewFrame frame = frames_.frame(session_.contacts(), session_.bodies());
  frame.time += session_.start();
  for (ViewedSample& sample : frame.samples) sample.time += session_.start();
  if (frame.n % kHistogramEach == 1) frame.histogram = frames_.histogram();
  if (!motion_.empty()) frame.motion = motion_;
  file_.write_state(session_.start() + time_, encode(frame));
  is_current_ = true;
}

void RunRecording::close() {
  if (!is_current_) write_state();
  file_.close();
}

}  // namespace tegotae
