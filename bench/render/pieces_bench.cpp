// SPDX-License-Identifier: Apache-2.0
// A body of 200 pieces and a tool of 10: the tick of the proxy method, and the search for near pieces.
#include <tegotae/model/near_pieces.hpp>
#include <tegotae/render/proxy_method.hpp>

#include <tests/torus_pieces.hpp>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>
#include <memory>

namespace tegotae {
namespace {

constexpr double kPeriod = 1e-3;       // s, of the tick
constexpr int kTicksOfPhysics = 50;    // 20 Hz
constexpr double kStiffness = 9000.0;  // N/m
constexpr double kFastestTool = 0.1;   // m/s, that the search expects

double processor_time() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

SceneGeometry comb_and_torus(bool moves) {
  SceneGeometry scene;
  scene.tool.pieces = test::comb_pieces(10);
  std::vector<MassProperties> parts;
  for (const Shape& piece : scene.tool.pieces) parts.push_back(mass_properties(piece, 1000.0));
  scene.tool.mass = combined(parts);
  Body body;
  body.pieces = test::torus_pieces(25, 8);
  if (moves) body.moving_index = scene.moving_count++;
  scene.bodies.push_back(body);
  return scene;
}

// The comb is drawn over the torus, pressed 1.5 mm into it, and turned.
Pose hand(double t) {
  const double turn = 0.5 * std::sin(0.7 * t);
  const Vector3 p(0.01 * std::sin(1.3 * t), test::kTorusRadius + 0.01 * std::sin(1.9 * t),
                  test::kTorusTube + 0.008 - 1.5e-3 + 5e-4 * std::sin(5.0 * t));
  return {p, rotation_from_vector({0.05 * std::sin(2.0 * t), 0.05 * std::sin(3.0 * t), turn})};
}

Pose swayed(double t) {
  return {{0.003 * std::sin(3.0 * t), 0.002 * std::sin(4.0 * t), 0.0},
          rotation_from_vector({0.0, 0.0, 0.05 * std::sin(2.0 * t)})};
}

// Physics at 20 Hz as the haptic rate sees it.
class Rig {
 public:
  explicit Rig(bool moves) : moves_(moves), scene_(comb_and_torus(moves)), search_(scene_), states_(moves ? 1 : 0) {}

  const SceneGeometry& scene() const { return scene_; }

  double find(double t, const Pose& X_WP, double horizon) {
    if (moves_) states_[0].X_WB = swayed(t);
    const double start = processor_time();
    const auto pairs = search_.find(X_WP, states_, {0.004, horizon, kFastestTool});
    name_near_pieces(scene_, pairs, states_, *model);
    const double elapsed = processor_time() - start;
    ++model->sequence;
    return elapsed;
  }

  void move_bodies(double t) {
    for (int i = 0; i < model->body_count; ++i) model->bodies[static_cast<size_t>(i)].X_WB = swayed(t);
  }

  std::unique_ptr<IntermediateRepresentation> model = std::make_unique<IntermediateRepresentation>();

 private:
  bool moves_;
  SceneGeometry scene_;
  NearObjectSearch search_;
  std::vector<BodyState> states_;
};

void report(benchmark::State& state, std::vector<double>& microseconds) {
  std::sort(microseconds.begin(), microseconds.end());
  const auto n = static_cast<double>(microseconds.size());
  state.counters["median_us"] = microseconds[static_cast<size_t>(0.5 * n)];
  state.counters["p99_us"] = microseconds[static_cast<size_t>(0.99 * n)];
  state.counters["p999_us"] = microseconds[static_cast<size_t>(0.999 * n)];
}

// Arguments: whether the torus moves, milliseconds of motion that the search reckons with.
void tick_of_many_pieces(benchmark::State& state) {
  Rig rig(state.range(0) != 0);
  const double horizon = 1e-3 * static_cast<double>(state.range(1));
  ProxyMethod::Parameters parameters;
  parameters.coupling = {kStiffness, 0.0, rig.scene().tool.mass.gyration_length()};
  parameters.friction = 0.5;
  ProxyMethod method(parameters, rig.scene());
  RenderOutput output;
  output.X_WP = {{0.0, test::kTorusRadius, 0.05}, Quaternion::Identity()};
  std::vector<double> microseconds;
  double pairs = 0.0, dropped = 0.0, skipped = 0.0, rows = 0.0, linearisations = 0.0, touching = 0.0;
  int tick = 0;
  for (auto _ : state) {
    const double t = kPeriod * tick;
    if (tick % kTicksOfPhysics == 0) rig.find(t, output.X_WP, horizon);
    rig.move_bodies(t);
    const double start = processor_time();
    method.render({*rig.model, tick == 0 ? output.X_WP : hand(t), kPeriod}, output);
    const double elapsed = processor_time() - start;
    state.SetIterationTime(elapsed);
    microseconds.push_back(1e6 * elapsed);
    pairs += rig.model->pair_count;
    dropped += rig.model->dropped_pairs;
    skipped += output.skipped_pairs;
    rows += output.constraint_count;
    linearisations += output.linearisations;
    touching += output.active_count > 0 ? 1.0 : 0.0;
    ++tick;
  }
  report(state, microseconds);
  const double n = tick;
  state.counters["pairs"] = pairs / n;
  state.counters["dropped"] = dropped / n;
  state.counters["skipped"] = skipped / n;
  state.counters["rows"] = rows / n;
  state.counters["linearisations"] = linearisations / n;
  state.counters["touching"] = touching / n;
}

void search_of_many_pieces(benchmark::State& state) {
  Rig rig(state.range(0) != 0);
  const double horizon = 1e-3 * static_cast<double>(state.range(1));
  std::vector<double> microseconds;
  double pairs = 0.0, t = 0.0;
  for (auto _ : state) {
    Pose X_WP = hand(t);
    X_WP.p.z() += 1.5e-3;
    const double elapsed = rig.find(t, X_WP, horizon);
    state.SetIterationTime(elapsed);
    microseconds.push_back(1e6 * elapsed);
    pairs += rig.model->pair_count + rig.model->dropped_pairs;
    t += 0.5 * horizon;
  }
  report(state, microseconds);
  state.counters["pairs"] = pairs / static_cast<double>(microseconds.size());
}

void arguments(benchmark::internal::Benchmark* benchmark) {
  for (const int moves : {0, 1}) {
    for (const int horizon : {4, 100, 1000}) benchmark->Args({moves, horizon});
  }
}

BENCHMARK(tick_of_many_pieces)->Apply(arguments)->UseManualTime()->Iterations(10000);
BENCHMARK(search_of_many_pieces)->Apply(arguments)->UseManualTime()->Iterations(500);

}  // namespace
}  // namespace tegotae
