// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/paper_cube.hpp>

#include <tegotae/lab/axes.hpp>
#include <tegotae/lab/motion.hpp>
#include <tegotae/lab/offline_reference.hpp>
#include <tegotae/lab/quantities.hpp>
#include <tegotae/math/rotation.hpp>

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace tegotae {
namespace {

constexpr double kHalfPaperCube = 0.1;  // m, of the cube in the scene

// The paper's times: about 6 s in all, the edge turned onto the face by 3.8 s.
constexpr double kEdgeTouched = 1.5, kTurnedFlat = 3.8, kCubeEnd = 6.0;  // s
constexpr double kCubeClearance = 0.03;                                  // m under the lowest edge at first
constexpr double kEdgeDepth = 0.35e-3;                                   // m, of the lowest edge while it turns
constexpr double kFaceDepth = 0.4e-3;                                    // m, of the lowest edge while the face is held
constexpr double kFaceTilt = 0.02 * kDegree;                             // a hand never holds the face exactly parallel

double tilt_at(double time) {
  if (time <= kEdgeTouched) return SmoothStep{0.0, 0.6, 0.0, 45.0 * kDegree}.at(time);
  if (time <= kTurnedFlat) return SmoothStep{kEdgeTouched, kTurnedFlat, 45.0 * kDegree, 0.0}.at(time);
  return SmoothStep{4.0, 4.5, 0.0, kFaceTilt}.at(time);
}

double cube_depth_at(double time) {
  if (time <= kEdgeTouched) return SmoothStep{0.5, kEdgeTouched, -kCubeClearance, kEdgeDepth}.at(time);
  return SmoothStep{4.5, 5.0, kEdgeDepth, kFaceDepth}.at(time);
}

Trajectory edge_to_face(const Tool& tool) {
  return sampled(0.0, kCubeEnd, [&tool](double time) {
    const Quaternion q_WT = rotation_from_vector(tilt_at(time) * Vector3::UnitZ());
    const double height = -lowest_height(tool, q_WT, Vector3::UnitY()) - cube_depth_at(time);
    return Pose{{0.0, height, 0.0}, q_WT};
  });
}

CubeOnFloor closed_form(const TickRecord& record, const SessionSettings& settings) {
  return cube_on_floor(kHalfPaperCube, record.X_WT.p.y, 2.0 * std::atan2(record.X_WT.z, record.X_WT.w),
                       settings.stiffness, settings.metric_length);
}

Quantity closed_form_force() {
  return
      [](const TickRecord& record, const SessionSettings& settings) { return closed_form(record, settings).force_y; };
}

Quantity closed_form_torque() {
  return
      [](const TickRecord& record, const SessionSettings& settings) { return closed_form(record, settings).torque_z; };
}

// Only while the edge is turned onto the face, from a tilt of half a degree on.
Quantity near_face(Quantity quantity) {
  return [quantity = std::move(quantity)](const TickRecord& record, const SessionSettings& settings) {
    const bool shown = record.time > kEdgeTouched && record.time <= kTurnedFlat && tilt_at(record.time) < 0.5 * kDegree;
    return shown ? quantity(record, settings) : std::numeric_limits<double>::quiet_NaN();
  };
}

std::vector<Curve> both_lengths(const Quantity& rendered, const Quantity& reference) {
  const std::string length = fmt::format("l = {}", kMetricLengthText);
  return {{length, 0, rendered, false},
          {length, 1, rendered, false},
          {"closed form", 0, reference, true},
          {"", 1, reference, true}};
}

std::vector<Figure> edge_to_face_figures() {
  const Vector3 y = Vector3::UnitY(), z = Vector3::UnitZ();
  const std::string length = fmt::format("l = {}", kMetricLengthText);
  Figure force{.name = "figure-5", .title = "Height and force, " + length, .paper_title = "(the paper's figure 5)"};
  force.panels = {{"y [m]", {{"y", 0, position_along(y), false}}}, {"f_y [N]", {{"f_y", 0, force_along(y), false}}}};
  Figure torque{.name = "figure-6", .title = "Angle and torque, " + length, .paper_title = "(the paper's figure 6)"};
  torque.panels = {{"{/Symbol q}_z [deg]", {{"{/Symbol q}_z", 0, angle_about(z), false}}},
                   {"{/Symbol t}_z [N m]", {{"{/Symbol t}_z", 0, torque_along(z), false}}}};
  Figure metric{.name = "metric-length", .title = "Force and torque with both metric lengths"};
  metric.panels = {{"f_y [N]", both_lengths(force_along(y), closed_form_force())},
                   {"{/Symbol t}_z [N m]", both_lengths(torque_along(z), closed_form_torque())}};
  Figure face{.name = "face-contact",
              .title = "From the edge to the face at constant depth",
              .paper_title = "(the dip of the force)"};
  face.x_label = "{/Symbol q}_z [deg]";
  face.x = angle_about(z);
  face.x_descends = true;
  face.panels = {{"f_y [N]", both_lengths(near_face(force_along(y)), near_face(closed_form_force()))},
                 {"{/Symbol t}_z [N m]", both_lengths(near_face(torque_along(z)), near_face(closed_form_torque()))}};
  return {force, torque, metric, face};
}

}  // namespace

Experiment paper_cube_experiment() {
  Experiment experiment;
  experiment.name = "paper-cube";
  experiment.summary = "the paper's section 5: a cube's edge on a floor, turned onto its face and held";
  experiment.scene = "paper-cube.xml";
  experiment.tool = "tool";
  experiment.settings.friction = 0.0;
  experiment.motion = edge_to_face;
  experiment.phases = {{"a", "edge lowered onto the floor", 0.0, kEdgeTouched},
                       {"b", "edge turned onto the face", kEdgeTouched, kTurnedFlat},
                       {"c", "face pressed, held 0.02 deg off", kTurnedFlat, kCubeEnd}};
  experiment.variants = metric_length_variants();
  experiment.force_axis = {"y", Vector3::UnitY()};
  experiment.torque_axis = {"z", Vector3::UnitZ()};
  experiment.figures = edge_to_face_figures();
  experiment.reference = offline_reference();
  experiment.paper_notes =
      "At first touch the centre is above the edge: force without torque. Turning makes the torque grow on the "
      "negative side until just before the face lies flat. With the gyration length the force dips before the face "
      "carries, as the paper saw; with 1 m it does not.";
  return experiment;
}

CubeOnFloor cube_on_floor(double half_edge, double height, double angle, double stiffness, double metric_length) {
  const double c = half_edge * std::cos(angle), s = half_edge * std::sin(angle);
  const double lever[2] = {-c + s, c + s};                   // of the edges of the lower face, m
  const double depth[2] = {c + s - height, c - s - height};  // m
  const double l2 = metric_length * metric_length;
  const int deeper = depth[0] >= depth[1] ? 0 : 1, other = 1 - deeper;
  if (depth[deeper] <= 0.0) return {};

  // The deeper edge alone: the displacement dy, dtheta that lifts it to the floor.
  const double x = lever[deeper];
  double dy = depth[deeper] / (1.0 + x * x / l2);
  double dtheta = dy * x / l2;
  if (depth[other] > 0.0 && dy + lever[other] * dtheta < depth[other]) {
    dtheta = (depth[0] - depth[1]) / (lever[0] - lever[1]);
    dy = depth[0] - lever[0] * dtheta;
  }
  return {stiffness * dy, stiffness * l2 * dtheta};
}

}  // namespace tegotae
