// SPDX-License-Identifier: Apache-2.0
#include <tegotae/math/rotation.hpp>
#include <tegotae/runtime/duration_histogram.hpp>
#include <tegotae/runtime/periodic_timer.hpp>
#include <tegotae/runtime/physics_loop.hpp>

#include <benchmark/benchmark.h>
#include <tests/free_body_world.hpp>
#include <tests/random_shapes.hpp>

#include <cmath>
#include <memory>

// What the physics side adds to the engine's own step: near objects and the intermediate representation, for one tool
// among 10,000 static and 100 moving bodies.
namespace tegotae {
namespace {

SceneGeometry crowd(int static_count, int moving_count) {
  std::mt19937_64 random(5);
  SceneGeometry scene;
  scene.tool.pieces = {make_hull(test::random_hull_points(random, 230, 0.1))};
  scene.tool.mass = mass_properties(scene.tool.pieces[0], 1000.0);
  for (int i = 0; i < static_count + moving_count; ++i) {
    Body body;
    body.pieces = {i % 3 == 0 ? make_hull(test::random_hull_points(random, 18, 0.05))
                              : make_box(Vector3(0.02, 0.03, 0.04))};
    body.X_WB = test::random_pose(random, 1.5);
    if (i >= static_count) body.moving_index = i - static_count;
    scene.bodies.push_back(std::move(body));
  }
  scene.moving_count = moving_count;
  return scene;
}

void physics_build(benchmark::State& state) {
  test::FreeBodyWorld world(crowd(static_cast<int>(state.range(0)), static_cast<int>(state.range(1))));
  PhysicsLoop physics(world, {0.05, 0.002}, ModelNeeds{});
  const auto model = std::make_unique<IntermediateRepresentation>();
  DurationHistogram steps;
  double planes = 0.0, points = 0.0;
  int step = 0;
  for (auto unused : state) {
    static_cast<void>(unused);
    const double t = 0.05 * ++step;
    for (int i = 0; i < world.geometry().moving_count; ++i) {
      world.body(i).X_WB.p += Vector3(0.002 * std::sin(t + i), 0.002 * std::cos(t + i), 0.0);
    }
    const ToolState tool{
        {{std::sin(0.3 * t), std::sin(0.37 * t), std::sin(0.41 * t)}, rotation_from_vector({0.3 * t, 0.0, 0.0})},
        {Vector3(0.1, 0.1, 0.1), Vector3(0.3, 0.0, 0.0)}};
    const std::int64_t start = monotonic_nanoseconds();
    physics.build(t, tool, *model);
    const double duration = seconds_between(start, monotonic_nanoseconds());
    steps.add(duration);
    state.SetIterationTime(duration);
    planes = std::max(planes, static_cast<double>(model->plane_count));
    points = std::max(points, static_cast<double>(model->point_count));
  }
  state.counters["median_us"] = 1e6 * steps.median();
  state.counters["p99_us"] = 1e6 * steps.percentile(0.99);
  state.counters["max_us"] = 1e6 * steps.max();
  state.counters["most_planes"] = planes;
  state.counters["most_points"] = points;
}
BENCHMARK(physics_build)->Args({0, 0})->Args({10000, 100})->UseManualTime()->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace tegotae
