// SPDX-License-Identifier: Apache-2.0
#include <bench/live/session_report.hpp>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <thread>

namespace tegotae::bench {
namespace {

using Json = nlohmann::ordered_json;

// Nearest rank; of no values 0.
double percentile(std::vector<double> values, double part) {
  if (values.empty()) return 0.0;
  std::sort(values.begin(), values.end());
  const double rank = std::ceil(part * static_cast<double>(values.size()));
  return values[static_cast<std::size_t>(std::max(rank, 1.0)) - 1];
}

Json spread_of(const std::vector<double>& values) {
  return {{"median", percentile(values, 0.5)},
          {"p99", percentile(values, 0.99)},
          {"p99_9", percentile(values, 0.999)},
          {"max", percentile(values, 1.0)}};
}

std::vector<double> joined(const std::vector<RecordedMotion>& motions, std::vector<double> RecordedMotion::*member) {
  std::vector<double> all;
  for (const RecordedMotion& motion : motions) all.insert(all.end(), (motion.*member).begin(), (motion.*member).end());
  return all;
}

// Each block by itself, which tells how much of a difference is chance.
std::vector<double> p99_9_of_blocks(const ConditionFigures& condition, int motions_per_block) {
  std::vector<double> blocks;
  const auto step = static_cast<std::ptrdiff_t>(motions_per_block);
  for (auto first = condition.motions.begin(); condition.motions.end() - first >= step; first += step) {
    blocks.push_back(percentile(joined({first, first + step}, &RecordedMotion::tick_us), 0.999));
  }
  return blocks;
}

Json condition_json(const ConditionFigures& condition, int motions_per_block) {
  const std::vector<double> ticks = joined(condition.motions, &RecordedMotion::tick_us);
  std::uint64_t missed = 0, in_contact = 0;
  for (const RecordedMotion& motion : condition.motions) {
    missed += motion.missed;
    in_contact += motion.in_contact;
  }
  return {{"viewers", condition.viewers},
          {"ticks", ticks.size()},
          {"in_contact", static_cast<double>(in_contact) / static_cast<double>(ticks.size())},
          {"tick_us", spread_of(ticks)},
          {"tick_p99_9_of_blocks_us", p99_9_of_blocks(condition, motions_per_block)},
          {"tick_to_tick_ms", spread_of(joined(condition.motions, &RecordedMotion::gap_ms))},
          {"missed_periods", missed},
          {"physics_rate_Hz", percentile(joined(condition.motions, &RecordedMotion::physics_rate), 0.5)},
          {"program_cores", condition.program_processor_time / condition.seconds}};
}

Json states_json(const SessionFigures& figures) {
  const ViewerFigures& states = figures.states;
  const double viewer_seconds = states.seconds * figures.plan.viewers;
  return {{"age_ms", spread_of(states.ages)},
          {"states", states.ages.size()},
          {"states_per_second_to_a_viewer", static_cast<double>(states.ages.size()) / viewer_seconds},
          {"bytes_per_second_to_a_viewer", static_cast<double>(states.bytes) / viewer_seconds},
          {"states_left_out", states.left_out},
          {"viewers_cores", states.processor_time / states.seconds}};
}

Json figures_json(const SessionFigures& figures) {
  Json json = {{"motion", figures.plan.motion},
               {"blocks", figures.plan.blocks},
               {"motions_per_block", figures.plan.motions},
               {"cores", std::thread::hardware_concurrency()},
               {"load_before", figures.load_before},
               {"real_time_threads", figures.real_time_threads}};
  json["conditions"] = {condition_json(figures.without, figures.plan.motions),
                        condition_json(figures.with, figures.plan.motions)};
  json["tick_p99_9_ratio"] =
      json["conditions"][1]["tick_us"]["p99_9"].get<double>() / json["conditions"][0]["tick_us"]["p99_9"].get<double>();
  json["states"] = states_json(figures);
  return json;
}

std::string spread_line(const Json& spread) {
  return fmt::format("{:>9.2f} {:>9.2f} {:>9.2f} {:>9.2f}", spread["median"].get<double>(), spread["p99"].get<double>(),
                     spread["p99_9"].get<double>(), spread["max"].get<double>());
}

std::string condition_text(const Json& condition) {
  std::string text = fmt::format("{} viewers\n", condition["viewers"].get<int>());
  const auto line = [&text](const char* name, const std::string& value) {
    text += fmt::format("  {:<34} {}\n", name, value);
  };
  line("", fmt::format("{:>9} {:>9} {:>9} {:>9}", "median", "p99", "p99.9", "max"));
  line("tick, us", spread_line(condition["tick_us"]));
  line("from tick to tick, ms", spread_line(condition["tick_to_tick_ms"]));
  std::string blocks;
  for (const Json& block : condition["tick_p99_9_of_blocks_us"])
    blocks += fmt::format("{:>9.2f} ", block.get<double>());
  line("tick p99.9 of each block, us", blocks);
  line("ticks", fmt::format("{:>9}", condition["ticks"].get<std::uint64_t>()));
  line("of them in contact, %", fmt::format("{:>9.1f}", 100.0 * condition["in_contact"].get<double>()));
  line("missed haptic periods", fmt::format("{:>9}", condition["missed_periods"].get<std::uint64_t>()));
  line("physics rate, Hz", fmt::format("{:>9.1f}", condition["physics_rate_Hz"].get<double>()));
  line("processor time of the program, cores", fmt::format("{:>7.2f}", condition["program_cores"].get<double>()));
  return text;
}

}  // namespace

std::string json_of(const SessionFigures& figures) { return figures_json(figures).dump(2); }

std::string text_of(const SessionFigures& figures) {
  const Json json = figures_json(figures);
  std::string text = fmt::format(
      "Motion '{}', {} blocks of {}; {} cores, load before: {:.2f}; threads of the program under SCHED_FIFO: {}\n",
      figures.plan.motion, figures.plan.blocks, figures.plan.motions, json["cores"].get<unsigned>(),
      figures.load_before, figures.real_time_threads);
  for (const Json& condition : json["conditions"]) text += condition_text(condition);
  const Json& states = json["states"];
  text += fmt::format("Ratio of tick p99.9: {:.3f}\n", json["tick_p99_9_ratio"].get<double>());
  text += fmt::format("Age of a state when a viewer has read it, ms (median, p99, p99.9, max): {}\n",
                      spread_line(states["age_ms"]));
  text += fmt::format(
      "To one viewer: {:.1f} states/s, {:.0f} bytes/s; {} of {} states left out. Processor time of all viewers, cores: "
      "{:.2f}\n",
      states["states_per_second_to_a_viewer"].get<double>(), states["bytes_per_second_to_a_viewer"].get<double>(),
      states["states_left_out"].get<std::uint64_t>(),
      states["states"].get<std::uint64_t>() + states["states_left_out"].get<std::uint64_t>(),
      states["viewers_cores"].get<double>());
  return text;
}

}  // namespace tegotae::bench
