// SPDX-License-Identifier: Apache-2.0
#include <bench/live/recorded_motions.hpp>
#include <tegotae/lab/recording_schemas.hpp>
#include <tegotae/stream/mcap_reader.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>

namespace tegotae::bench {
namespace {

using Json = nlohmann::json;

constexpr double kMargin = 0.25;  // s at either end of a motion

struct Tick {
  double time = 0.0, tick_us = 0.0;  // s, us
  bool in_contact = false;
};

struct State {
  double time = 0.0, physics_rate = 0.0;  // s, Hz
  std::uint64_t missed = 0;
  int viewers = 0;
  bool moves = false;
};

struct Recorded {
  std::vector<Tick> ticks;
  std::vector<State> states;
};

State state_of(const Json& json) {
  const Json& numbers = json.at("numbers");
  const Json& rate = numbers.at("physics_rate");
  return {json.at("t").get<double>(), rate.is_number() ? rate.get<double>() : 0.0,
          numbers.at("missed").get<std::uint64_t>(), json.at("viewers").get<int>(), json.at("motion").is_string()};
}

Recorded read_all(const std::filesystem::path& recording) {
  Recorded all;
  read_mcap(recording, [&](const McapMessage& message) {
    const bool is_tick = message.topic == kTickTopic.topic;
    if (!is_tick && message.topic != kStateTopic.topic) return;
    const Json json = Json::parse(message.data);
    if (!is_tick) return all.states.push_back(state_of(json));
    all.ticks.push_back({json.at("t"), json.at("tick_us"), json.at("active").get<double>() > 0.0});
  });
  return all;
}

RecordedMotion motion_between(const Recorded& all, const State& first, const State& last) {
  RecordedMotion motion;
  motion.viewers = first.viewers;
  motion.begin = first.time + kMargin;
  motion.end = last.time - kMargin;
  const auto is_within = [&motion](double time) { return time >= motion.begin && time < motion.end; };
  double before = -1.0;
  for (const Tick& tick : all.ticks) {
    if (!is_within(tick.time)) continue;
    motion.tick_us.push_back(tick.tick_us);
    motion.in_contact += tick.in_contact ? 1 : 0;
    if (before >= 0.0) motion.gap_ms.push_back(1e3 * (tick.time - before));
    before = tick.time;
  }
  const State* begin = nullptr;
  for (const State& state : all.states) {
    if (!is_within(state.time)) continue;
    if (begin == nullptr) begin = &state;
    motion.missed = state.missed - begin->missed;
    motion.physics_rate.push_back(state.physics_rate);
  }
  return motion;
}

}  // namespace

std::vector<RecordedMotion> recorded_motions(const std::filesystem::path& recording) {
  const Recorded all = read_all(recording);
  std::vector<RecordedMotion> motions;
  for (std::size_t i = 0; i < all.states.size();) {
    const State& first = all.states[i];
    std::size_t next = i + 1;
    const auto goes_on = [&](const State& state) { return state.moves && state.viewers == first.viewers; };
    while (next < all.states.size() && goes_on(all.states[next])) ++next;
    const State& last = all.states[next - 1];
    if (first.moves && last.time - first.time > 3.0 * kMargin) motions.push_back(motion_between(all, first, last));
    i = next;
  }
  return motions;
}

}  // namespace tegotae::bench
