// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/comparison_json.hpp>

#include <nlohmann/json.hpp>

namespace tegotae {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kComparisonFormat = 1;
constexpr double kTickUnit = 1e-6;  // s

const char* name_of(RowState state) {
  if (state == RowState::kDone) return "done";
  return state == RowState::kFailed ? "failed" : "not reached";
}

Json json_of_settings(const SessionSettings& settings) {
  const bool has_set = has_constraint_set(settings.method);
  return {{"stiffness_N_per_m", settings.stiffness},
          {"damping_N_s_per_m", settings.damping},
          {"metric_length_m", settings.metric_length},
          {"constraint_set", has_set ? Json(name_of(settings.constraint_set)) : Json()},
          {"friction", settings.friction ? Json(*settings.friction) : Json()},
          {"physics_rate_Hz", settings.physics_rate},
          {"haptic_rate_Hz", settings.haptic_rate},
          {"margin_m", settings.margin}};
}

// `unit` is part of the keys: "N", "N_m".
void add(const std::string& what, const std::string& unit, const Deviation& deviation, Json& json) {
  json[what + "_peak_of_reference_" + unit] = deviation.peak;
  json[what + "_rmse_" + unit] = deviation.rmse;
  json[what + "_rmse_of_peak"] = deviation.relative_rmse();
  json[what + "_worst_" + unit] = deviation.worst;
  json[what + "_worst_of_peak"] = deviation.relative_worst();
  json[what + "_worst_at_s"] = deviation.worst_time;
  json[what + "_change_per_tick_beyond_reference_" + unit] = deviation.change_beyond;
  json[what + "_greatest_change_per_tick_" + unit] = deviation.greatest_change;
}

Json metrics_of(const ComparisonRow& row) {
  const ReferenceMetrics& held = row.against_reference;
  Json json = {{"ticks", held.ticks},
               {"ticks_with_reference", held.defined},
               {"ticks_judged", held.judged},
               {"ticks_where_reference_snaps", held.snapping},
               {"ticks_not_ok", row.of_run.not_ok}};
  add("force", "N", held.force, json);
  add("torque", "N_m", held.torque, json);
  json["spurious_torque_N_m"] = held.spurious_torque;
  json["ghost_contact_ticks"] = held.ghost_run;
  json["ghost_contact_force_N"] = held.ghost_force;
  json["proxy_penetration_m"] = row.of_run.proxy_penetration;
  json["energy_given_J"] = row.of_run.energy_given;
  json["sampled_springs_own_energy_J"] = row.of_run.energy_own;
  json["energy_injected_J"] = row.of_run.energy_excess;
  return json;
}

Json timing_of(const DurationHistogram& times) {
  return {{"time", "simulated"},
          {"missed_deadlines", 0},
          {"tick_us",
           {{"median", times.median() / kTickUnit},
            {"p99", times.percentile(0.99) / kTickUnit},
            {"p99_9", times.percentile(0.999) / kTickUnit}}}};
}

Json json_of(const ComparisonRow& row) {
  Json json = {{"method", row.method}, {"state", name_of(row.state)}};
  if (row.state == RowState::kFailed) json["failure"] = row.failure;
  if (row.state != RowState::kDone) return json;
  json["settings"] = json_of_settings(row.settings);
  json["metrics"] = metrics_of(row);
  json["warnings"] = row.warnings;
  json["timing"] = timing_of(row.of_run.tick_times);
  return json;
}

Json json_of(const ExperimentComparison& experiment) {
  Json rows = Json::array();
  for (const ComparisonRow& row : experiment.rows) rows.push_back(json_of(row));
  return {{"name", experiment.name},
          {"summary", experiment.summary},
          {"figure", experiment.figure.empty() ? Json() : Json(experiment.figure)},
          {"methods", rows}};
}

Json stability_of(const ComparisonResult& result) {
  StabilityReport report{result.stability_setup, result.stability_hand, {}, {}, result.interrupted};
  Json failures = Json::object();
  for (const StabilityOfMethod& row : result.stability) {
    report.limits.insert(report.limits.end(), row.limits.begin(), row.limits.end());
    if (row.energy) report.energies.push_back(*row.energy);
    if (!row.failure.empty()) failures[row.method] = row.failure;
  }
  Json json = Json::parse(stability_json(report));
  json["failures"] = failures;
  return json;
}

}  // namespace

std::string comparison_json(const ComparisonResult& result) {
  Json experiments = Json::array();
  for (const ExperimentComparison& experiment : result.experiments) experiments.push_back(json_of(experiment));
  const Json json = {{"format", kComparisonFormat},
                     {"interrupted", result.interrupted},
                     {"methods", result.methods},
                     {"experiments", experiments},
                     {"stability", result.stability.empty() ? Json() : stability_of(result)}};
  return json.dump(2) + "\n";
}

}  // namespace tegotae
