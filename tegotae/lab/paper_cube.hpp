// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/experiment.hpp>

namespace tegotae {

/// The paper's experiment (section 5; figures 5 and 6): a cube of 0.2 m edge touches a floor with an edge, is turned
/// onto its face and held there. Rendered with metric lengths of 1 m and of the cube's own gyration length.
Experiment paper_cube_experiment();

/// Force (N) and torque about the centre (N m) that the paper's method displays for a cube on a floor, in closed form.
struct CubeOnFloor {
  double force_y = 0.0;
  double torque_z = 0.0;
};

/// The cube of half edge `half_edge` (m), its centre at `height` (m) over the floor y = 0, turned by `angle` (rad, at
/// most 45 degrees to either side) about z, at stiffness `stiffness` (N/m) and metric length `metric_length` (m). With
/// one edge, at lever arm x and depth d, below the floor: f = k d / (1 + x^2 / l^2), torque x f. With both edges of the
/// lower face, as long as both push, the displacement that lifts both to the floor.
CubeOnFloor cube_on_floor(double half_edge, double height, double angle, double stiffness, double metric_length);

}  // namespace tegotae
