// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/spidar_kinematics.hpp>
#include <tegotae/device/spidar_presets.hpp>
#include <tegotae/device/spidar_tensions.hpp>
#include <tegotae/runtime/duration_histogram.hpp>

#include <tests/device/spidar_poses.hpp>

#include <benchmark/benchmark.h>

#include <chrono>
#include <cmath>
#include <cstddef>
#include <string>
#include <vector>

// What a SPIDAR's driver computes a tick: the pose from eight rounded lengths, warm from the last, then the strings at
// it and their tensions. A grip that sways over +-20 mm and +-30 degrees in seconds, under wrenches in reach or out of
// it.
namespace tegotae {
namespace {

struct Tick {
  SpidarVector lengths;
  Wrench wrench;
};

std::vector<Tick> ticks_of(const SpidarGeometry& geometry, double force, double torque) {
  const SpidarVector at_centre = spidar_strings(geometry, {}).lengths;
  test::SpidarPoses random(1);
  std::vector<Tick> ticks;
  for (int k = 0; k < 20000; ++k) {
    const double t = 1e-3 * k;
    const Vector3 p(std::sin(2.1 * t), std::sin(3.3 * t + 1.0), std::sin(1.7 * t + 2.0));
    const Vector3 turn(std::sin(1.3 * t), std::sin(2.9 * t + 0.5), std::sin(2.3 * t + 1.5));
    const Pose X_SG{0.02 * p, rotation_from_vector(0.3 * turn)};
    Tick tick{spidar_strings(geometry, X_SG).lengths, random.wrench(force, torque)};
    for (int i = 0; i < kSpidarStrings; ++i) {
      const double pulse = geometry.strings[static_cast<std::size_t>(i)].metres_per_pulse;
      tick.lengths[i] = at_centre[i] + pulse * std::round((tick.lengths[i] - at_centre[i]) / pulse);
    }
    ticks.push_back(tick);
  }
  return ticks;
}

void kinematics_and_tensions(benchmark::State& state, const std::string& name, double force, double torque) {
  const SpidarGeometry& geometry = spidar_preset(name).geometry;
  const std::vector<Tick> ticks = ticks_of(geometry, force, torque);
  const SpidarVector min = min_tensions(geometry), max = max_tensions(geometry);
  const double radius = knot_radius(geometry);
  DurationHistogram times;
  std::size_t k = 0, steps = 0, exact = 0;
  SpidarPose pose;
  for (auto unused : state) {
    static_cast<void>(unused);
    const Tick& tick = ticks[k++ % ticks.size()];
    const auto begin = std::chrono::steady_clock::now();
    pose = spidar_pose(geometry, tick.lengths, pose.X_SG);
    const SpidarStrings strings = spidar_strings(geometry, pose.X_SG);
    const SpidarTensions tensions = spidar_tensions(strings.wrenches, radius, min, max, tick.wrench);
    const std::chrono::duration<double> time = std::chrono::steady_clock::now() - begin;
    benchmark::DoNotOptimize(tensions.tensions.data());
    times.add(time.count());
    steps += static_cast<std::size_t>(pose.steps);
    exact += tensions.display == SpidarDisplay::kExact ? 1 : 0;
  }
  state.counters["median_us"] = 1e6 * times.median();
  state.counters["p99_us"] = 1e6 * times.percentile(0.99);
  state.counters["max_us"] = 1e6 * times.max();
  state.counters["steps"] = static_cast<double>(steps) / static_cast<double>(k);
  state.counters["exact"] = static_cast<double>(exact) / static_cast<double>(k);
}

BENCHMARK_CAPTURE(kinematics_and_tensions, x3r_in_reach, "x3r", 3.0, 0.05)->Iterations(100000);
BENCHMARK_CAPTURE(kinematics_and_tensions, x3r_out_of_reach, "x3r", 100.0, 2.0)->Iterations(100000);
BENCHMARK_CAPTURE(kinematics_and_tensions, x4r_in_reach, "x4r", 3.0, 0.05)->Iterations(100000);

}  // namespace
}  // namespace tegotae
