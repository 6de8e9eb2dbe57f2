// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/constraint_solver.hpp>

#include <benchmark/benchmark.h>
#include <tests/render/constraint_problems.hpp>

#include <algorithm>
#include <chrono>
#include <memory>
#include <vector>

// The six-unknown problem of a tick: contact rows of a tool on a floor and against a wall. No quadratic-programming
// solver of a permissive licence is packaged in Debian 12; the yardstick is projected Gauss-Seidel on the multipliers.
namespace tegotae {
namespace {

/// A tool whose vertices lie on a sphere, half of them on a flat end where `flat`, sliding over a floor at 1 kHz.
class MovingTool {
 public:
  static constexpr int kTicks = 64;

  MovingTool(int rows, bool flat) : rows_(rows), random_(7) {
    for (int i = 0; i < rows; ++i) {
      Vector3 r = 0.05 * random_.direction();
      if (flat) r.z() = std::max(r.z(), -0.045);
      if (!flat && i == 0) r = Vector3(0.0, 0.0, -0.05);
      if (flat && i < rows / 2) r.z() = -0.05;
      points_.push_back(r);
    }
  }

  /// Rows at tick t: the hand presses 1 mm deep and wobbles by some micrometres and tenths of milliradians a tick.
  void fill(int tick, ConstraintProblem<6>& problem) const {
    const double phase = 2.0 * 3.14159265358979 * tick / kTicks;
    Vector6 x_free;
    x_free << 2e-4 * std::sin(phase), 0.0, -1e-3 + 1e-4 * std::cos(phase), 1e-3 * std::sin(phase),
        1e-3 * std::cos(phase), 0.0;
    problem.set_objective(test::tool_metric(), x_free);
    const Vector3 tilt(1e-6 * std::cos(3.0 * phase), 1e-6 * std::sin(2.0 * phase), 0.0);
    for (int i = 0; i < rows_; ++i) {
      const Vector3 r = points_[i] + tilt.cross(points_[i]);
      // Gap to the floor z = -0.05, and for every eighth row to a wall at x = -0.05.
      const bool wall = i % 8 == 7;
      const double gap = wall ? r.x() + 0.05 : r.z() + 0.05;
      problem.add_contact(test::contact_row(wall ? Vector3::UnitX() : Vector3::UnitZ(), r), -gap, test::kCompliance);
    }
  }

 private:
  int rows_;
  test::RandomProblems random_;
  std::vector<Vector3> points_;
};

struct Ticks {
  Ticks(int rows, bool flat) {
    const MovingTool tool(rows, flat);
    for (int t = 0; t < MovingTool::kTicks; ++t) {
      problems.push_back(std::make_unique<ConstraintProblem<6>>(rows, 1));
      tool.fill(t, *problems.back());
    }
  }
  const ConstraintProblem<6>& operator[](int t) const { return *problems[t % MovingTool::kTicks]; }
  std::vector<std::unique_ptr<ConstraintProblem<6>>> problems;
};

/// The problem arrives by refilling one problem object, as in a tick, so its rows are in cache as far as they fit; the
/// time of filling is not counted.
void solve_ticks(benchmark::State& state, bool flat, bool warm) {
  const int rows = static_cast<int>(state.range(0));
  const Ticks ticks(rows, flat);
  ConstraintWorkspace<6> workspace(ticks[0]);
  ConstraintSolution<6> solution(ticks[0]);
  ConstraintProblem<6> problem(rows, 1);
  const ConstraintSolver<6> solver;
  int tick = 0;
  using Clock = std::chrono::steady_clock;
  double iterations = 0.0, line_search = 0.0, active = 0.0, worst = 0.0;
  while (state.KeepRunning()) {
    problem = ticks[tick++];
    const Vector6 x_start = solution.x;
    if (!warm) workspace.reset();
    const Clock::time_point begin = Clock::now();
    if (warm) {
      solver.solve(problem, x_start, workspace, solution);
    } else {
      solver.solve(problem, workspace, solution);
    }
    state.SetIterationTime(std::chrono::duration<double>(Clock::now() - begin).count());
    iterations += solution.newton_iterations;
    worst = std::max<double>(worst, solution.newton_iterations);
    line_search += solution.line_search_steps;
    active += static_cast<double>(solution.active_rows.size());
  }
  const double solves = static_cast<double>(state.iterations());
  state.counters["newton"] = iterations / solves;
  state.counters["newton_max"] = worst;
  state.counters["line_search"] = line_search / solves;
  state.counters["active"] = active / solves;
}

/// The yardstick: `kSweeps` sweeps of projected Gauss-Seidel on the multipliers, x carried along, warm from the last
/// tick. `force_error` is its greatest error of the resultant, relative.
void BM_GaussSeidelFlatWarm(benchmark::State& state) {
  constexpr int kSweeps = 100;
  const int rows = static_cast<int>(state.range(0));
  const Ticks ticks(rows, true);
  ConstraintWorkspace<6> workspace(ticks[0]);
  ConstraintSolution<6> exact(ticks[0]);
  std::vector<Vector6> pushed(rows);
  std::vector<double> own(rows), lambda(rows, 0.0);
  double error = 0.0;
  int tick = 0;
  while (state.KeepRunning()) {
    const ConstraintProblem<6>& problem = ticks[tick++];
    Vector6 x = problem.x_free();
    for (int i = 0; i < rows; ++i) {
      pushed[i] = problem.K_inverse() * problem.J(i);
      own[i] = problem.J(i).dot(pushed[i]) + problem.c(i);
      x += lambda[i] * pushed[i];
    }
    const auto begin = std::chrono::steady_clock::now();
    for (int sweep = 0; sweep < kSweeps; ++sweep)
      for (int i = 0; i < rows; ++i) {
        const double residual = problem.b(i) - problem.J(i).dot(x) - problem.c(i) * lambda[i];
        const double next = std::max(0.0, lambda[i] + residual / own[i]);
        x += (next - lambda[i]) * pushed[i];
        lambda[i] = next;
      }
    state.SetIterationTime(std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
    ConstraintSolver<6>().solve(problem, workspace, exact);
    const Vector6 force = problem.K() * (x - problem.x_free());
    error = std::max(error, (force - exact.force).norm() / exact.force.norm());
  }
  state.counters["force_error"] = error;
}

void BM_SolveRoundWarm(benchmark::State& state) { solve_ticks(state, false, true); }
void BM_SolveRoundCold(benchmark::State& state) { solve_ticks(state, false, false); }
void BM_SolveFlatWarm(benchmark::State& state) { solve_ticks(state, true, true); }
void BM_SolveFlatCold(benchmark::State& state) { solve_ticks(state, true, false); }
BENCHMARK(BM_GaussSeidelFlatWarm)->Arg(18)->Arg(230)->Arg(5000)->UseManualTime();
BENCHMARK(BM_SolveRoundWarm)->Arg(18)->Arg(230)->Arg(5000)->UseManualTime();
BENCHMARK(BM_SolveRoundCold)->Arg(18)->Arg(230)->Arg(5000)->UseManualTime();
BENCHMARK(BM_SolveFlatWarm)->Arg(18)->Arg(230)->Arg(5000)->UseManualTime();
BENCHMARK(BM_SolveFlatCold)->Arg(18)->Arg(230)->Arg(5000)->UseManualTime();

}  // namespace
}  // namespace tegotae
