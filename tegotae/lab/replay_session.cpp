// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/replay_session.hpp>

#include <tegotae/stream/mcap_reader.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <variant>

namespace tegotae {
namespace {

using Json = nlohmann::ordered_json;

Json parsed(const std::string& text, const std::string& file) {
  Json json = Json::parse(text, nullptr, false);
  if (json.is_object()) return json;
  throw RecordingError(fmt::format("{}: a message for the page is no JSON object; the file is damaged.", file));
}

double to_microseconds(double seconds) { return std::round(seconds * 1e6) / 1e6; }

// The times of the ticks' wrenches, `earlier` (s) by as much as the state's own.
void shift_samples(Json& state, double earlier) {
  const auto samples = state.find("samples");
  if (samples == state.end() || !samples->is_array()) return;
  for (Json& sample : *samples) {
    if (!sample.is_array() || sample.empty() || !sample[0].is_number()) continue;
    sample[0] = to_microseconds(sample[0].get<double>() - earlier);
  }
}

std::string dumped(const Json& json) { return json.dump(-1, ' ', false, Json::error_handler_t::replace); }

}  // namespace

ReplaySession::ReplaySession(const std::filesystem::path& file) : file_(file.string()), states_(file) {}

std::string ReplaySession::scene_message() {
  // A state that stands before the first scene has that one.
  Json scene = parsed(states_.scene(std::max(scene_number(), 0)), file_);
  scene["mode"] = "replay";
  scene["duration"] = to_microseconds(duration());
  scene["start"] = to_microseconds(states_.start());
  return dumped(scene);
}

std::string ReplaySession::settings_message() {
  return settings_number() < 0 ? std::string() : states_.settings(settings_number());
}

std::string ReplaySession::obey(const ViewerCommand& command) {
  const auto is = [&command](auto kind) { return std::holds_alternative<decltype(kind)>(command); };
  const auto* play = std::get_if<viewer_command::Play>(&command);
  if (play != nullptr || is(viewer_command::Resume{})) {
    if (play != nullptr) speed_ = play->speed;
    if (time_ >= duration()) time_ = 0.0;
    paused_ = false;
  } else if (const auto* seek = std::get_if<viewer_command::Seek>(&command)) {
    time_ = std::clamp(seek->time, 0.0, duration());
  } else if (is(viewer_command::Pause{})) {
    paused_ = true;
  } else if (is(viewer_command::Reset{})) {
    time_ = 0.0;
  } else {
    return "This is a recording: it can be played, paused and gone through, and nothing else.";
  }
  return {};
}

void ReplaySession::advance(double elapsed) noexcept {
  if (paused_ || !(elapsed > 0.0)) return;
  time_ = std::min(time_ + elapsed * speed_, duration());
  if (time_ >= duration()) paused_ = true;
}

std::string ReplaySession::state_message(int viewers, double made_ms) {
  const std::size_t now = state();
  Json shown = parsed(states_.message(now), file_);
  const double time = states_.time_of(now) - states_.start();
  const auto recorded = shown.find("t");
  if (recorded != shown.end() && recorded->is_number()) shift_samples(shown, recorded->get<double>() - time);
  shown["n"] = ++sent_;
  shown["t"] = to_microseconds(time);
  shown["made"] = std::round(made_ms * 10.0) / 10.0;
  shown["paused"] = paused_;
  shown["recording"] = false;
  shown.erase("recording_file");
  shown.erase("recording_ticks");
  shown["hand"] = nullptr;
  shown["viewers"] = viewers;
  return dumped(shown);
}

}  // namespace tegotae
