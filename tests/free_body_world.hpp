// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/runtime/world.hpp>

#include <utility>
#include <vector>

namespace tegotae::test {

/// A world whose moving bodies float freely: each moves with its velocity, and an impulse changes its linear velocity
/// by impulse / mass. Small enough to know exactly what must come out.
class FreeBodyWorld : public World {
 public:
  explicit FreeBodyWorld(SceneGeometry geometry, double mass = 1.0) : geometry_(std::move(geometry)), mass_(mass) {
    for (const Body& body : geometry_.bodies) {
      if (body.moving_index < 0) continue;
      bodies_.push_back({body.X_WB, {}});
      received_.emplace_back();
    }
    geometry_.moving_count = static_cast<int>(bodies_.size());
  }

  const SceneGeometry& geometry() const override { return geometry_; }
  void read_bodies(std::span<BodyState> states) const override {
    std::copy(bodies_.begin(), bodies_.end(), states.begin());
  }
  void advance(double duration, const ToolState& tool, std::span<const BodyImpulse> impulses) override {
    last_tool = tool;
    for (size_t i = 0; i < bodies_.size(); ++i) {
      received_[i].linear += impulses[i].linear;
      received_[i].angular += impulses[i].angular;
      bodies_[i].V_WB.linear += impulses[i].linear / mass_;
      bodies_[i].X_WB.p += duration * bodies_[i].V_WB.linear;
    }
    ++steps;
  }

  BodyState& body(int i) { return bodies_[static_cast<size_t>(i)]; }
  const BodyImpulse& received(int i) const { return received_[static_cast<size_t>(i)]; }

  ToolState last_tool;
  int steps = 0;

 private:
  SceneGeometry geometry_;
  double mass_;
  std::vector<BodyState> bodies_;
  std::vector<BodyImpulse> received_;
};

/// The paper's scene: a cube of 0.2 m edge over a floor whose top is y = 0; the cube is the tool.
inline SceneGeometry cube_over_floor() {
  SceneGeometry scene;
  scene.tool.name = "cube";
  scene.tool.pieces = {make_box(Vector3::Constant(0.1))};
  scene.tool.mass = mass_properties(scene.tool.pieces[0], 1000.0);
  scene.tool.X_WT.p = Vector3(0.0, 0.3, 0.0);
  Body floor;
  floor.name = "floor";
  floor.pieces = {make_box(Vector3(1.0, 0.1, 1.0))};
  floor.X_WB.p = Vector3(0.0, -0.1, 0.0);
  scene.bodies.push_back(floor);
  return scene;
}

}  // namespace tegotae::test
