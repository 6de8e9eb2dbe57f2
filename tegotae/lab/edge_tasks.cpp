// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/edge_tasks.hpp>

#include <tegotae/lab/axes.hpp>
#include <tegotae/lab/contact_experiment.hpp>
#include <tegotae/lab/motion.hpp>
#include <tegotae/lab/offline_reference.hpp>
#include <tegotae/lab/smooth_path.hpp>
#include <tegotae/math/rotation.hpp>

namespace tegotae {
namespace {

Quaternion turned(const Vector3& axis, double degrees) { return rotation_from_vector(degrees * kDegree * axis); }

// The lowest point is `depth` under z = 0 where there is something; the centre goes along x.
Trajectory over_the_edge(const Tool& tool) {
  const SmoothPath x({{0.6, -0.06}, {2.4, 0.045}, {2.8, 0.045}, {3.6, -0.06}, {4.2, -0.06}, {6.0, 0.055}});
  const SmoothPath depth({{0.0, -0.01}, {0.6, 1e-3}, {2.4, 1e-3}, {2.8, -0.02}, {3.6, -0.01}, {4.2, 1e-3}});
  const SmoothPath roll({{2.8, 0.0}, {3.6, 4.0}}), yaw({{2.8, 0.0}, {3.6, 20.0}});
  return sampled(0.0, 6.0, [=, &tool](double time) {
    const Quaternion q_WT = turned(Vector3::UnitZ(), yaw.at(time)) * turned(Vector3::UnitX(), roll.at(time));
    return Pose{{x.at(time), 0.0, -lowest_height(tool, q_WT, Vector3::UnitZ()) - depth.at(time)}, q_WT};
  });
}

// At constant height of the centre.
Trajectory beyond_the_pillar(const Tool& tool) {
  const double height = -lowest_height(tool, Quaternion::Identity(), Vector3::UnitZ());
  const SmoothPath x({{0.6, 0.0}, {1.8, 0.045}, {2.2, 0.045}, {3.4, -0.03}});
  const SmoothPath y({{3.4, 0.0}, {4.2, 0.04}});
  const SmoothPath depth({{0.0, -0.01}, {0.6, 1e-3}, {5.4, 1e-3}, {6.0, -0.02}});
  const SmoothPath tilt(
      {{1.8, 0.0}, {2.0, 2.0}, {2.2, -2.0}, {2.6, 0.0}, {4.2, 0.0}, {4.6, 2.0}, {5.0, -2.0}, {5.4, 0.0}});
  return sampled(0.0, 6.0, [=](double time) {
    const Vector3 axis = time < 3.4 ? Vector3::UnitY() : Vector3::UnitX();
    return Pose{{x.at(time), y.at(time), height - depth.at(time)}, turned(axis, tilt.at(time))};
  });
}

Trajectory rolled_over(const Tool& tool) {
  constexpr double kBegin = -0.02, kEnd = 0.015;  // m
  const double radius = -lowest_height(tool, Quaternion::Identity(), Vector3::UnitZ());
  const SmoothPath x({{0.4, kBegin}, {2.0, kEnd}}), depth({{0.0, -5e-3}, {0.4, 1e-3}});
  return sampled(0.0, 2.0, [=](double time) {
    const double rolled = (x.at(time) - kBegin) / radius;
    return Pose{{x.at(time), 0.0, radius - depth.at(time)}, rotation_from_vector(rolled * Vector3::UnitY())};
  });
}

}  // namespace

Experiment table_edge_experiment() {
  Experiment experiment =
      contact_experiment("table-edge", "a flat box slides over a table's edge and drops", "table-edge.xml", 0.0);
  experiment.motion = over_the_edge;
  experiment.phases = {{"a", "lowered onto the table", 0.0, 0.6},
                       {"b", "slid over the edge, flat", 0.6, 2.4},
                       {"c", "brought back, turned by 20 and rolled by 4 degrees", 2.4, 3.6},
                       {"d", "lowered on an edge", 3.6, 4.2},
                       {"e", "slid over the edge, edge on edge", 4.2, 6.0}};
  experiment.figures = {wrench_over_time(experiment, "Slid over a table's edge", kAlongX)};
  experiment.reference = offline_reference();
  experiment.notes =
      "Beyond the edge the force falls with the lever arm and the torque grows; when the tool's rear passes the edge "
      "it "
      "drops, and nothing may be felt from then on. A plane that outlives the table's edge holds a ghost.";
  return experiment;
}

Experiment overhang_experiment() {
  Experiment experiment = contact_experiment(
      "overhang", "a plate on a pillar smaller than itself, its centre beyond the edge", "overhang.xml", 0.0);
  experiment.motion = beyond_the_pillar;
  experiment.phases = {{"a", "lowered onto the pillar", 0.0, 0.6},
                       {"b", "centre moved beyond one edge", 0.6, 1.8},
                       {"c", "tilted to and fro and back to the other side", 1.8, 3.4},
                       {"d", "centre moved beyond a corner", 3.4, 4.2},
                       {"e", "tilted to and fro", 4.2, 5.4},
                       {"f", "lifted", 5.4, 6.0}};
  experiment.figures = {wrench_over_time(experiment, "A plate on a pillar", kAlongX)};
  experiment.reference = offline_reference();
  experiment.notes =
      "The torque is the force times the distance of the pillar's edge, or corner, from the plate's centre. Points "
      "measured to the edge's plane in place of the pillar's surface make that arm too short.";
  return experiment;
}

Experiment knurl_experiment() {
  Experiment experiment =
      contact_experiment("knurl", "a knob of 5000 vertices rolls over a table's edge", "knurl.xml", 0.0);
  experiment.motion = rolled_over;
  experiment.phases = {{"a", "lowered onto the table", 0.0, 0.4}, {"b", "rolled over the edge", 0.4, 2.0}};
  experiment.figures = {wrench_over_time(experiment, "Rolled over a table's edge", kAlongX)};
  experiment.reference = offline_reference();
  experiment.notes = "Each vertex that takes over is a small bend of the force, never a step.";
  return experiment;
}

}  // namespace tegotae
