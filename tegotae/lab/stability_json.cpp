// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/stability_json.hpp>

#include <tegotae/lab/decay_judge.hpp>

#include <nlohmann/json.hpp>

namespace tegotae {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kStabilityFormat = 1;

Json json_of(const SimulatedDevice& device) {
  const GripMechanics& grip = device.mechanics;
  return {{"name", device.capability.name},
          {"mass_kg", grip.mass},
          {"inertia_kg_m2", grip.inertia},
          {"damping_N_s_per_m", grip.damping},
          {"rotational_damping_N_m_s_per_rad", grip.rotational_damping},
          {"friction_force_N", grip.friction_force},
          {"friction_torque_N_m", grip.friction_torque},
          {"encoder_step_m", device.capability.encoder_step},
          {"encoder_step_rad", device.encoder_angle},
          {"delay_s", device.delay},
          {"max_force_N", device.capability.max_force},
          {"max_torque_N_m", device.capability.max_torque}};
}

Json json_of(const HandImpedance& hand, const std::string& name) {
  return {{"name", name},
          {"mass_kg", hand.mass},
          {"inertia_kg_m2", hand.inertia},
          {"damping_N_s_per_m", hand.damping},
          {"rotational_damping_N_m_s_per_rad", hand.rotational_damping},
          {"stiffness_N_per_m", hand.stiffness},
          {"rotational_stiffness_N_m_per_rad", hand.rotational_stiffness}};
}

Json json_of(const StabilityRow& row) {
  const StiffnessBounds& bounds = row.bounds;
  return {{"method", row.method},
          {"contact", row.contact},
          {"metric_length_m", row.metric_length},
          {"largest_stable_stiffness_N_per_m", row.limit.largest_stable},
          {"smallest_unstable_stiffness_N_per_m", row.limit.smallest_unstable},
          {"runs", row.limit.runs},
          {"linear_bound_N_per_m", bounds.linear},
          {"linear_bound_translation_N_per_m", bounds.linear_translation},
          {"linear_bound_rotation_N_per_m", bounds.linear_rotation},
          {"colgate_schenkel_bound_N_per_m", bounds.colgate_schenkel},
          {"abbott_okamura_bound_N_per_m", bounds.abbott_okamura},
          {"ratio_to_linear", row.ratio_to_linear()},
          {"ratio_to_colgate_schenkel", row.limit.largest_stable / bounds.colgate_schenkel},
          {"ratio_to_abbott_okamura", row.limit.largest_stable / bounds.abbott_okamura}};
}

Json json_of(const EnergyRow& row) {
  return {{"method", row.method},
          {"metric_length_m", row.metric_length},
          {"stiffness_N_per_m", row.stiffness},
          {"duration_s", row.duration},
          {"contacts", row.contacts},
          {"time_in_contact_s", row.time_in_contact},
          {"given_J", row.given},
          {"sampled_springs_own_J", row.allowed},
          {"excess_J", row.excess},
          {"worst_contact_J", row.worst_contact},
          {"greatest_force_N", row.greatest_force}};
}

Json criterion() {
  return {{"touch_speed_m_per_s", CubeTouch::kSpeed}, {"judged_for_s", DecayJudge::kDuration},
          {"window_s", DecayJudge::kWindow},          {"shrink", DecayJudge::kShrink},
          {"still_m_per_s", DecayJudge::kStill},      {"relative_width", kStabilityWidth}};
}

}  // namespace

std::string stability_json(const StabilityReport& report) {
  Json limits = Json::array(), energies = Json::array();
  for (const StabilityRow& row : report.limits) limits.push_back(json_of(row));
  for (const EnergyRow& row : report.energies) energies.push_back(json_of(row));
  const Json json = {{"format", kStabilityFormat},
                     {"interrupted", report.interrupted},
                     {"device", json_of(report.setup.device)},
                     {"hand", json_of(report.setup.hand, report.hand)},
                     {"haptic_rate_Hz", report.setup.settings.haptic_rate},
                     {"physics_rate_Hz", report.setup.settings.physics_rate},
                     {"damping_N_s_per_m", report.setup.settings.damping},
                     {"criterion", criterion()},
                     {"largest_stable_stiffness", limits},
                     {"energy_in_random_contact", energies}};
  return json.dump(2) + "\n";
}

}  // namespace tegotae
