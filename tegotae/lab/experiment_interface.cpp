// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/experiment_interface.hpp>

#include <tegotae/device/simulated_presets.hpp>
#include <tegotae/lab/hand_effort.hpp>
#include <tegotae/lab/input_error.hpp>
#include <tegotae/lab/session.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace tegotae {
namespace {

void add_lowered(std::string& text, const char* name, double wanted, double held, const char* unit) {
  if (held == wanted) return;
  text += fmt::format("{}{} {:g} {} instead of {:g}", text.empty() ? "" : ", ", name, held, unit, wanted);
}

// To a millionth, without negative zeros.
std::string pose_text(const Pose& X) {
  const auto rounded = [](double value) { return std::round(value * 1e6) / 1e6 + 0.0; };
  return fmt::format("{:g} {:g} {:g} m, quaternion {:g} {:g} {:g} {:g}", rounded(X.p.x()), rounded(X.p.y()),
                     rounded(X.p.z()), rounded(X.q.w()), rounded(X.q.x()), rounded(X.q.y()), rounded(X.q.z()));
}

}  // namespace

InterfaceRequest interface_request(std::string_view interface, std::string_view hand) {
  InterfaceRequest request{find_simulated(parse_interface_name(interface)), std::string(hand), {}};
  try {
    request.hand = simulated_hand(hand);
  } catch (const std::invalid_argument& error) {
    throw InputError(error.what());
  }
  return request;
}

SessionSettings held_in_hand(const SessionSettings& settings, const InterfaceRequest& request, std::string& warning) {
  const InterfaceCapability rating = capability_in_hand(request.choice, request.hand, 1.0 / settings.haptic_rate);
  SessionSettings held = held_to_rating(settings, rating);
  std::string lowered;
  add_lowered(lowered, "a stiffness of", settings.stiffness, held.stiffness, "N/m");
  add_lowered(lowered, "a metric length of", settings.metric_length, held.metric_length, "m");
  add_lowered(lowered, "a damping of", settings.damping, held.damping, "N s/m");
  add_lowered(lowered, "a contact transient of", settings.transient, held.transient, "N s/m");
  if (held.rotational_damping && held.rotational_damping != settings.rotational_damping) {
    lowered +=
        fmt::format("{}a rotational damping of {:g} N m s/rad", lowered.empty() ? "" : ", ", *held.rotational_damping);
  }
  warning = lowered.empty()
                ? ""
                : fmt::format("{} in a {} hand is rated for {:.4g} N/m and {:.4g} N m/rad: rendered with {}.",
                              request.choice.name, request.hand_name, rating.max_stiffness,
                              rating.max_rotational_stiffness, lowered);
  return held;
}

ExperimentInterface interface_for(const InterfaceRequest& request, const Trajectory& motion, const Vector3& up_W,
                                  std::span<const TickRecord> played, const Tool& tool) {
  ExperimentInterface result;
  const InterfaceCapability capability = capability_in_hand(request.choice, request.hand, 1e-3);
  EffortLimits limits{capability.max_force, capability.max_torque};
  SpidarPlace place;
  result.notes.push_back(fmt::format("interface: {}, in a hand: {}", request.choice.name, request.hand_name));
  if (const auto* geometry = std::get_if<SpidarGeometry>(&request.choice.model)) {
    place = place_spidar(*geometry, motion, up_W);
    limits = {std::min(limits.force, place.force), std::min(limits.torque, place.torque)};
    result.notes.push_back("middle of the SPIDAR's frame in the world: " + pose_text(place.X_WS));
    result.notes.push_back("tool on its grip: " + pose_text({Vector3::Zero(), place.q_GT}));
    result.notes.push_back(fmt::format("reached in every direction all along the motion: {:.4g} N, {:.4g} N m",
                                       place.force, place.torque));
  }
  Trajectory meant = with_effort(played, motion.start(), tool, request.hand, limits);
  result.interface =
      make_simulated(request.choice, request.hand, std::make_unique<IntendedTrajectory>(std::move(meant)), place);
  return result;
}

}  // namespace tegotae
