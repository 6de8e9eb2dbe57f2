// SPDX-License-Identifier: Apache-2.0
#include "tests/lab/reference_task.hpp"

#include <tegotae/lab/paper_cube.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace tegotae {
namespace {

void expect_all_defined(const std::vector<ReferenceSample>& samples) {
  const auto undefined =
      std::count_if(samples.begin(), samples.end(), [](const ReferenceSample& sample) { return !sample.defined; });
  EXPECT_EQ(undefined, 0);
}

// --- The paper's cube, y up, its floor's top at y = 0

constexpr double kHalf = 0.1, kCubeStiffness = 9000.0;

SceneGeometry cube_scene() {
  return touching_scene(make_box(Vector3::Constant(kHalf)), {make_box({1.0, 0.1, 1.0}, placed_at(0.0, -0.1, 0.0))});
}

double height_of_edge(double angle) { return kHalf * (std::cos(angle) + std::sin(angle)); }

// An edge at `angle` held in the floor, exact for turns of any size: the displacement (dy, turn) of least
// dy^2 + l^2 turn^2 that lifts the lowest edge to the skin, where its slope over the turn vanishes.
Wrench edge_on_floor(double height, double angle, double length) {
  const auto rise = [&](double turn) { return height_of_edge(angle + turn) + kThinSkin - height; };
  const auto slope = [&](double turn) {
    return rise(turn) * kHalf * (std::cos(angle + turn) - std::sin(angle + turn)) + length * length * turn;
  };
  double low = -0.02, high = 0.02;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (slope(middle) > 0.0 ? high : low) = middle;
  }
  return {{0.0, kCubeStiffness * rise(low), 0.0}, {0.0, 0.0, kCubeStiffness * length * length * low}};
}

class OfflineReferenceCube : public testing::TestWithParam<double> {};

TEST_P(OfflineReferenceCube, EdgeIsCarriedAsTheClosedFormSays) {
  const double length = GetParam(), depth = 20e-6;  // so small that the closed form's linearisation errs by 1e-4
  HandPath path(placed_at(0.0, 0.2, 0.0, {0.0, 0.0, 45.0}));
  std::vector<size_t> ticks;
  for (double degrees = 45.0; degrees >= 1.0; degrees -= 0.5) {
    path.to(placed_at(0.0, height_of_edge(degrees * kDegreeOfArc) - depth, 0.0, {0.0, 0.0, degrees}), 4);
    ticks.push_back(path.poses().size() - 1);
  }
  const auto samples = solve_offline(cube_scene(), path, {kCubeStiffness, length});
  expect_all_defined(samples);
  for (const size_t tick : ticks) {
    const Pose& X_WT = path.poses()[tick];
    const CubeOnFloor expected =
        cube_on_floor(kHalf, X_WT.p.y() - kThinSkin, rotation_vector(X_WT.q).z(), kCubeStiffness, length);
    const double tolerance = 3e-4 * expected.force_y;
    EXPECT_NEAR(samples[tick].wrench.force.y(), expected.force_y, tolerance) << "tick " << tick;
    EXPECT_NEAR(samples[tick].wrench.torque.z(), expected.torque_z, tolerance * kHalf) << "tick " << tick;
    EXPECT_LT(std::abs(samples[tick].wrench.force.x()) + std::abs(samples[tick].wrench.force.z()), 1e-9);
  }
}

TEST_P(OfflineReferenceCube, DeepEdgeIsCarriedAsItsOwnMinimumSays) {
  const double length = GetParam(), depth = 0.35e-3;
  HandPath path(placed_at(0.0, 0.2, 0.0, {0.0, 0.0, 45.0}));
  std::vector<size_t> ticks;
  for (double degrees = 45.0; degrees >= 1.0; degrees -= 0.5) {
    path.to(placed_at(0.0, height_of_edge(degrees * kDegreeOfArc) - depth, 0.0, {0.0, 0.0, degrees}), 4);
    ticks.push_back(path.poses().size() - 1);
  }
  const auto samples = solve_offline(cube_scene(), path, {kCubeStiffness, length});
  expect_all_defined(samples);
  for (const size_t tick : ticks) {
    const Pose& X_WT = path.poses()[tick];
    const Wrench expected = edge_on_floor(X_WT.p.y(), rotation_vector(X_WT.q).z(), length);
    EXPECT_NEAR(samples[tick].wrench.force.y(), expected.force.y(), 2e-6 * expected.force.y()) << "tick " << tick;
    EXPECT_NEAR(samples[tick].wrench.torque.z(), expected.torque.z(), 2e-6 * expected.force.y() * kHalf);
  }
}

INSTANTIATE_TEST_SUITE_P(BothMetricLengths, OfflineReferenceCube, testing::Values(1.0, 0.2 / std::sqrt(6.0)));

TEST(OfflineReference, FaceThatIsPressedFlatHasNoTorque) {
  const double depth = 0.3e-3;
  const auto path = HandPath(placed_at(0.0, 0.101, 0.0)).to(placed_at(0.0, 0.1 - depth, 0.0), 50);
  const auto samples = solve_offline(cube_scene(), path, {kCubeStiffness, 0.0816});
  expect_all_defined(samples);
  const Wrench& wrench = samples.back().wrench;
  EXPECT_NEAR(wrench.force.y(), kCubeStiffness * (depth + kThinSkin), 1e-6);
  EXPECT_LT(wrench.torque.norm(), 1e-9);
  EXPECT_FALSE(samples.front().touches);
  EXPECT_TRUE(samples.back().touches);
}

// --- Overhang, slots, thin things

TEST(OfflineReference, OverhangingPlateIsCarriedByThePillarsEdgeAlone) {
  const double lever = 0.02, depth = 20e-6, length = 0.05, stiffness = 2000.0;
  const auto scene =
      touching_scene(make_box({0.05, 0.05, 0.002}), {make_box({0.01, 0.01, 0.05}, placed_at(0, 0, -0.05))});
  const auto path = HandPath(placed_at(0.01 + lever, 0, 0.0021)).to(placed_at(0.01 + lever, 0, 0.002 - depth), 20);
  const auto samples = solve_offline(scene, path, {stiffness, length});
  expect_all_defined(samples);
  const double force = stiffness * (depth + kThinSkin) / (1.0 + lever * lever / (length * length));
  EXPECT_NEAR(samples.back().wrench.force.z(), force, 1e-4 * force);
  EXPECT_NEAR(samples.back().wrench.torque.y(), force * lever, 1e-4 * force * lever);
}

}  // namespace
}  // namespace tegotae
