// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/recorded_states.hpp>

#include <tegotae/lab/recording_schemas.hpp>
#include <tegotae/stream/mcap_reader.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace tegotae {

RecordedStates::RecordedStates(const std::filesystem::path& file) : path_(file) {
  double lead = 0.0;  // s, of the time here before the recorded one
  const McapEnd end = read_mcap(file, [&](const McapMessage& message) {
    const Place place{static_cast<double>(message.time) * 1e-9, message.offset,
                      static_cast<std::uint32_t>(message.data.size())};
    if (message.topic == kStateTopic.topic) {
      if (!states_.empty()) lead = std::max(lead, states_.back().time - place.time);
      states_.push_back({place.time + lead, place.offset, place.length});
    }
    if (message.topic == kSceneTopic.topic) scenes_.push_back(place);
    if (message.topic == kSettingsTopic.topic) settings_.push_back(place);
  });
  if (states_.empty() || scenes_.empty()) {
    throw RecordingError(
        fmt::format("{}: the recording holds nothing that a page can show (topics {} and {}): an earlier version or "
                    "another program "
                    "wrote it; render it again with 'tegotae render --trajectory {} --record NEW'.",
                    file.string(), kSceneTopic.topic, kStateTopic.topic, file.string()));
  }
  complete_ = end.complete;
  file_.open(file, std::ios::binary);
}

std::size_t RecordedStates::at(double time) const noexcept {
  const auto later =
      std::upper_bound(states_.begin(), states_.end(), time, [](double t, const Place& p) { return t < p.time; });
  return later == states_.begin() ? 0 : static_cast<std::size_t>(later - states_.begin()) - 1;
}

int RecordedStates::before(const std::vector<Place>& places, std::uint64_t offset) noexcept {
  const auto later = std::upper_bound(places.begin(), places.end(), offset,
                                      [](std::uint64_t o, const Place& place) { return o < place.offset; });
  return static_cast<int>(later - places.begin()) - 1;
}

std::string RecordedStates::message(std::size_t state) { return read(states_[state]); }

std::string RecordedStates::read(const Place& place) {
  std::string text(place.length, '\0');
  file_.clear();
  file_.seekg(static_cast<std::streamoff>(place.offset));
  file_.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (!file_) {
    throw RecordingError(fmt::format("{}: the recording can no longer be read at byte {}; was the file changed?",
                                     path_.string(), place.offset));
  }
  return text;
}

}  // namespace tegotae
