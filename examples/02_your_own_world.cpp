// SPDX-License-Identifier: Apache-2.0
// Objects of your own and no physics engine: a ball pressed against a wall of two boxes.
#include <tegotae/runtime/haptic_tick.hpp>
#include <tegotae/runtime/physics_loop.hpp>

#include <cmath>
#include <cstdio>
#include <memory>

using namespace tegotae;
class TwoBoxes : public World {  // the port: shapes, states of what moves (nothing here), a step
 public:
  TwoBoxes() {
    scene_.tool.pieces = {make_sphere(0.02)};
    scene_.tool.mass = mass_properties(scene_.tool.pieces[0], 1000.0);
    for (const double z : {-0.1, 0.1}) scene_.bodies.push_back({"box", {make_box({0.1, 0.1, 0.1})}, {{0, 0, z}}});
  }
  const SceneGeometry& geometry() const override { return scene_; }
  void read_bodies(std::span<BodyState>) const override {}
  void advance(double, const ToolState&, std::span<const BodyImpulse>) override {}

 private:
  SceneGeometry scene_;
};

int main() {
  TwoBoxes world;
  const Tool& tool = world.geometry().tool;
  PhysicsLoop physics(world, {0.01, 0.002}, ModelNeeds{});  // your loop, at its rate; with what `paper` needs
  HapticTick haptics(make_method("paper", {}, world.geometry()), tool, SafetyLimits{}, 0.001);
  const auto model = std::make_unique<IntermediateRepresentation>();
  InterfaceState hand;
  hand.X_WT.p = Vector3(0.1195, 0.0, 0.05);  // 0.5 mm into the wall
  physics.build(0.0, {hand.X_WT, {}}, *model);
  TickRecord tick;
  const InterfaceCommand command = haptics(hand, model.get(), {}, tick);  // goes to the interface, swelling from 0
  std::printf("method %.3f N, first command %.3f N\n", tick.wrench.force.x, command.wrench.force.x());
  return std::abs(tick.wrench.force.x - 0.5) < 0.005 ? 0 : 1;  // 1000 N/m times 0.5 mm
}
