// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/plain.hpp>
#include <tegotae/model/scene_geometry.hpp>

#include <span>

namespace tegotae {

/// What the physics world learns of the tool.
struct ToolState {
  Pose X_WT;
  Twist V_WT;  ///< of the tool frame's origin, world axes
  Pose X_WP;   ///< where the world lets the tool be

  ToolState() = default;
  ToolState(const Pose& tool, const Twist& velocity) : ToolState(tool, velocity, tool) {}
  ToolState(const Pose& tool, const Twist& velocity, const Pose& proxy) : X_WT(tool), V_WT(velocity), X_WP(proxy) {}
};

/// Impulse given to one moving body over a physics step.
struct BodyImpulse {
  Vector3 linear = Vector3::Zero();   ///< N s, world axes
  Vector3 angular = Vector3::Zero();  ///< N m s about the body's centre of mass, world axes
};

/// Port to a physics engine: moves the bodies that the tool touches. Called by the physics loop only, from one thread.
class World {
 public:
  World() = default;
  World(const World&) = delete;
  World& operator=(const World&) = delete;
  virtual ~World() = default;

  /// Shapes of the tool and of the bodies; unchanged for the world's life.
  virtual const SceneGeometry& geometry() const = 0;

  /// Present state of the moving bodies; `states[i]` is that of moving_index i.
  virtual void read_bodies(std::span<BodyState> states) const = 0;

  /// Integrates `duration` (s) with the tool at `tool` and gives each moving body its impulse, once, spread evenly over
  /// the duration. `impulses[i]` is that of moving_index i.
  virtual void advance(double duration, const ToolState& tool, std::span<const BodyImpulse> impulses) = 0;
};

}  // namespace tegotae
