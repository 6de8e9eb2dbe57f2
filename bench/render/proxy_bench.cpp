// SPDX-License-Identifier: Apache-2.0
// A tick of the proxy method in contact, sliding and wobbling, with friction.
#include <tegotae/render/proxy_method.hpp>

#include <tests/random_shapes.hpp>
#include <tests/render/proxy_rig.hpp>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <ctime>

namespace tegotae {
namespace {

// s of processor time of this thread: other programs on the machine do not count.
double processor_time() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// A box-like hull with `count` vertices: what a scanned tool looks like, with faces of many corners to rest on.
Shape rounded_tool(int count) {
  std::mt19937_64 random(5);
  std::vector<Vector3> points;
  for (int i = 0; i < count; ++i) {
    const Vector3 u = test::random_unit(random);
    // A superellipsoid between ball and box: every point is a corner of the hull.
    const double radius = 0.03 / std::pow(u.array().abs().pow(4.0).sum(), 0.25);
    points.push_back(radius * u);
  }
  return make_hull(points);
}

Pose hand(const Pose& resting, double t) {
  Pose X_WT = resting;
  X_WT.p += Vector3(1e-3 * std::sin(7.0 * t), 3e-3 * std::sin(11.0 * t), -1.5e-3 + 5e-4 * std::sin(5.0 * t));
  X_WT.q =
      rotation_from_vector({0.05 * std::sin(9.0 * t), 0.04 * std::sin(6.0 * t), 0.05 * std::sin(8.0 * t)}) * X_WT.q;
  return X_WT;
}

void run(benchmark::State& state, test::ProxyRig& rig, const Pose& resting) {
  rig.parameters.friction = 0.5;
  Pose above = resting;
  above.p += Vector3(-0.002, 0.0, 0.02);
  rig.tick(above);
  std::vector<double> microseconds;
  double t = 0.0, rows = 0.0, linearisations = 0.0, touching = 0.0;
  for (auto _ : state) {
    const Pose X_WT = hand(resting, t);
    const double start = processor_time();
    rig.tick(X_WT);
    const double elapsed = processor_time() - start;
    state.SetIterationTime(elapsed);
    microseconds.push_back(1e6 * elapsed);
    rows += rig.output.constraint_count;
    linearisations += rig.output.linearisations;
    touching += rig.output.active_count > 0 ? 1.0 : 0.0;
    t += 1e-3;
  }
  std::sort(microseconds.begin(), microseconds.end());
  const auto n = static_cast<double>(microseconds.size());
  state.counters["median_us"] = microseconds[static_cast<size_t>(0.5 * n)];
  state.counters["p999_us"] = microseconds[static_cast<size_t>(0.999 * n)];
  state.counters["rows"] = rows / n;
  state.counters["linearisations"] = linearisations / n;
  state.counters["touching"] = touching / n;
}

void one_contact(benchmark::State& state) {
  test::ProxyRig rig({rounded_tool(static_cast<int>(state.range(0)))});
  rig.add_body(make_box({0.1, 0.1, 0.05}));
  run(state, rig, test::at(0.0, 0.0, 0.08));
}

// A floor and a wall.
void two_contacts(benchmark::State& state) {
  test::ProxyRig rig({rounded_tool(static_cast<int>(state.range(0)))});
  rig.add_body(make_box({0.1, 0.1, 0.05}));
  rig.add_body(make_box({0.05, 0.1, 0.1}), test::at(0.0795, 0.0, 0.1));
  run(state, rig, test::at(0.0, 0.0, 0.08));
}

// Faces of few corners.
void two_contacts_of_a_box(benchmark::State& state) {
  test::ProxyRig rig({make_box({0.03, 0.03, 0.03})});
  rig.add_body(make_box({0.1, 0.1, 0.05}));
  rig.add_body(make_box({0.05, 0.1, 0.1}), test::at(0.0795, 0.0, 0.1));
  run(state, rig, test::at(0.0, 0.0, 0.08));
}

BENCHMARK(two_contacts_of_a_box)->UseManualTime()->Iterations(20000);
BENCHMARK(one_contact)->Arg(230)->Arg(5000)->UseManualTime()->Iterations(20000);
BENCHMARK(two_contacts)->Arg(18)->Arg(230)->Arg(5000)->UseManualTime()->Iterations(20000);

}  // namespace
}  // namespace tegotae
