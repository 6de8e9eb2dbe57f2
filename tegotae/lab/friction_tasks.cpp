// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/friction_tasks.hpp>

#include <tegotae/lab/axes.hpp>
#include <tegotae/lab/contact_experiment.hpp>
#include <tegotae/lab/friction_references.hpp>
#include <tegotae/lab/motion.hpp>
#include <tegotae/lab/smooth_path.hpp>
#include <tegotae/math/rotation.hpp>

#include <cmath>
#include <numbers>

namespace tegotae {
namespace {

constexpr double kFriction = 0.5;
constexpr double kDragDepth = 1e-3;    // m, of the lowest point under the floor
constexpr double kHalfDragged = 0.02;  // m, of the cube
constexpr double kFaceEdge = 0.06;     // m, of the plate's lower face
constexpr double kDiscRadius = 0.03;   // m

// The tool turned by `q_WT`, its lowest point `depth` under the floor.
Pose over_floor(const Tool& tool, double x, double depth, const Quaternion& q_WT) {
  return {{x, 0.0, -lowest_height(tool, q_WT, Vector3::UnitZ()) - depth}, q_WT};
}

SmoothPath lowered() { return {{0.0, -2e-3}, {0.4, kDragDepth}}; }

Trajectory leaning(const Tool& tool) {
  const SmoothPath angle({{0.5, 0.0}, {4.0, 40.0}, {5.0, 0.0}});
  return sampled(0.0, 5.0, [&, depth = lowered()](double time) {
    const double x = kDragDepth * std::tan(angle.at(time) * kDegree);
    return over_floor(tool, x, depth.at(time), Quaternion::Identity());
  });
}

std::function<Trajectory(const Tool&)> dragged(const Quaternion& q_WT) {
  return [=](const Tool& tool) {
    const SmoothPath x({{0.5, -0.04}, {2.2, 0.04}, {2.4, 0.04}, {4.1, -0.04}});
    return sampled(0.0, 4.2,
                   [&, depth = lowered()](double time) { return over_floor(tool, x.at(time), depth.at(time), q_WT); });
  };
}

Trajectory twisted(const Tool& tool) {
  const SmoothPath angle({{0.5, 0.0}, {1.8, 20.0}, {3.4, -20.0}, {4.0, -20.0}});
  return sampled(0.0, 4.0, [&, depth = lowered()](double time) {
    return over_floor(tool, 0.0, depth.at(time), rotation_from_vector(angle.at(time) * kDegree * Vector3::UnitZ()));
  });
}

Experiment drag(const std::string& name, const std::string& summary, const Quaternion& q_WT) {
  Experiment experiment = contact_experiment(name, summary, "cube-on-floor.xml", kFriction);
  experiment.motion = dragged(q_WT);
  experiment.phases = {
      {"a", "lowered onto the floor", 0.0, 0.5}, {"b", "dragged along x", 0.5, 2.4}, {"c", "dragged back", 2.4, 4.2}};
  experiment.force_axis = kAlongX;
  experiment.figures = {wrench_over_time(experiment, "Dragged over a floor", kAlongX)};
  return experiment;
}

Experiment twist(const std::string& name, const std::string& summary, const std::string& scene, double mean_distance) {
  Experiment experiment = contact_experiment(name, summary, scene, kFriction);
  experiment.motion = twisted;
  experiment.phases = {{"a", "pressed onto the floor", 0.0, 0.5},
                       {"b", "twisted by 20 degrees", 0.5, 1.8},
                       {"c", "twisted back by 40 degrees", 1.8, 4.0}};
  experiment.torque_axis = kAlongZ;
  experiment.figures = {wrench_over_time(experiment, "A face twisted on a floor", kAlongZ)};
  experiment.reference = flat_face_reference(kFriction, mean_distance);
  experiment.notes =
      "The torque grows with the twist up to the coefficient of friction times the normal force times the mean "
      "distance of the face's places from its centre.";
  return experiment;
}

}  // namespace

double mean_distance_in_square(double edge) {
  return edge * (std::numbers::sqrt2 + std::log(1.0 + std::numbers::sqrt2)) / 6.0;
}

double mean_distance_in_disc(double radius) { return 2.0 / 3.0 * radius; }

Experiment slope_experiment() {
  Experiment experiment = contact_experiment("slope", "a face pressed with a force that leans until it slips",
                                             "plate-on-floor.xml", kFriction);
  experiment.motion = leaning;
  experiment.phases = {
      {"a", "pressed onto the floor", 0.0, 0.5}, {"b", "leaned to 40 degrees", 0.5, 4.0}, {"c", "back", 4.0, 5.0}};
  experiment.force_axis = kAlongX;
  experiment.figures = {wrench_over_time(experiment, "A force that leans", kAlongX)};
  experiment.reference = flat_face_reference(kFriction, mean_distance_in_square(kFaceEdge));
  experiment.notes =
      "As on a slope that grows steeper: the face sticks until the force leans by atan 0.5 = 26.57 degrees from the "
      "normal, and slips from then on with the force on the cone.";
  return experiment;
}

Experiment drag_face_experiment() {
  Experiment experiment = drag("drag-face", "a cube dragged over a floor on a face", Quaternion::Identity());
  experiment.reference = flat_face_reference(kFriction, mean_distance_in_square(2.0 * kHalfDragged));
  experiment.notes =
      "The drag is the coefficient of friction times the normal force, and the normal force is what it is at rest.";
  return experiment;
}

Experiment drag_edge_experiment() {
  Experiment experiment = drag("drag-edge", "a cube dragged over a floor on an edge, across it",
                               rotation_from_vector(0.5 * Vector3::UnitY()));
  experiment.reference = dragged_point_reference({kHalfDragged, 0.0, -kHalfDragged}, kFriction);
  experiment.notes =
      "The normal force and the drag both turn the tool, and so change each other: to first order N = k d / (1 + (x^2 "
      "+- 0.5 h x) / l^2), x and h the centre's distances from the edge sideways and upwards.";
  return experiment;
}

Experiment drag_vertex_experiment() {
  Experiment experiment =
      drag("drag-vertex", "a cube dragged over a floor on a vertex",
           rotation_from_vector(0.5 * Vector3::UnitY()) * rotation_from_vector(0.4 * Vector3::UnitX()));
  experiment.reference = dragged_point_reference({kHalfDragged, -kHalfDragged, -kHalfDragged}, kFriction);
  experiment.notes = "As on the edge, but turned about all axes.";
  return experiment;
}

Experiment twist_square_experiment() {
  return twist("twist-square", "a square face twisted on a floor", "plate-on-floor.xml",
               mean_distance_in_square(kFaceEdge));
}

Experiment twist_disc_experiment() {
  return twist("twist-disc", "a disc twisted on a floor", "disc-on-floor.xml", mean_distance_in_disc(kDiscRadius));
}

}  // namespace tegotae
