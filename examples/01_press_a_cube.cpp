// SPDX-License-Identifier: Apache-2.0
// A cube is lowered by 1 mm into the floor of a MuJoCo scene; what does the hand feel?
#include <tegotae/device/playback_interface.hpp>
#include <tegotae/runtime/simulated_session.hpp>
#include <tegotae/world/mujoco_world.hpp>

#include <cmath>
#include <cstdio>
#include <utility>

int main() {
  using namespace tegotae;
  const auto world = load_mujoco_world(TEGOTAE_SCENES "/paper-cube.xml", "tool");
  const Tool& tool = world->geometry().tool;

  // From 1 mm above the floor to 1 mm below it in a second (the scene's y points up).
  const Pose above{Vector3(0.0, 0.101, 0.0), Quaternion::Identity()};
  const Pose below{Vector3(0.0, 0.099, 0.0), Quaternion::Identity()};
  PlaybackInterface hand(Trajectory({{0.0, above}, {1.0, below}}));

  MethodSettings settings;
  settings.stiffness = 9000.0;  // N/m
  RenderingMethod method = make_method("proxy", settings, world->geometry());
  PhysicsLoop physics(*world, {0.05, 0.002}, needs_of(method));  // 20 Hz, 2 mm of margin
  HapticTick haptics(std::move(method), tool, SafetyLimits{}, 0.001);

  double last = 0.0;
  run_simulated(physics, haptics, hand, 0.001, 1.0, [&last](const TickRecord& tick) {
    last = tick.wrench.force.y;
    if (tick.model_sequence > 0 && std::fmod(tick.time + 1e-9, 0.1) < 1e-3) {
      std::printf("t = %.1f s   y = %.4f m   f_y = %.3f N\n", tick.time, tick.X_WT.p.y, tick.wrench.force.y);
    }
    return true;
  });
  return std::abs(last - 9.0) < 0.03 ? 0 : 1;  // k times 1 mm, and 2 um of skin
}
