// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/tilt_sweep.hpp>

#include <tegotae/lab/axes.hpp>
#include <tegotae/lab/motion.hpp>
#include <tegotae/lab/offline_reference.hpp>
#include <tegotae/lab/quantities.hpp>
#include <tegotae/math/rotation.hpp>

namespace tegotae {
namespace {

constexpr double kDuration = 4.0;         // s: a tick turns the cube by 0.00025 degrees
constexpr double kSweep = 0.5 * kDegree;  // to either side
constexpr double kFlatDepth = 0.3e-3;     // m, of the face where it is flat

Trajectory tilting(const Tool& tool) {
  const double height = -lowest_height(tool, Quaternion::Identity(), Vector3::UnitY()) - kFlatDepth;
  return sampled(0.0, kDuration, [height](double time) {
    const double angle = (2.0 * time / kDuration - 1.0) * kSweep;
    return Pose{{0.0, height, 0.0}, rotation_from_vector(angle * Vector3::UnitZ())};
  });
}

std::vector<Curve> both_sets(const Quantity& rendered) {
  return {{"penetrating points", 0, rendered, false}, {"all near points", 1, rendered, false}};
}

std::vector<Variant> variants() {
  SettingsRequest penetrating;
  penetrating.metric_length = 0.0;
  penetrating.constraint_set = ConstraintSet::kPenetratingPoints;
  SettingsRequest near = penetrating;
  near.constraint_set = ConstraintSet::kNearPoints;
  return {{"penetrating", "penetrating points only", penetrating, "as published"}, {"near", "all near points", near}};
}

}  // namespace

Experiment tilt_sweep_experiment() {
  Experiment experiment;
  experiment.name = "tilt-sweep";
  experiment.summary = "the paper's cube, 0.3 mm too low, swept through the flat pose: is the force continuous?";
  experiment.scene = "paper-cube.xml";
  experiment.tool = "tool";
  experiment.settings.friction = 0.0;
  experiment.motion = tilting;
  experiment.phases = {{"a", "swept to the flat pose", 0.0, 0.5 * kDuration},
                       {"b", "swept on", 0.5 * kDuration, kDuration}};
  experiment.variants = variants();
  experiment.force_axis = {"y", Vector3::UnitY()};
  experiment.torque_axis = {"z", Vector3::UnitZ()};
  Figure figure{.name = "force-over-tilt",
                .title = "Force and torque over the tilt",
                .paper_title = "(the set of constraints decides whether the force jumps)"};
  figure.x_label = "{/Symbol q}_z [deg]";
  figure.x = angle_about(Vector3::UnitZ());
  figure.panels = {{"f_y [N]", both_sets(force_along(Vector3::UnitY()))},
                   {"{/Symbol t}_z [N m]", both_sets(torque_along(Vector3::UnitZ()))}};
  experiment.figures = {figure};
  experiment.reference = offline_reference();
  experiment.paper_notes =
      "With penetrating points only, a point that begins to penetrate makes the present solution infeasible at once "
      "and the force jumps. With all near points the solution, and so the force, is continuous.";
  return experiment;
}

}  // namespace tegotae
