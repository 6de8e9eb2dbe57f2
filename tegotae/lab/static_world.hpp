// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/runtime/world.hpp>

#include <utility>

namespace tegotae {

/// A world in which nothing moves but the tool: bodies without a physics engine.
class StaticWorld : public World {
 public:
  /// All bodies of `geometry` are taken as static.
  explicit StaticWorld(SceneGeometry geometry) : geometry_(std::move(geometry)) {
    for (Body& body : geometry_.bodies) body.moving_index = -1;
    geometry_.moving_count = 0;
  }

  const SceneGeometry& geometry() const override { return geometry_; }
  void read_bodies(std::span<BodyState> /*states*/) const override {}
  void advance(double /*duration*/, const ToolState& /*tool*/, std::span<const BodyImpulse> /*impulses*/) override {}

 private:
  SceneGeometry geometry_;
};

}  // namespace tegotae
