// SPDX-License-Identifier: Apache-2.0
//
// What the haptic thread pays each tick beside rendering: exchange, impulse sums, safety, statistics, record.
#include <tegotae/model/intermediate_representation.hpp>
#include <tegotae/runtime/impulse_sums.hpp>
#include <tegotae/runtime/latest_value.hpp>
#include <tegotae/runtime/periodic_timer.hpp>
#include <tegotae/runtime/safety.hpp>
#include <tegotae/runtime/spsc_ring.hpp>
#include <tegotae/runtime/statistics.hpp>

#include <benchmark/benchmark.h>

#include <memory>

namespace tegotae {
namespace {

void latest_value_exchange(benchmark::State& state) {
  const auto exchange = std::make_unique<LatestValue<IntermediateRepresentation>>();
  while (state.KeepRunning()) {
    exchange->begin_write().sequence++;
    exchange->publish();
    benchmark::DoNotOptimize(exchange->update());
    benchmark::DoNotOptimize(exchange->get().sequence);
  }
}
BENCHMARK(latest_value_exchange);

void impulse_sums(benchmark::State& state) {
  const auto accumulator = std::make_unique<ImpulseAccumulator>();
  const auto exchange = std::make_unique<LatestValue<ImpulseSums>>();
  const int bodies = static_cast<int>(state.range(0));
  const Wrench wrench{Vector3(1.0, 2.0, 3.0), Vector3(0.1, 0.2, 0.3)};
  while (state.KeepRunning()) {
    accumulator->add(0, wrench, 1e-3);
    accumulator->fill(exchange->begin_write(), bodies);
    exchange->publish();
  }
}
BENCHMARK(impulse_sums)->Arg(4)->Arg(kMaxMovingBodies);

void safety(benchmark::State& state) {
  const SafetyLimits limits;
  SafetyState safety_state;
  SafetyInput input;
  input.elapsed = limits.period;
  // 1: within all limits; 100: rate limit and saturation work.
  input.target = {Vector3(static_cast<double>(state.range(0)), 0.5, 0.1), Vector3(0.1, 0.2, 0.3)};
  while (state.KeepRunning()) {
    benchmark::DoNotOptimize(input);
    benchmark::DoNotOptimize(apply_safety(limits, safety_state, input));
  }
}
BENCHMARK(safety)->Arg(1)->Arg(100);

void statistics(benchmark::State& state) {
  const auto tick_statistics = std::make_unique<TickStatistics>();
  double duration = 10e-6;
  while (state.KeepRunning()) {
    benchmark::DoNotOptimize(duration);
    tick_statistics->add(duration, 0.02);
  }
}
BENCHMARK(statistics);

struct Record {
  double numbers[48];
};

void record_ring(benchmark::State& state) {
  SpscRing<Record> ring(1024);
  Record record{};
  while (state.KeepRunning()) {
    benchmark::DoNotOptimize(record);
    ring.push(record);
    ring.pop(record);
  }
}
BENCHMARK(record_ring);

void monotonic_clock(benchmark::State& state) {
  while (state.KeepRunning()) benchmark::DoNotOptimize(monotonic_nanoseconds());
}
BENCHMARK(monotonic_clock);

}  // namespace
}  // namespace tegotae
