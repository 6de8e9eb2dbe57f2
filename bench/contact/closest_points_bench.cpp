// SPDX-License-Identifier: Apache-2.0
// Closest points of a hull of V vertices and a box in coherent 1 kHz motion (0.1 m/s, 1 rad/s), and what FCL's libccd
// backend takes for the same poses. Medians: --benchmark_repetitions=9 --benchmark_report_aggregates_only=true
#include <tegotae/contact/closest_points.hpp>
#include <tegotae/contact/penetration.hpp>

#include <tests/contact/fcl_shapes.hpp>
#include <tests/random_shapes.hpp>

#include <benchmark/benchmark.h>

namespace tegotae {
namespace {

constexpr int kTicks = 4096;
const Vector3 kHalf(0.15, 0.1, 0.12);

// A hull of about 0.1 m that sways over and beside a box; poses of 4096 ticks, 1 ms apart.
struct Motion {
  Shape hull;
  Shape box = make_box(kHalf);
  std::vector<Pose> X_WT;

  // `height` of the hull's centre over the box's centre, m.
  Motion(int vertices, double height) {
    std::mt19937_64 random(5);
    hull = make_hull(test::random_hull_points(random, vertices, 0.1));
    Pose X = {{0.0, 0.0, height}, test::random_rotation(random)};
    for (int tick = 0; tick < kTicks; ++tick) {
      const double t = 1e-3 * tick;
      X.p = {0.1 * std::sin(t), 0.05 * std::sin(1.7 * t), height + 0.01 * std::sin(3.0 * t)};
      const Vector3 omega(std::sin(0.9 * t), std::cos(1.1 * t), 0.5 * std::sin(2.3 * t));
      X.q = (rotation_from_vector(Vector3(1e-3 * omega.normalized())) * X.q).normalized();
      X_WT.push_back(X);
    }
  }
};

const Motion& motion_of(int vertices) {
  static const Motion kSmall(18, 0.25), kMiddle(230, 0.25), kLarge(5000, 0.25);
  return vertices == 18 ? kSmall : vertices == 230 ? kMiddle : kLarge;
}

// Deep enough to overlap at every tick.
const Motion& overlapping_motion_of(int vertices) {
  static const Motion kSmall(18, 0.1), kMiddle(230, 0.1), kLarge(5000, 0.1);
  return vertices == 18 ? kSmall : vertices == 230 ? kMiddle : kLarge;
}

void closest_points_warm(benchmark::State& state) {
  const Motion& motion = motion_of(static_cast<int>(state.range(0)));
  const PlacedShape box(motion.box, Pose{});
  ClosestPointsCache cache;
  long iterations = 0, uncertified = 0, queries = 0;
  for (auto _ : state) {
    const PlacedShape tool(motion.hull, motion.X_WT[static_cast<size_t>(queries++ % kTicks)]);
    const ClosestPoints found = closest_points(tool, box, cache);
    iterations += found.iterations;
    uncertified += found.separation == Separation::kSeparated ? 0 : 1;
    benchmark::DoNotOptimize(found.distance);
  }
  state.counters["iterations"] = static_cast<double>(iterations) / static_cast<double>(queries);
  state.counters["uncertified"] = static_cast<double>(uncertified);
}
BENCHMARK(closest_points_warm)->Arg(18)->Arg(230)->Arg(5000);

void closest_points_cold(benchmark::State& state) {
  const Motion& motion = motion_of(static_cast<int>(state.range(0)));
  const PlacedShape box(motion.box, Pose{});
  long queries = 0;
  for (auto _ : state) {
    ClosestPointsCache cache;
    const PlacedShape tool(motion.hull, motion.X_WT[static_cast<size_t>(queries++ % kTicks)]);
    benchmark::DoNotOptimize(closest_points(tool, box, cache).distance);
  }
}
BENCHMARK(closest_points_cold)->Arg(18)->Arg(230)->Arg(5000);

void fcl_libccd(benchmark::State& state) {
  const Motion& motion = motion_of(static_cast<int>(state.range(0)));
  const auto hull = test::fcl_geometry(motion.hull);
  const auto box = test::fcl_geometry(motion.box);
  std::vector<fcl::Transform3d> poses;
  for (const Pose& X : motion.X_WT) poses.push_back(test::fcl_pose(X));
  const fcl::Transform3d identity = fcl::Transform3d::Identity();
  long queries = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(test::fcl_distance(*hull, poses[static_cast<size_t>(queries++ % kTicks)], *box, identity));
  }
}
BENCHMARK(fcl_libccd)->Arg(18)->Arg(230)->Arg(5000);

void penetration_global(benchmark::State& state) {
  const Motion& motion = overlapping_motion_of(static_cast<int>(state.range(0)));
  const PlacedShape box(motion.box, Pose{});
  ClosestPointsCache cache;
  long queries = 0;
  for (auto _ : state) {
    const PlacedShape tool(motion.hull, motion.X_WT[static_cast<size_t>(queries++ % kTicks)]);
    benchmark::DoNotOptimize(penetration(tool, box, cache).depth);
  }
}
BENCHMARK(penetration_global)->Arg(18)->Arg(230)->Arg(5000);

void penetration_local(benchmark::State& state) {
  const Motion& motion = overlapping_motion_of(static_cast<int>(state.range(0)));
  const PlacedShape box(motion.box, Pose{});
  ClosestPointsCache cache;
  Vector3 n = Vector3::UnitZ();
  long queries = 0;
  for (auto _ : state) {
    const PlacedShape tool(motion.hull, motion.X_WT[static_cast<size_t>(queries++ % kTicks)]);
    const Penetration found = penetration_from(tool, box, n, cache);
    n = found.n_W;
    benchmark::DoNotOptimize(found.depth);
  }
}
BENCHMARK(penetration_local)->Arg(18)->Arg(230)->Arg(5000);

}  // namespace
}  // namespace tegotae
