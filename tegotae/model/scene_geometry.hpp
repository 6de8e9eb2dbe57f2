// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/pose.hpp>
#include <tegotae/math/twist.hpp>
#include <tegotae/shape/mass_properties.hpp>
#include <tegotae/shape/shape.hpp>

#include <string>
#include <vector>

namespace tegotae {

/// A body of the world that the tool may touch: convex pieces rigidly joined.
struct Body {
  std::string name;
  std::vector<Shape> pieces;       ///< each placed on the body by its X_BS
  Pose X_WB;                       ///< pose of a static body; the first pose of a moving one
  int moving_index = -1;           ///< place among the moving bodies, or -1: static
  Vector3 p_BC = Vector3::Zero();  ///< centre of mass on the body, m (moving bodies)
  double mass = 0.0;               ///< kg, without what joints link to it; 0: unknown (moving bodies)
  double gyration_length = 0.0;    ///< m, sqrt(tr I / 3m) about the centre of mass; 0: unknown (moving bodies)
};

/// The object that the hand holds.
struct Tool {
  std::string name;
  std::vector<Shape> pieces;  ///< each placed on the tool by its X_BS
  MassProperties mass;        ///< in the tool's frame
  Pose X_WT;                  ///< pose in the scene as loaded
};

/// The shapes of a scene: fixed once loaded, so both rates read it without exchange. Poses of moving bodies
/// travel in `BodyState` and in the intermediate representation.
struct SceneGeometry {
  Tool tool;
  std::vector<Body> bodies;
  int moving_count = 0;
};

/// Pose and velocity of one moving body.
struct BodyState {
  Pose X_WB;
  Twist V_WB;  ///< of the centre of mass, world axes
};

}  // namespace tegotae
