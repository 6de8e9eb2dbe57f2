// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/playback_interface.hpp>
#include <tegotae/math/rotation.hpp>
#include <tegotae/runtime/duration_histogram.hpp>
#include <tegotae/runtime/simulated_session.hpp>
#include <tegotae/world/mujoco_world.hpp>

#include <benchmark/benchmark.h>

#include <cmath>
#include <string>

// The whole haptic tick of the paper's method: model, interpolation, constraints, wrench, safety, shares of the bodies,
// record. The tools of the paper's section 6 pressed on a floor and rolled about, haptics at 1 kHz, physics at 20 Hz.
namespace tegotae {
namespace {

constexpr double kDuration = 20.0;  // s: twenty thousand ticks

// Pressed `depth` deep below the height at which the tool as placed in the scene touches, and swayed.
Trajectory press_and_roll(const Pose& X_WT, double touch_height, double depth) {
  std::vector<Trajectory::Sample> samples;
  for (int i = 0; i <= 2000; ++i) {
    const double t = 0.01 * i;
    const Vector3 sway(0.05 * std::sin(1.7 * t), 0.05 * std::sin(2.3 * t), 0.2 * t);
    Pose pose{
        {0.02 * std::sin(0.9 * t), 0.02 * std::cos(0.7 * t), touch_height - depth * (1.0 + 0.3 * std::sin(3.0 * t))},
        rotation_from_vector(sway) * X_WT.q};
    samples.push_back({t, pose});
  }
  return Trajectory(std::move(samples));
}

// Height of the tool's frame at which its lowest point, as the scene turns it, is at z = 0.
double touch_height(const Tool& tool) {
  double lowest = 0.0;
  for (const Shape& piece : tool.pieces) {
    const Vector3 down = piece.X_BS.q.conjugate() * (tool.X_WT.q.conjugate() * -Vector3::UnitZ());
    lowest = std::min(lowest, (tool.X_WT.q * (piece.X_BS * support(piece, down).p)).z());
  }
  return -lowest;
}

void haptic_tick(benchmark::State& state, const std::string& scene, ConstraintSet set) {
  DurationHistogram ticks;
  double contacts = 0.0, active = 0.0;
  for (auto unused : state) {
    static_cast<void>(unused);
    const auto world = load_mujoco_world(std::string(TEGOTAE_SCENES) + "/" + scene, "tool");
    const Tool& tool = world->geometry().tool;
    MethodSettings settings;
    settings.stiffness = 9000.0;
    settings.constraint_set = set;
    PhysicsLoop physics(*world, {0.05, 0.002}, ModelNeeds{});
    HapticTick haptics(make_method("paper", settings, world->geometry()), tool, SafetyLimits{}, 1e-3);
    PlaybackInterface hand(press_and_roll(tool.X_WT, touch_height(tool), 3e-4));
    double total = 0.0;
    run_simulated(physics, haptics, hand, 1e-3, kDuration, [&](const TickRecord& record) {
      ticks.add(1e-6 * record.tick_us);
      total += 1e-6 * record.tick_us;
      contacts = std::max(contacts, static_cast<double>(record.contact_points));
      active = std::max(active, static_cast<double>(record.active));
      return true;
    });
    state.SetIterationTime(total);
  }
  state.counters["ticks"] = static_cast<double>(ticks.count());
  state.counters["median_us"] = 1e6 * ticks.median();
  state.counters["p99_us"] = 1e6 * ticks.percentile(0.99);
  state.counters["p99.9_us"] = 1e6 * ticks.percentile(0.999);
  state.counters["max_us"] = 1e6 * ticks.max();
  state.counters["most_contact_points"] = contacts;
  state.counters["most_active"] = active;
}

// A scene and both constraint sets.
#define TEGOTAE_TICK_BENCHMARK(name, scene)                                                                      \
  BENCHMARK_CAPTURE(haptic_tick, name##_penetrating, scene, ConstraintSet::kPenetratingPoints)->UseManualTime(); \
  BENCHMARK_CAPTURE(haptic_tick, name##_near, scene, ConstraintSet::kNearPoints)->UseManualTime()

TEGOTAE_TICK_BENCHMARK(18_vertices, "tool-18.xml");
TEGOTAE_TICK_BENCHMARK(230_round, "tool-230-round.xml");
TEGOTAE_TICK_BENCHMARK(230_flat, "tool-230-flat.xml");

}  // namespace
}  // namespace tegotae
