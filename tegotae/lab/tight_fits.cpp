// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/tight_fits.hpp>

#include <tegotae/lab/axes.hpp>
#include <tegotae/lab/contact_experiment.hpp>
#include <tegotae/lab/motion.hpp>
#include <tegotae/lab/offline_reference.hpp>
#include <tegotae/lab/smooth_path.hpp>
#include <tegotae/math/rotation.hpp>
#include <tegotae/render/tolerances.hpp>

#include <algorithm>
#include <cmath>

namespace tegotae {
namespace {

/// Place (m) and rotation vector (degrees) over time.
struct SixPaths {
  SmoothPath x{{0.0, 0.0}}, y{{0.0, 0.0}}, z{{0.0, 0.0}};
  SmoothPath about_x{{0.0, 0.0}}, about_y{{0.0, 0.0}}, about_z{{0.0, 0.0}};

  Pose at(double time) const {
    const Vector3 turn(about_x.at(time), about_y.at(time), about_z.at(time));
    return {{x.at(time), y.at(time), z.at(time)}, rotation_from_vector(kDegree * turn)};
  }
};

std::function<Trajectory(const Tool&)> motion_along(const SixPaths& paths, double duration) {
  return [=](const Tool&) { return sampled(0.0, duration, [&](double time) { return paths.at(time); }); };
}

constexpr double kHalfHeight = 0.02;  // m, of the block in the slots

SixPaths in_the_narrow_slot() {
  SixPaths paths;
  paths.x = {{0.5, 2e-5}, {0.9, 3e-4}, {1.5, -3e-4}, {2.0, 2e-5}, {3.0, 2e-5}, {3.2, 0.0}};
  paths.about_y = {{1.0, 0.0}, {1.4, 1.0}, {2.0, -1.0}, {2.5, 0.2}, {3.0, 0.2}, {3.2, 0.0}};
  paths.about_z = {{1.0, 0.0}, {1.5, 0.5}, {2.0, -0.5}, {2.4, 0.0}};
  paths.z = {{3.2, -0.022}, {4.0, 0.03}, {4.8, kHalfHeight - 1e-3}};
  return paths;
}

// Between the walls the block can neither shift across the slot nor turn out of it; over the rims it lies flat. How it
// leaves the slot is not said, nor the first ticks, in which it finds its place between the walls.
std::vector<ReferenceSample> narrow_slot_reference(const ReferenceTask& task, const Progress&) {
  constexpr double kLeast = 1e-3;  // m of the block in the slot
  constexpr double kFinds = 0.05;  // s: 0.05 mm at the speed at which a tool is pushed out
  const double k = task.settings.stiffness, l2 = task.settings.metric_length * task.settings.metric_length;
  const double skin = std::min(tolerance::kSkin, tolerance::kSkinForce / k);
  bool left = false;
  std::vector<ReferenceSample> samples;
  for (const Pose& X_WT : task.X_WT) {
    const double bottom = X_WT.p.z() - kHalfHeight;
    ReferenceSample sample;
    left = left || bottom > skin;
    if (left) {
      sample.touches = bottom < skin;
      sample.wrench.force.z() = k * std::max(0.0, skin - bottom);
    } else {
      sample.touches = true;
      sample.defined = bottom<-kLeast&& static_cast<double>(samples.size()) * task.period> kFinds;
      sample.wrench.force.x() = -k * X_WT.p.x();
      const Quaternion back = Quaternion::FromTwoVectors(X_WT.q * Vector3::UnitX(), Vector3::UnitX());
      sample.wrench.torque = k * l2 * rotation_vector(back);
    }
    samples.push_back(sample);
  }
  return samples;
}

SixPaths in_the_slot_with_play() {
  SixPaths paths;
  paths.z = {{0.0, 0.03}, {1.2, -0.022}};
  paths.x = {{1.2, 0.0}, {1.5, 2e-4}, {2.1, -2e-4}, {2.7, 2e-4}, {3.3, 5e-5}};
  paths.about_y = {{1.5, 0.0}, {1.9, 0.5}, {2.6, -0.5}, {3.2, 0.1}};
  paths.about_z = {{1.7, 0.0}, {2.2, 0.3}, {2.8, -0.3}, {3.2, 0.0}};
  return paths;
}

constexpr double kFit = 0.03;  // m, height of the block's centre where its lower edges touch both walls

SixPaths in_the_wedge() {
  SixPaths paths;
  paths.z = {{0.0, kFit + 0.01}, {0.8, kFit - 0.6e-3}};
  paths.x = {{1.2, 0.0}, {1.6, 3e-4}, {2.2, -3e-4}, {2.8, 5e-5}};
  paths.about_y = {{1.6, 0.0}, {2.0, 0.3}, {2.6, -0.3}, {3.0, 0.05}};
  return paths;
}

constexpr double kPegSeated = 0.0;  // m, height of the peg's centre on the hole's floor: 30 mm deep, 30 mm of half peg

SixPaths into_the_hole() {
  SixPaths paths;
  paths.x = {{0.0, 5e-3}, {0.8, 2e-5}, {3.2, 2e-5}, {3.6, 4e-4}, {4.2, -4e-4}, {4.8, 2e-5}};
  paths.y = {{0.0, -4e-3}, {0.8, -1e-5}, {3.4, -1e-5}, {3.9, 3e-4}, {4.5, -3e-4}, {5.0, -1e-5}};
  paths.about_y = {{0.2, 10.0}, {0.9, 0.0}, {3.4, 0.0}, {3.8, 0.8}, {4.4, -0.8}, {5.0, 0.0}};
  paths.about_x = {{3.6, 0.0}, {4.0, 0.5}, {4.6, -0.5}, {5.0, 0.0}};
  paths.z = {{0.0, 0.05}, {1.0, 0.032}, {2.6, kPegSeated}, {3.0, kPegSeated - 2.5e-3}};
  return paths;
}

}  // namespace

Experiment slot_narrow_experiment() {
  Experiment experiment = contact_experiment(
      "slot-narrow", "a block in a slot 0.1 mm too narrow for it, then on its rims", "slot-narrow.xml", 0.0);
  experiment.motion = motion_along(in_the_narrow_slot(), 5.5);
  experiment.phases = {{"a", "held 0.02 mm off the middle", 0.0, 0.5},
                       {"b", "moved across and turned", 0.5, 2.5},
                       {"c", "held, tilted by 0.2 degrees", 2.5, 3.0},
                       {"d", "pulled out", 3.0, 4.0},
                       {"e", "pressed onto the rims", 4.0, 5.5}};
  experiment.force_axis = kAlongX;
  experiment.figures = {wrench_over_time(experiment, "In a slot too narrow", kAlongX)};
  experiment.reference = narrow_slot_reference;
  experiment.notes =
      "No place satisfies both walls; the least violation is the middle, and the hand is pulled there. The walls push "
      "against each other with far more than the hand feels, which must not chatter.";
  return experiment;
}

Experiment slot_play_experiment() {
  Experiment experiment =
      contact_experiment("slot-play", "a block in a slot with 0.02 mm of play", "slot-play.xml", 0.0);
  experiment.motion = motion_along(in_the_slot_with_play(), 4.2);
  experiment.phases = {{"a", "put in", 0.0, 1.2}, {"b", "wobbled", 1.2, 3.3}, {"c", "held", 3.3, 4.2}};
  experiment.force_axis = kAlongX;
  experiment.figures = {wrench_over_time(experiment, "In a slot with little play", kAlongX)};
  experiment.reference = offline_reference();
  experiment.notes = "Across the slot the block has 0.01 mm to either side; along it and upwards it is free.";
  return experiment;
}

Experiment wedge_experiment() {
  Experiment experiment =
      contact_experiment("wedge", "a block pressed between walls 5 degrees off the vertical", "wedge.xml", 0.0);
  experiment.motion = motion_along(in_the_wedge(), 3.8);
  experiment.phases = {
      {"a", "pressed in", 0.0, 1.2}, {"b", "moved across and tilted", 1.2, 3.0}, {"c", "held", 3.0, 3.8}};
  experiment.figures = {wrench_over_time(experiment, "Pressed into a wedge", kAlongZ)};
  experiment.reference = offline_reference();
  experiment.notes =
      "Each wall pushes with nearly six times the force that is felt. The hand feels where the block fits, without "
      "chatter.";
  return experiment;
}

Experiment peg_in_hole_experiment() {
  Experiment experiment = contact_experiment(
      "peg-in-hole", "a square peg into a hole with 0.1 mm of clearance, then wobbled", "peg-in-hole.xml", 0.0);
  experiment.motion = motion_along(into_the_hole(), 5.4);
  experiment.phases = {{"a", "aligned over the hole: 10 degrees of tilt taken out", 0.0, 1.0},
                       {"b", "put in", 1.0, 2.6},
                       {"c", "pushed to the bottom", 2.6, 3.2},
                       {"d", "wobbled", 3.2, 5.0},
                       {"e", "held", 5.0, 5.4}};
  experiment.figures = {wrench_over_time(experiment, "A peg in a hole", kAlongZ)};
  experiment.reference = offline_reference();
  experiment.notes =
      "Within its clearance the peg enters without a force, seats on the floor, and is then held from all sides: the "
      "torque follows the wobble without steps.";
  return experiment;
}

}  // namespace tegotae
