// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/spidar_presets.hpp>
#include <tegotae/device/spidar_tensions.hpp>
#include <tegotae/lab/quadratic_program.hpp>

#include <tests/allocation_counter.hpp>
#include <tests/device/spidar_poses.hpp>
#include <tests/sweep_size.hpp>

#include <gtest/gtest.h>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>

namespace tegotae {
namespace {

using test::SpidarPoses;

constexpr double kFrameTurn = 0.52;  // rad, 30 degrees

struct TensionCase {
  SpidarWrenchMatrix W;
  SpidarVector min, max;
  double radius;

  TensionCase(const SpidarGeometry& geometry, const Pose& X_SG)
      : W(spidar_strings(geometry, X_SG).wrenches),
        min(min_tensions(geometry)),
        max(max_tensions(geometry)),
        radius(knot_radius(geometry)) {}
  SpidarTensions solve(const Wrench& wrench) const { return spidar_tensions(W, radius, min, max, wrench); }
};

double difference(const Wrench& a, const Wrench& b) {
  return std::max((a.force - b.force).norm(), (a.torque - b.torque).norm());
}

/// How far t is from the conditions of Karush, Kuhn and Tucker for min |t - min|^2 among those that display W t within
/// the limits: t - min = W^T y between the limits, less at a least tension, more at a greatest. N.
double kkt_residual(const TensionCase& problem, const SpidarVector& t) {
  constexpr double kAtLimit = 1e-9;  // N
  const SpidarVector spread = t - problem.min;
  Eigen::MatrixXd free(0, 6);
  Eigen::VectorXd right(0);
  for (int i = 0; i < kSpidarStrings; ++i) {
    if (t[i] < problem.min[i] + kAtLimit || t[i] > problem.max[i] - kAtLimit) continue;
    free.conservativeResize(free.rows() + 1, Eigen::NoChange);
    right.conservativeResize(free.rows());
    free.bottomRows(1) = problem.W.col(i).transpose();
    right[free.rows() - 1] = spread[i];
  }
  if (free.rows() < 6) return std::numeric_limits<double>::infinity();
  free.rightCols(3) /= problem.radius;
  Eigen::VectorXd y = free.colPivHouseholderQr().solve(right);
  double residual = (free * y - right).cwiseAbs().maxCoeff();
  y.tail(3) /= problem.radius;
  const SpidarVector pull = problem.W.transpose() * y;
  for (int i = 0; i < kSpidarStrings; ++i) {
    if (t[i] < problem.min[i] + kAtLimit) residual = std::max(residual, pull[i]);
    if (t[i] > problem.max[i] - kAtLimit) residual = std::max(residual, spread[i] - pull[i]);
  }
  return residual;
}

/// The greatest s with s w reachable, by an interior-point method in the plane of z and s; negative where none is.
double greatest_scale(const TensionCase& problem, const Wrench& wrench) {
  const Eigen::MatrixXd W = problem.W;
  const Eigen::JacobiSVD<Eigen::MatrixXd> svd(W, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Eigen::VectorXd w(6);
  w << wrench.force, wrench.torque;
  Eigen::MatrixXd map(8, 3);
  map << svd.matrixV().rightCols(2), svd.solve(w);
  // Unknowns z, s and the worst breach v: maximise s - 1e3 v, v >= 0; all of order 1 for tensions over 10 N.
  constexpr double kUnit = 10.0, kPrice = 1e3;
  QuadraticProgram program;
  program.H = Eigen::MatrixXd::Zero(4, 4);
  program.g = Eigen::VectorXd::Zero(4);
  program.g[2] = -1.0;
  program.g[3] = kPrice;
  InequalityGroup group;
  group.columns = {0, 1, 2, 3};
  group.A = Eigen::MatrixXd::Zero(19, 4);
  group.b = Eigen::VectorXd::Zero(19);
  group.A.block(0, 0, 8, 2) = map.leftCols(2);
  group.A.block(0, 2, 8, 1) = map.col(2) / kUnit;
  group.A.block(8, 0, 8, 3) = -group.A.block(0, 0, 8, 3);
  group.A.block(0, 3, 16, 1).setOnes();
  group.b.head(8) = problem.min / kUnit;
  group.b.segment(8, 8) = -problem.max / kUnit;
  group.A(16, 2) = 1.0;
  group.A(17, 2) = -1.0;
  group.b[17] = -1.0;
  group.A(18, 3) = 1.0;
  program.groups = {group};
  const QuadraticSolution solution = solve(program);
  if (!solution.converged) ADD_FAILURE() << "the oracle did not converge";
  return solution.y[3] > 1e-7 ? -1.0 : solution.y[2];
}

TEST(SpidarTensions, DisplayAReachableWrenchExactlyWithTheLeastSpread) {
  SpidarPoses random(11);
  for (const char* name : {"x3r", "x3l", "x4r"}) {
    double worst = 0.0, worst_kkt = 0.0;
    int exact = 0;
    for (int k = 0; k < test::sweep_size(20000); ++k) {
      const TensionCase problem(spidar_preset(name).geometry, random.pose(0.02, kFrameTurn));
      const Wrench wrench = random.wrench(10.0, 0.2);
      const SpidarTensions result = problem.solve(wrench);
      ASSERT_TRUE((result.tensions.array() >= problem.min.array()).all());
      ASSERT_TRUE((result.tensions.array() <= problem.max.array()).all());
      if (result.display != SpidarDisplay::kExact) continue;
      ++exact;
      EXPECT_EQ(result.scale, 1.0);
      worst = std::max({worst, difference(result.displayed, wrench), difference(result.shortfall, {})});
      worst_kkt = std::max(worst_kkt, kkt_residual(problem, result.tensions));
    }
    EXPECT_GT(exact, test::sweep_size(20000) / 3) << name;
    EXPECT_LT(worst, 1e-6) << name;
    EXPECT_LT(worst_kkt, 1e-6) << name;
    std::printf("%s: %d reachable wrenches, displayed within %.1e, KKT within %.1e N\n", name, exact, worst, worst_kkt);
  }
}

TEST(SpidarTensions, ScaleIsTheGreatestThatAnotherSolverFinds) {
  SpidarPoses random(12);
  int scaled = 0, none = 0;
  for (int k = 0; k < test::sweep_size(3000); ++k) {
    const TensionCase problem(spidar_preset(k % 2 == 0 ? "x3r" : "x4r").geometry, random.pose(0.02, kFrameTurn));
    const Wrench wrench = random.wrench(60.0, 1.0);
    const SpidarTensions result = problem.solve(wrench);
    const double oracle = greatest_scale(problem, wrench);
    if (result.display == SpidarDisplay::kNearest) {
      ++none;
      EXPECT_EQ(oracle, -1.0) << k;
      continue;
    }
    if (result.display == SpidarDisplay::kScaled) ++scaled;
    EXPECT_NEAR(result.scale, oracle, 1e-5) << k;
    EXPECT_LT(difference(result.displayed, wrench * result.scale), 1e-6) << k;
    EXPECT_LT(difference(result.displayed + result.shortfall, wrench), 1e-12) << k;
  }
  EXPECT_GT(scaled, test::sweep_size(3000) / 4);
  EXPECT_GT(none, 0);
}

TEST(SpidarTensions, AtTheCentreNoWrenchLeavesTheLeastTensionsWhereTheyBalance) {
  const TensionCase problem(spidar_preset("x3r").geometry, {});
  const SpidarTensions result = problem.solve({});
  EXPECT_EQ(result.display, SpidarDisplay::kExact);
  EXPECT_LT(difference(result.displayed, {}), 1e-9);
  EXPECT_NEAR(result.tensions.minCoeff(), 0.3, 1e-9);
  EXPECT_LT(result.tensions.maxCoeff(), 1.0);
}

TEST(SpidarTensions, HoldTheGripWithoutAWrenchInMostPoses) {
  for (const char* name : {"x3r", "x3l", "x4r"}) {
    SpidarPoses random(13);
    const int poses = test::sweep_size(30000);
    int held = 0;
    for (int k = 0; k < poses; ++k) {
      const TensionCase problem(spidar_preset(name).geometry, random.pose(0.02, kFrameTurn));
      held += problem.solve({}).display == SpidarDisplay::kExact ? 1 : 0;
    }
    EXPECT_GT(held, 0.88 * poses) << name;
    EXPECT_LT(held, poses) << name;  // the corners of that box are beyond any SPIDAR of this size
    std::printf("%s: no wrench is displayed exactly at %.1f %% of the poses\n", name, 100.0 * held / poses);
  }
}

TEST(SpidarTensions, FollowTheWrenchWithoutJumpsOutOfReachAndBack) {
  const TensionCase problem(spidar_preset("x4r").geometry,
                            {{5e-3, -3e-3, 2e-3}, rotation_from_vector({0.1, 0.2, -0.1})});
  const Vector3 direction = Vector3(1.0, 0.3, -0.7).normalized();
  SpidarVector last = problem.solve({}).tensions;
  bool was_exact = false, was_scaled = false;
  for (int k = 0; k < 8000; ++k) {
    const double force = 0.01 * k;
    const SpidarTensions result = problem.solve({force * direction, 0.002 * force * Vector3::UnitY()});
    EXPECT_LT((result.tensions - last).cwiseAbs().maxCoeff(), 0.1) << force;
    was_exact = was_exact || result.display == SpidarDisplay::kExact;
    was_scaled = was_scaled || result.display == SpidarDisplay::kScaled;
    last = result.tensions;
  }
  EXPECT_TRUE(was_exact);
  EXPECT_TRUE(was_scaled);
}

TEST(SpidarTensions, AreLeastWhereNothingCanBeSaid) {
  const TensionCase problem(spidar_preset("x3r").geometry, {});
  const Wrench bad{{std::numeric_limits<double>::quiet_NaN(), 0.0, 0.0}, Vector3::Zero()};
  EXPECT_EQ(problem.solve(bad).tensions, problem.min);
  TensionCase singular = problem;
  singular.W.row(5).setZero();
  const SpidarTensions result = singular.solve({{1.0, 0.0, 0.0}, Vector3::Zero()});
  EXPECT_EQ(result.display, SpidarDisplay::kSingular);
  EXPECT_EQ(result.tensions, problem.min);
  TensionCase broken = problem;
  broken.W(0, 0) = std::numeric_limits<double>::infinity();
  EXPECT_EQ(broken.solve({}).tensions, problem.min);
}

TEST(SpidarTensions, AllocateNothing) {
  const TensionCase problem(spidar_preset("x3r").geometry, {});
  const test::AllocationCounter counter;
  EXPECT_EQ(problem.solve({{1.0, 0.0, 0.0}, Vector3::Zero()}).display, SpidarDisplay::kExact);
  EXPECT_EQ(problem.solve({{100.0, 0.0, 0.0}, Vector3::Zero()}).display, SpidarDisplay::kScaled);
  EXPECT_EQ(counter.count(), 0U);
}

}  // namespace
}  // namespace tegotae
