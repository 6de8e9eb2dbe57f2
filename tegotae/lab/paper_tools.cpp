// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/paper_tools.hpp>

#include <tegotae/lab/axes.hpp>
#include <tegotae/lab/motion.hpp>
#include <tegotae/lab/offline_reference.hpp>
#include <tegotae/lab/quantities.hpp>
#include <tegotae/math/rotation.hpp>

#include <fmt/format.h>

#include <string>
#include <utility>

namespace tegotae {
namespace {

constexpr double kToolTouched = 1.0, kPressed = 2.0, kRolled = 5.0, kToolEnd = 6.0;  // s
constexpr double kToolClearance = 0.02;                                              // m
constexpr double kTouchDepth = 0.2e-3, kPressDepth = 1e-3;                           // m, of the lowest point
constexpr double kRoll = 20.0 * kDegree;

double tool_depth_at(double time) {
  if (time <= kToolTouched) return SmoothStep{0.0, kToolTouched, -kToolClearance, kTouchDepth}.at(time);
  if (time <= kRolled) return SmoothStep{kToolTouched, kPressed, kTouchDepth, kPressDepth}.at(time);
  return SmoothStep{kRolled, kToolEnd, kPressDepth, -kToolClearance}.at(time);
}

double roll_at(double time) {
  if (time <= 3.0) return SmoothStep{kPressed, 3.0, 0.0, kRoll}.at(time);
  if (time <= 4.5) return SmoothStep{3.0, 4.5, kRoll, -kRoll}.at(time);
  return SmoothStep{4.5, kRolled, -kRoll, 0.0}.at(time);
}

Trajectory press_and_roll_motion(const Tool& tool) {
  return sampled(0.0, kToolEnd, [&tool](double time) {
    const Quaternion q_WT = rotation_from_vector(roll_at(time) * Vector3::UnitY());
    return Pose{{0.0, 0.0, -lowest_height(tool, q_WT, Vector3::UnitZ()) - tool_depth_at(time)}, q_WT};
  });
}

std::vector<Curve> both_lengths(const Quantity& rendered) {
  const std::string length = fmt::format("l = {}", kMetricLengthText);
  return {{length, 0, rendered, false}, {length, 1, rendered, false}};
}

std::vector<Figure> press_and_roll_figures() {
  const Vector3 y = Vector3::UnitY(), z = Vector3::UnitZ();
  Figure force{.name = "force-and-torque", .title = "Pressed on a floor and rolled"};
  force.panels = {{"z [m]", {{"z", 0, position_along(z), false}}},
                  {"{/Symbol q}_y [deg]", {{"{/Symbol q}_y", 0, angle_about(y), false}}},
                  {"f_z [N]", both_lengths(force_along(z))},
                  {"{/Symbol t}_y [N m]", both_lengths(torque_along(y))}};
  return {force};
}

Experiment press_and_roll(const std::string& name, const std::string& summary) {
  Experiment experiment;
  experiment.name = name;
  experiment.summary = summary;
  experiment.scene = name + ".xml";
  experiment.tool = "tool";
  experiment.settings.friction = 0.0;
  experiment.motion = press_and_roll_motion;
  experiment.phases = {{"a", "lowered onto the floor", 0.0, kToolTouched},
                       {"b", "pressed", kToolTouched, kPressed},
                       {"c", "rolled to both sides", kPressed, kRolled},
                       {"d", "lifted", kRolled, kToolEnd}};
  experiment.variants = metric_length_variants();
  experiment.force_axis = {"z", Vector3::UnitZ()};
  experiment.torque_axis = {"y", Vector3::UnitY()};
  experiment.figures = press_and_roll_figures();
  experiment.reference = offline_reference();
  experiment.paper_notes =
      "Force and torque follow the tool's shape; pressing until all vertices below are in the floor does not change "
      "the force abruptly.";
  return experiment;
}

}  // namespace

Experiment tool_18_experiment() {
  return press_and_roll("tool-18", "the paper's figure 7a: 18 vertices, denser at one end, pressed and rolled");
}

Experiment tool_230_round_experiment() {
  return press_and_roll("tool-230-round", "the paper's figure 7b: 230 vertices, round, pressed and rolled");
}

Experiment tool_230_flat_experiment() {
  return press_and_roll("tool-230-flat", "230 vertices, 115 of them on each flat end, pressed and rolled");
}

}  // namespace tegotae
