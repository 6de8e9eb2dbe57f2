// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/summary_json.hpp>

#include <nlohmann/json.hpp>

namespace tegotae {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kSummaryVersion = 1;

Json json_of(const Spread& spread) { return {{"min", spread.min}, {"max", spread.max}, {"mean", spread.mean}}; }

Json json_of(const SessionSettings& settings) {
  const bool has_set = has_constraint_set(settings.method);
  return {{"method", settings.method},
          {"stiffness_N_per_m", settings.stiffness},
          {"damping_N_s_per_m", settings.damping},
          {"metric_length_m", settings.metric_length},
          {"constraint_set", has_set ? Json(name_of(settings.constraint_set)) : Json()},
          {"physics_rate_Hz", settings.physics_rate},
          {"haptic_rate_Hz", settings.haptic_rate},
          {"margin_m", settings.margin}};
}

Json json_of(const PhaseSummary& summary) {
  return {{"name", summary.phase.name},
          {"summary", summary.phase.summary},
          {"begin_s", summary.phase.begin},
          {"end_s", summary.phase.end},
          {"ticks", summary.ticks},
          {"reported_force_N", json_of(summary.reported_force)},
          {"reported_torque_N_m", json_of(summary.reported_torque)},
          {"reported_force_at_end_N", summary.force_at_end},
          {"reported_torque_at_end_N_m", summary.torque_at_end},
          {"force_N",
           {{"x", json_of(summary.force[0])},
            {"y", json_of(summary.force[1])},
            {"z", json_of(summary.force[2])},
            {"norm", json_of(summary.force_norm)}}},
          {"torque_N_m",
           {{"x", json_of(summary.torque[0])},
            {"y", json_of(summary.torque[1])},
            {"z", json_of(summary.torque[2])},
            {"norm", json_of(summary.torque_norm)}}},
          {"contacts", json_of(summary.contacts)},
          {"deepest_m", json_of(summary.deepest)},
          {"greatest_force_step_N", summary.greatest_force_step},
          {"greatest_torque_step_N_m", summary.greatest_torque_step}};
}

Json json_of(const DurationHistogram& durations, double unit) {
  return {{"median", durations.median() / unit},
          {"p99", durations.percentile(0.99) / unit},
          {"p99_9", durations.percentile(0.999) / unit},
          {"max", durations.max() / unit}};
}

constexpr double kMicrosecond = 1e-6, kMillisecond = 1e-3;  // s

Json json_of(const RealtimeRights& rights) {
  return {{"fifo", rights.fifo}, {"memory_locked", rights.memory_locked}, {"explanation", rights.explanation}};
}

void add_real_time(const RealtimeReport& report, Json& timing) {
  timing["time"] = "real";
  timing["missed_deadlines"] = report.haptics.missed_deadlines;
  timing["wake_up_us"] = json_of(report.wake_up, kMicrosecond);
  timing["model_age_ms"] = json_of(report.haptics.staleness, kMillisecond);
  timing["physics_step_us"] = json_of(report.physics.durations, kMicrosecond);
  timing["physics_missed_deadlines"] = report.physics.missed_deadlines;
  timing["dropped_records"] = report.dropped_records;
  timing["haptic_rights"] = json_of(report.haptic_rights);
  timing["physics_rights"] = json_of(report.physics_rights);
}

Json timing_of(const VariantResult& result) {
  const RunSummary& summary = result.summary;
  Json phases = Json::object();
  for (const PhaseSummary& phase : summary.phases) phases[phase.phase.name] = json_of(phase.tick_times, kMicrosecond);
  Json timing = {{"time", "simulated"},
                 {"missed_deadlines", nullptr},
                 {"tick_us", json_of(summary.haptics.durations, kMicrosecond)},
                 {"tick_us_of_phases", phases}};
  if (result.real_time) add_real_time(*result.real_time, timing);
  if (!result.physics_rate_choice.empty()) timing["physics_rate_choice"] = result.physics_rate_choice;
  return timing;
}

Json json_of(const DisplayErrors& errors) {
  return {{"ticks", errors.ticks},
          {"force_rms_N", errors.force_rms},
          {"force_max_N", errors.force_max},
          {"torque_rms_N_m", errors.torque_rms},
          {"torque_max_N_m", errors.torque_max}};
}

Json json_of(const DisplaySummary& display) {
  return {{"displayed_less_commanded", json_of(display.all)},
          {"displayed_less_commanded_where_reachable", json_of(display.reachable)},
          {"shortfall_ticks", display.shortfalls},
          {"greatest_commanded_force_N", display.greatest_force},
          {"greatest_commanded_torque_N_m", display.greatest_torque},
          {"greatest_way_from_hand_m", display.hand_way},
          {"greatest_angle_from_hand_rad", display.hand_angle}};
}

Json json_of(const VariantResult& result) {
  Json phases = Json::array();
  for (const PhaseSummary& phase : result.summary.phases) phases.push_back(json_of(phase));
  Json variant = {{"name", result.variant.name},
                  {"summary", result.variant.summary},
                  {"samples", result.samples_file.filename().string()},
                  {"settings", json_of(result.settings)},
                  {"phases", phases},
                  {"statuses", result.summary.statuses},
                  {"safety_events", result.summary.safety_events},
                  {"dropped_planes_and_points", result.summary.dropped},
                  {"model_age_ms", json_of(result.summary.haptics.staleness, kMillisecond)},
                  {"timing", timing_of(result)}};
  if (result.display) variant["display"] = json_of(*result.display);
  return variant;
}

}  // namespace

std::string summary_json(const ExperimentResult& result) {
  const Experiment& experiment = result.experiment;
  Json variants = Json::array();
  for (const VariantResult& variant : result.variants) variants.push_back(json_of(variant));
  Json summary = {{"format", kSummaryVersion},
                  {"experiment", experiment.name},
                  {"summary", experiment.summary},
                  {"notes", experiment.notes},
                  {"reported_force_axis", experiment.force_axis.name},
                  {"reported_torque_axis", experiment.torque_axis.name},
                  {"warnings", result.warnings},
                  {"interrupted", result.interrupted},
                  {"variants", variants}};
  if (result.interface) {
    summary["interface"] = {{"name", result.interface->choice.name}, {"hand", result.interface->hand_name}};
  }
  return summary.dump(2) + "\n";
}

}  // namespace tegotae
