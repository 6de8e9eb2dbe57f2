// SPDX-License-Identifier: Apache-2.0
#include <tegotae/contact/interior_point.hpp>
#include <tegotae/contact/intersection.hpp>

#include <tests/random_shapes.hpp>

#include <benchmark/benchmark.h>

#include <vector>

namespace tegotae {
namespace {

Shape round_hull(std::uint64_t seed, int vertices) {
  std::mt19937_64 random(seed);
  std::vector<Vector3> points;
  for (int i = 0; i < vertices; ++i) points.push_back(0.1 * test::random_unit(random));
  return make_hull(points);
}

// Poses that a hand runs through at 1 kHz: coherent, every one another one.
struct Scene {
  Shape tool, object;
  std::vector<PlacedShape> tools;
  PlacedShape placed_object;
  Vector3 dilation = Vector3::Zero();
  ClipWorkspace workspace;
  std::vector<IntersectionVertex> vertices;
  std::vector<Vector3> origins;

  Scene(const Shape& the_tool, const Shape& the_object, const Vector3& start, const Vector3& dilation_W)
      : tool(the_tool), object(the_object), dilation(dilation_W), workspace(1024, 2048), vertices(8192) {
    placed_object = PlacedShape(object, {});
    std::mt19937_64 random(7);
    Pose X{start, test::random_rotation(random)};
    for (int i = 0; i < 256; ++i) {
      X = displaced(X, X.p, 2e-4 * test::random_unit(random), 4e-3 * test::random_unit(random));
      tools.emplace_back(tool, X);
      origins.push_back(interior_point(tools.back(), placed_object, dilation).p_W);
    }
  }
};

// Sizes: vertices of the tool, of the object (0: a box); how deep the tool is sunk in, mm; dilation, mm.
Scene make_scene(const benchmark::State& state) {
  const auto tool_vertices = static_cast<int>(state.range(0)), object_vertices = static_cast<int>(state.range(1));
  const Shape object = object_vertices == 0 ? make_box({0.1, 0.1, 0.1}) : round_hull(2, object_vertices);
  const double depth = 1e-3 * static_cast<double>(state.range(2)),
               dilation = 1e-3 * static_cast<double>(state.range(3));
  return {round_hull(1, tool_vertices), object, {0.01, 0.02, 0.2 - depth}, {0.0, 0.0, dilation}};
}

void clip_form(benchmark::State& state) {
  Scene scene = make_scene(state);
  size_t i = 0;
  int count = 0;
  for (auto _ : state) {
    count = intersection_by_clipping(scene.tools[i++ % scene.tools.size()], scene.placed_object, scene.dilation,
                                     scene.workspace, scene.vertices);
    benchmark::DoNotOptimize(scene.vertices.data());
  }
  state.counters["vertices"] = count;
}

void dual_form_qhull(benchmark::State& state) {
  Scene scene = make_scene(state);
  size_t i = 0;
  std::vector<IntersectionVertex> vertices;
  for (auto _ : state) {
    vertices.clear();
    const size_t k = i++ % scene.tools.size();
    intersection_by_duality(scene.tools[k], scene.placed_object, scene.dilation, scene.origins[k], vertices);
    benchmark::DoNotOptimize(vertices.data());
  }
  state.counters["vertices"] = static_cast<double>(vertices.size());
}

void interior_point_of_both(benchmark::State& state) {
  const Scene scene = make_scene(state);
  size_t i = 0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(
        interior_point(scene.tools[i++ % scene.tools.size()], scene.placed_object, scene.dilation));
  }
}

void sizes(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgNames({"tool", "object", "depth_mm", "dilation_mm"});
  for (const int depth : {2, 20, 100}) {
    benchmark->Args({18, 0, depth, 0})->Args({230, 0, depth, 0})->Args({1000, 1000, depth, 0});
  }
  benchmark->Args({230, 0, -2, 5})->Args({18, 230, -2, 5})->Args({230, 230, -2, 5})->Args({1000, 1000, -2, 5});
  benchmark->Unit(benchmark::kMicrosecond);
}

BENCHMARK(clip_form)->Apply(sizes);
BENCHMARK(dual_form_qhull)->Apply(sizes);
BENCHMARK(interior_point_of_both)->Apply(sizes);

}  // namespace
}  // namespace tegotae
