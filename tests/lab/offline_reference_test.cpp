// SPDX-License-Identifier: Apache-2.0
#include <tests/lab/reference_task.hpp>

#include <tegotae/lab/paper_cube.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace tegotae {
namespace {

void expect_all_defined(const std::vector<ReferenceSample>& samples) {
  const auto undefined =
      std::count_if(samples.begin(), samples.end(), [](const ReferenceSample& sample) { return !sample.defined; });
  EXPECT_EQ(undefined, 0);
}

// The greatest difference of two runs where neither leaps: N, and torque over the metric length.
double difference(const std::vector<ReferenceSample>& a, const std::vector<ReferenceSample>& b, double length) {
  double greatest = 0.0;
  for (size_t i = 0; i < a.size(); ++i) {
    if (a[i].snaps || b[i].snaps) continue;
    const Wrench apart = a[i].wrench - b[i].wrench;
    greatest = std::max({greatest, apart.force.norm(), apart.torque.norm() / length});
  }
  return greatest;
}

double greatest_force(const std::vector<ReferenceSample>& samples) {
  double greatest = 0.0;
  for (const ReferenceSample& sample : samples) greatest = std::max(greatest, sample.wrench.force.norm());
  return greatest;
}

long count_touching(const std::vector<ReferenceSample>& samples) {
  return std::count_if(samples.begin(), samples.end(), [](const ReferenceSample& sample) { return sample.touches; });
}

// --- The paper's cube, y up, its floor's top at y = 0

constexpr double kHalfOfTool = 0.1, kCubeStiffness = 9000.0;

SceneGeometry cube_scene() {
  return touching_scene(make_box(Vector3::Constant(kHalfOfTool)),
                        {make_box({1.0, 0.1, 1.0}, placed_at(0.0, -0.1, 0.0))});
}

double height_of_edge(double angle) { return kHalfOfTool * (std::cos(angle) + std::sin(angle)); }

// An edge at `angle` held in the floor, exact for turns of any size: the displacement (dy, turn) of least
// dy^2 + l^2 turn^2 that lifts the lowest edge to the skin, where its slope over the turn vanishes.
Wrench edge_on_floor(double height, double angle, double length) {
  const auto rise = [&](double turn) { return height_of_edge(angle + turn) + kThinSkin - height; };
  const auto slope = [&](double turn) {
    return rise(turn) * kHalfOfTool * (std::cos(angle + turn) - std::sin(angle + turn)) + length * length * turn;
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
  for (double degrees = 45.0; degrees >= 1.0; degrees -= 2.0) {
    path.to(placed_at(0.0, height_of_edge(degrees * kDegreeOfArc) - depth, 0.0, {0.0, 0.0, degrees}), 4);
    ticks.push_back(path.poses().size() - 1);
  }
  const auto samples = solve_offline(cube_scene(), path, {kCubeStiffness, length}, 20.0 * kReferenceHandStep);
  expect_all_defined(samples);
  for (const size_t tick : ticks) {
    const Pose& X_WT = path.poses()[tick];
    const CubeOnFloor expected =
        cube_on_floor(kHalfOfTool, X_WT.p.y() - kThinSkin, rotation_vector(X_WT.q).z(), kCubeStiffness, length);
    const double tolerance = 3e-4 * expected.force_y;
    EXPECT_NEAR(samples[tick].wrench.force.y(), expected.force_y, tolerance) << "tick " << tick;
    EXPECT_NEAR(samples[tick].wrench.torque.z(), expected.torque_z, tolerance * kHalfOfTool) << "tick " << tick;
    EXPECT_LT(std::abs(samples[tick].wrench.force.x()) + std::abs(samples[tick].wrench.force.z()), 1e-9);
  }
}

TEST_P(OfflineReferenceCube, DeepEdgeIsCarriedAsItsOwnMinimumSays) {
  const double length = GetParam(), depth = 0.35e-3;
  HandPath path(placed_at(0.0, 0.2, 0.0, {0.0, 0.0, 45.0}));
  std::vector<size_t> ticks;
  for (double degrees = 45.0; degrees >= 1.0; degrees -= 2.0) {
    path.to(placed_at(0.0, height_of_edge(degrees * kDegreeOfArc) - depth, 0.0, {0.0, 0.0, degrees}), 4);
    ticks.push_back(path.poses().size() - 1);
  }
  const auto samples = solve_offline(cube_scene(), path, {kCubeStiffness, length}, 20.0 * kReferenceHandStep);
  expect_all_defined(samples);
  for (const size_t tick : ticks) {
    const Pose& X_WT = path.poses()[tick];
    const Wrench expected = edge_on_floor(X_WT.p.y(), rotation_vector(X_WT.q).z(), length);
    EXPECT_NEAR(samples[tick].wrench.force.y(), expected.force.y(), 2e-6 * expected.force.y()) << "tick " << tick;
    EXPECT_NEAR(samples[tick].wrench.torque.z(), expected.torque.z(), 2e-6 * expected.force.y() * kHalfOfTool);
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

// Two walls, the room between them 0.1 mm less than the tool is wide. The tool stands between them from the start.
SceneGeometry narrow_slot() {
  const double inset = 0.05e-3;
  return touching_scene(make_box({0.01, 0.02, 0.02}), {make_box({0.01, 0.1, 0.1}, placed_at(-0.02 + inset, 0, 0)),
                                                       make_box({0.01, 0.1, 0.1}, placed_at(0.02 - inset, 0, 0))});
}

TEST(OfflineReference, WallsTooNarrowHoldTheToolMidway) {
  const double aside = 0.4e-3, stiffness = 2000.0;
  const auto path = HandPath(placed_at(0, 0, 0))
                        .to(placed_at(aside, 0, 0), 20)
                        .to(placed_at(aside, 0, 0.01), 100)
                        .to(placed_at(aside, 0, 0.01, {0.0, 0.0, 1.0}), 50);
  const auto samples = solve_offline(narrow_slot(), path, {stiffness, 0.02});
  expect_all_defined(samples);
  // Along the slot nothing holds it; across it, it stays in the middle.
  for (const size_t tick : {20u, 120u}) {
    EXPECT_NEAR(samples[tick].wrench.force.x(), -stiffness * aside, 1e-4 * stiffness * aside);
    EXPECT_LT(std::abs(samples[tick].wrench.force.z()), 1e-6);
    EXPECT_LT(samples[tick].wrench.torque.norm(), 1e-8);
    EXPECT_TRUE(samples[tick].touches);
  }
  // A turn is undone.
  EXPECT_NEAR(samples.back().wrench.torque.z(), -stiffness * 0.02 * 0.02 * kDegreeOfArc, 1e-6);
}

struct Approach {
  double about_x, about_y;  // degrees
};

class OfflineReferenceThinPlate : public testing::TestWithParam<Approach> {};

// 1 mm thick, pressed 50 mm deep at 1 m/s.
TEST_P(OfflineReferenceThinPlate, IsNeverPassedThrough) {
  const double half = 0.02, top = 0.5e-3, stiffness = 2000.0;
  const Vector3 turn(GetParam().about_x, GetParam().about_y, 0.0);
  const auto scene = touching_scene(make_box(Vector3::Constant(half)), {make_box({0.2, 0.2, top})});
  const auto path = HandPath(placed_at(0, 0, 0.037, turn)).to(placed_at(0, 0, half + top - 0.05, turn), 67);
  const auto samples = solve_offline(scene, path, {stiffness, half});
  expect_all_defined(samples);
  // The tool is on its face at the end, above the plate.
  const Vector3 force(0.0, 0.0, stiffness * (0.05 + kThinSkin));
  EXPECT_LT((samples.back().wrench.force - force).norm(), 1e-4 * force.norm());
  const Vector3 torque = -stiffness * half * half * kDegreeOfArc * turn;
  EXPECT_LT((samples.back().wrench.torque - torque).norm(), 1e-6);
}

INSTANTIATE_TEST_SUITE_P(Approaches, OfflineReferenceThinPlate,
                         testing::Values(Approach{0, 0}, Approach{10, 5}, Approach{30, 20}, Approach{-40, 3},
                                         Approach{2, -25}));

TEST(OfflineReference, ToolThatSlidesOverATablesEdgeDropsAndIsFree) {
  const auto scene =
      touching_scene(make_box(Vector3::Constant(0.02)), {make_box({0.1, 0.1, 0.02}, placed_at(-0.1, 0, -0.02))});
  const Vector3 tilt(0.0, 1.0, 0.0);
  const auto path = HandPath(placed_at(-0.05, 0, 0.021))
                        .to(placed_at(-0.05, 0, 0.019, tilt), 50)
                        .to(placed_at(0.06, 0, 0.019, tilt), 1000);
  const auto samples = solve_offline(scene, path, {2000.0, 0.0163});
  expect_all_defined(samples);
  size_t last = 0;
  for (size_t tick = 0; tick < samples.size(); ++tick)
    if (samples[tick].touches) last = tick;
  EXPECT_GT(path.poses()[last].p.x(), 0.01);   // the upper part of its lower face still lies on the table
  EXPECT_LT(path.poses()[last].p.x(), 0.021);  // its lower corner trails, as it is tilted
  EXPECT_TRUE(samples[last].snaps || samples[last + 1].snaps);
  for (size_t tick = last + 1; tick < samples.size(); ++tick) {
    EXPECT_EQ(samples[tick].wrench.force.norm(), 0.0);
    EXPECT_EQ(samples[tick].wrench.torque.norm(), 0.0);
  }
}

TEST(OfflineReference, ToolThatDoesNotTouchFeelsNothing) {
  const auto path = HandPath(placed_at(0.0, 0.1005, 0.0)).to(placed_at(0.1, 0.10001, 0.0), 50);
  const auto samples = solve_offline(cube_scene(), path, {kCubeStiffness, 1.0});
  expect_all_defined(samples);
  EXPECT_EQ(count_touching(samples), 0);
  EXPECT_EQ(greatest_force(samples), 0.0);
}

TEST(OfflineReference, HandThatStartsDeepInsideIsUndefinedUntilItLeaves) {
  const auto path =
      HandPath(placed_at(0.0, 0.05, 0.0)).to(placed_at(0.0, 0.11, 0.0), 60).to(placed_at(0.0, 0.099, 0.0), 60);
  const auto samples = solve_offline(cube_scene(), path, {kCubeStiffness, 1.0});
  EXPECT_FALSE(samples.front().defined);
  EXPECT_FALSE(samples[40].defined);
  EXPECT_TRUE(samples[61].defined);
  EXPECT_NEAR(samples.back().wrench.force.y(), kCubeStiffness * (1e-3 + kThinSkin), 1e-4);
}

TEST(OfflineReference, BallOnAHalfSpaceIsPressedAtItsLowestPoint) {
  const auto scene = touching_scene(make_sphere(0.01), {make_plane()});
  const auto path = HandPath(placed_at(0, 0, 0.011)).to(placed_at(0.02, 0, 0.008, {20.0, 0.0, 0.0}), 100);
  const auto samples = solve_offline(scene, path, {2000.0, 0.01});
  expect_all_defined(samples);
  EXPECT_NEAR(samples.back().wrench.force.z(), 2000.0 * (0.002 + kThinSkin), 1e-5);
  EXPECT_LT(std::abs(samples.back().wrench.force.x()), 1e-8);
  EXPECT_LT(samples.back().wrench.torque.norm(), 1e-10);
}

TEST(OfflineReference, ReportsProgressThatGrows) {
  const auto path = HandPath(placed_at(0, 0.3, 0)).to(placed_at(0, 0.2, 0), 200);
  SessionSettings settings;
  const SceneGeometry scene = cube_scene();
  std::vector<double> reports;
  offline_reference()({scene, path.poses(), 1e-3, settings}, [&](double done) { reports.push_back(done); });
  ASSERT_GE(reports.size(), 3u);
  EXPECT_TRUE(std::is_sorted(reports.begin(), reports.end()));
  EXPECT_LE(reports.back(), 1.0);
}

// --- A step of half the size gives the same answer

struct Motion {
  const char* name;
  SceneGeometry scene;
  HandPath path;
};

Motion sliding_plates() {
  return {"crossed plates", touching_scene(make_box({0.05, 0.01, 0.002}), {make_box({0.01, 0.05, 0.002})}),
          HandPath(placed_at(0, 0, 0.005))
              .to(placed_at(0.002, 0.001, 0.0038, {1.0, 2.0, 3.0}), 100)
              .to(placed_at(0.002, 0.004, 0.0033, {-1.0, 1.0, -3.0}), 200)
              .to(placed_at(0.04, 0.004, 0.0033, {-1.0, 1.0, 20.0}), 200)};
}

Motion peg_in_hole() {
  const double room = 0.01 + 0.05e-3;
  const auto wall = [&](double x, double y) {
    return make_box({x != 0.0 ? 0.01 : 0.03, y != 0.0 ? 0.01 : 0.03, 0.015},
                    placed_at(x * (room + 0.01), y * (room + 0.01), 0));
  };
  return {"peg in a hole",
          touching_scene(make_box({0.01, 0.01, 0.02}), {wall(1, 0), wall(-1, 0), wall(0, 1), wall(0, -1),
                                                        make_box({0.05, 0.05, 0.005}, placed_at(0, 0, -0.02))}),
          HandPath(placed_at(2e-5, 0, 0.036))
              .to(placed_at(2e-5, 0, 0.034), 20)
              .to(placed_at(0.001, 0.0005, 0.003, {1.0, 2.0, 3.0}), 300)
              .to(placed_at(-0.001, 0.0005, 0.003, {-2.0, 2.0, -3.0}), 100)};
}

Motion wedge() {
  return {"wedge of 10 degrees",
          touching_scene(make_box(Vector3::Constant(0.01)),
                         {make_box({0.02, 0.05, 0.05}, placed_at(-0.0306, 0, 0, {0.0, 5.0, 0.0})),
                          make_box({0.02, 0.05, 0.05}, placed_at(0.0306, 0, 0, {0.0, -5.0, 0.0}))}),
          HandPath(placed_at(0, 0, 0.065))
              .to(placed_at(0, 0, 0), 300)
              .to(placed_at(0.001, 0, -0.002, {2.0, 3.0, 1.0}), 100)};
}

// Even steps greater than those that are used.
TEST(OfflineReference, StepsOfHalfTheSizeChangeNothing) {
  for (const Motion& motion : {sliding_plates(), peg_in_hole(), wedge()}) {
    SCOPED_TRACE(motion.name);
    const HandCoupling coupling;
    const auto samples = solve_offline(motion.scene, motion.path, coupling, 4.0 * kReferenceHandStep);
    const auto finer = solve_offline(motion.scene, motion.path, coupling, 2.0 * kReferenceHandStep);
    expect_all_defined(samples);
    expect_all_defined(finer);
    EXPECT_GT(greatest_force(samples), 1.0);
    EXPECT_LT(difference(samples, finer, coupling.metric_length), 1e-4 * greatest_force(samples));
  }
}

// A prism of many sides rolls over an edge from side to side: each is a least of its own, left only where it ends.
TEST(OfflineReference, LeapsComeWhereTheyMustAndNoSooner) {
  std::vector<Vector3> points;
  constexpr int kSides = 24;
  for (int i = 0; i < kSides; ++i) {
    const double angle = 2.0 * std::numbers::pi * (i + 0.5) / kSides;
    for (const double y : {-0.01, 0.01}) points.emplace_back(0.02 * std::sin(angle), y, 0.02 * std::cos(angle));
  }
  const auto scene = touching_scene(make_hull(points), {make_box({0.05, 0.05, 0.02}, placed_at(-0.05, 0, -0.02))});
  const auto path = HandPath(placed_at(-0.005, 0, 0.021))
                        .to(placed_at(-0.005, 0, 0.0188, {0.0, 1.0, 0.0}), 50)
                        .to(placed_at(0.015, 0, 0.0188, {0.0, 1.0, 0.0}), 400);
  const HandCoupling coupling;
  const auto samples = solve_offline(scene, path, coupling);
  const auto finer = solve_offline(scene, path, coupling, 0.25 * kReferenceHandStep);
  expect_all_defined(samples);
  expect_all_defined(finer);
  std::vector<size_t> leaps[2];
  for (size_t tick = 0; tick < samples.size(); ++tick) {
    if (samples[tick].snaps) leaps[0].push_back(tick);
    if (finer[tick].snaps) leaps[1].push_back(tick);
  }
  ASSERT_GE(leaps[0].size(), 1u);
  for (const size_t leap : leaps[0]) {
    EXPECT_GT((samples[leap].wrench.force - samples[leap - 1].wrench.force).norm(), 0.1);
    EXPECT_TRUE(std::any_of(leaps[1].begin(), leaps[1].end(), [leap](size_t l) { return l >= leap && l <= leap + 1; }));
  }
}

}  // namespace
}  // namespace tegotae
