// SPDX-License-Identifier: Apache-2.0
#include <tegotae/contact/sweep_and_prune.hpp>

#include <tests/random_shapes.hpp>

#include <benchmark/benchmark.h>

#include <vector>

namespace tegotae {
namespace {

BoundingBox box_at(const Vector3& centre, double half) { return {centre.array() - half, centre.array() + half}; }

// One step: 100 moving boxes get new bounds, then the tool asks. Bodies of 0.1 m in a room of 10 m; every one moves by
// about 5 mm a step. With `leaps` the tool is somewhere else at every step: nothing is coherent.
void update_and_query(benchmark::State& state, bool leaps) {
  std::mt19937_64 random(8);
  SweepAndPrune pruner;
  for (int i = 0; i < state.range(0); ++i) pruner.add_static(box_at(test::random_vector(random, 5.0), 0.05));
  std::vector<Vector3> centres;
  std::vector<int> handles;
  for (int i = 0; i < state.range(1); ++i) {
    centres.push_back(test::random_vector(random, 5.0));
    handles.push_back(pruner.add_moving(box_at(centres.back(), 0.05)));
  }
  Vector3 tool = Vector3::Zero();
  pruner.candidates(box_at(tool, 0.2));
  size_t found = 0, steps = 0;
  for (auto _ : state) {
    state.PauseTiming();
    for (Vector3& centre : centres) centre += 0.005 * test::random_unit(random);
    tool = leaps ? test::random_vector(random, 4.0) : Vector3(tool + 0.005 * test::random_unit(random));
    state.ResumeTiming();
    for (size_t i = 0; i < handles.size(); ++i) pruner.update(handles[i], box_at(centres[i], 0.05));
    found += pruner.candidates(box_at(tool, 0.2)).size();
    ++steps;
  }
  state.counters["candidates"] = static_cast<double>(found) / static_cast<double>(steps);
}

void coherent(benchmark::State& state) { update_and_query(state, false); }
void leaping(benchmark::State& state) { update_and_query(state, true); }

BENCHMARK(coherent)->Args({10000, 100})->ArgNames({"static", "moving"})->Unit(benchmark::kMicrosecond);
BENCHMARK(leaping)->Args({10000, 100})->ArgNames({"static", "moving"})->Unit(benchmark::kMicrosecond);

}  // namespace
}  // namespace tegotae
