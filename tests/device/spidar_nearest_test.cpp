// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/spidar_nearest.hpp>
#include <tegotae/device/spidar_presets.hpp>
#include <tegotae/device/spidar_tensions.hpp>
#include <tegotae/lab/quadratic_program.hpp>

#include <tests/allocation_counter.hpp>
#include <tests/device/spidar_poses.hpp>
#include <tests/sweep_size.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace tegotae {
namespace {

struct Case {
  SpidarWrenchMatrix W;
  SpidarVector min, max;
  double radius;

  Case(const SpidarGeometry& geometry, const Pose& X_SG)
      : W(spidar_strings(geometry, X_SG).wrenches),
        min(min_tensions(geometry)),
        max(max_tensions(geometry)),
        radius(knot_radius(geometry)) {}

  /// |W t - s w|, torques in newtons at the knots' radius.
  double stray(const SpidarVector& t, double s, const Wrench& wrench) const {
    Vector6 w;
    w << wrench.force, wrench.torque;
    Vector6 off = W * t - s * w;
    off.tail<3>() /= radius;
    return off.norm();
  }

  /// The least stray wrench, by an interior-point method in nine unknowns of 10 N.
  double least_stray(const Wrench& wrench) const {
    constexpr double kUnit = 10.0;
    Eigen::MatrixXd A(6, 9);
    A.leftCols(8) = kUnit * W;
    A.col(8) << -wrench.force, -wrench.torque;
    A.bottomRows(3) /= radius;
    A /= kUnit;
    QuadraticProgram program;
    program.H = A.transpose() * A;
    program.g = Eigen::VectorXd::Zero(9);
    InequalityGroup group;
    group.A = Eigen::MatrixXd::Zero(18, 9);
    group.A.topRows(9).setIdentity();
    group.A.bottomRows(9) = -Eigen::MatrixXd::Identity(9, 9);
    group.b.resize(18);
    group.b << min / kUnit, 0.0, -max / kUnit, -1.0;
    for (int i = 0; i < 9; ++i) group.columns.push_back(i);
    program.groups = {group};
    const QuadraticSolution solution = solve(program);
    if (!solution.converged) ADD_FAILURE() << "the oracle did not converge";
    return stray(kUnit * solution.y.head(8), solution.y[8], wrench);
  }
};

TEST(SpidarNearest, LeavesNoMoreStrayWrenchThanAnotherSolver) {
  test::SpidarPoses random(41);
  int cases = 0, most_steps = 0;
  double most = 0.0;
  for (int k = 0; k < test::sweep_size(6000); ++k) {
    const Case problem(spidar_preset(k % 2 == 0 ? "x3r" : "x4r").geometry, random.pose(0.025, 0.7));
    const Wrench wrench = k % 5 == 0 ? Wrench{} : random.wrench(10.0, 0.2);
    if (spidar_tensions(problem.W, problem.radius, problem.min, problem.max, wrench).display !=
        SpidarDisplay::kNearest) {
      continue;
    }
    ++cases;
    const SpidarNearest result = nearest_tensions(problem.W, problem.radius, problem.min, problem.max, wrench);
    ASSERT_TRUE((result.tensions.array() >= problem.min.array()).all());
    ASSERT_TRUE((result.tensions.array() <= problem.max.array()).all());
    ASSERT_GE(result.scale, 0.0);
    ASSERT_LE(result.scale, 1.0);
    const double stray = problem.stray(result.tensions, result.scale, wrench);
    EXPECT_LE(stray, problem.least_stray(wrench) + 2e-4) << k;
    EXPECT_LE(result.steps, 40) << k;
    most = std::max(most, stray);
    most_steps = std::max(most_steps, result.steps);
  }
  EXPECT_GT(cases, test::sweep_size(6000) / 20);
  RecordProperty("most_steps", most_steps);
  std::printf("%d poses where nothing is reachable: at most %d steps, stray wrench up to %.2f N\n", cases, most_steps,
              most);
}

TEST(SpidarNearest, GoesOnWithoutAJumpWhereReachEnds) {
  // The greatest part in the exact direction may end steeply, so the border itself is sought out.
  test::SpidarPoses random(42);
  int borders = 0;
  double worst = 0.0;
  for (int path = 0; path < test::sweep_size(1000); ++path) {
    const Pose goal = random.pose(0.03, 0.9);
    const Wrench wrench = random.wrench(5.0, 0.1);
    const auto display_at = [&](double way) {
      const Case problem(spidar_preset("x3r").geometry, interpolate({}, goal, way));
      return spidar_tensions(problem.W, problem.radius, problem.min, problem.max, wrench);
    };
    double reached = 0.0, beyond = 1.0;
    if (display_at(beyond).display != SpidarDisplay::kNearest) continue;
    for (int halving = 0; halving < 45; ++halving) {
      const double middle = 0.5 * (reached + beyond);
      (display_at(middle).display == SpidarDisplay::kNearest ? beyond : reached) = middle;
    }
    ++borders;
    const Wrench jump = display_at(beyond).displayed - display_at(reached).displayed;
    worst = std::max({worst, jump.force.norm(), jump.torque.norm() / 0.0225});
  }
  EXPECT_GT(borders, test::sweep_size(1000) / 10);
  EXPECT_LT(worst, 0.04);  // N: what a hand does not feel
  std::printf("%d borders: greatest jump %.1e N\n", borders, worst);
}

TEST(SpidarNearest, OfAReachableWrenchIsTheWrench) {
  const Case problem(spidar_preset("x3r").geometry, {});
  const Wrench wrench{{2.0, 1.0, -3.0}, {0.02, 0.0, 0.05}};
  const SpidarNearest result = nearest_tensions(problem.W, problem.radius, problem.min, problem.max, wrench);
  EXPECT_LT(problem.stray(result.tensions, result.scale, wrench), 1e-4);
  EXPECT_NEAR(result.scale, 1.0, 0.01);  // weighed against small tensions
}

TEST(SpidarNearest, AllocatesNothing) {
  const Case problem(spidar_preset("x3r").geometry, {{0.02, 0.02, 0.02}, rotation_from_vector({0.5, 0.3, 0.0})});
  const test::AllocationCounter counter;
  EXPECT_GT(nearest_tensions(problem.W, problem.radius, problem.min, problem.max, {}).steps, 0);
  EXPECT_EQ(counter.count(), 0U);
}

}  // namespace
}  // namespace tegotae
