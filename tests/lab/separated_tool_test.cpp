// SPDX-License-Identifier: Apache-2.0
#include <tests/lab/reference_task.hpp>

#include <tegotae/lab/separated_tool.hpp>

#include <gtest/gtest.h>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

namespace tegotae {
namespace {

constexpr double kToolStiffness = 2000.0, kLength = 0.02;

SeparatedTool::Parameters parameters() {
  return {.stiffness = kToolStiffness, .metric_length = kLength, .skin = kThinSkin};
}

// The non-negative x of least |A x - b| (Lawson and Hanson 1974, chapter 23): returns the least norm.
double distance_to_cone(const Eigen::MatrixXd& A, const Eigen::VectorXd& b) {
  std::vector<int> passive;
  Eigen::VectorXd x = Eigen::VectorXd::Zero(A.cols());
  for (int round = 0; round < 200; ++round) {
    Eigen::VectorXd gain = A.transpose() * (b - A * x);
    for (const int i : passive) gain[i] = -1.0;
    Eigen::Index best = 0;
    if (gain.size() == 0 || gain.maxCoeff(&best) <= 1e-15) break;
    passive.push_back(static_cast<int>(best));
    while (!passive.empty()) {
      const Eigen::VectorXd part = A(Eigen::all, passive).completeOrthogonalDecomposition().solve(b);
      double way = 1.0;
      for (Eigen::Index i = 0; i < part.size(); ++i) {
        const double now = x[passive[static_cast<size_t>(i)]];
        if (part[i] <= 0.0) way = std::min(way, now / (now - part[i]));
      }
      for (Eigen::Index i = 0; i < part.size(); ++i) {
        double& value = x[passive[static_cast<size_t>(i)]];
        value += way * (part[i] - value);
      }
      if (way >= 1.0) break;
      std::erase_if(passive, [&](int i) { return x[i] <= 1e-14 ? (x[i] = 0.0, true) : false; });
    }
  }
  return (A * x - b).norm();
}

// How far the displayed wrench is from a sum of pushing forces along the planes' normals, relative to it. A force may
// act at a point of the tool that lies in its plane, where a point of the body lies opposite: both are sums of vertices
// within `band` of the plane, with the same loads. Unknowns: loads of those vertices of tool and body, pair by pair.
double distance_from_pushes(const SeparatedTool& tool) {
  constexpr double kBand = 2e-9;  // m
  const Vector3 centre_W = tool.pose() * tool.centre();
  const auto pair_count = static_cast<Eigen::Index>(tool.pairs().size());
  std::vector<Eigen::VectorXd> columns;
  for (Eigen::Index j = 0; j < pair_count; ++j) {
    const PlanePair& pair = tool.pairs()[static_cast<size_t>(j)];
    const Vector3& n = pair.n;
    const double gap = gap_along(*pair.above, *pair.below, n);
    if (gap > kThinSkin + kBand) continue;
    const double lowest = -greatest_along(*pair.above, -n), highest = greatest_along(*pair.below, n);
    for (const Vector3& v : pair.above->vertices) {
      if (n.dot(v) > lowest + kBand) continue;
      Eigen::VectorXd column = Eigen::VectorXd::Zero(6 + 4 * pair_count);
      column.head<3>() = n;
      column.segment<3>(3) = (v - centre_W).cross(n) / kLength;
      column.segment<3>(6 + 4 * j) = (v - centre_W - n.dot(v - centre_W) * n) / kLength;
      column[9 + 4 * j] = 1.0;
      columns.push_back(column);
    }
    for (const Vector3& w : pair.below->vertices) {
      if (n.dot(w) < highest - kBand) continue;
      Eigen::VectorXd column = Eigen::VectorXd::Zero(6 + 4 * pair_count);
      column.segment<3>(6 + 4 * j) = -(w - centre_W - n.dot(w - centre_W) * n) / kLength;
      column[9 + 4 * j] = -1.0;
      columns.push_back(column);
    }
  }
  Eigen::VectorXd wrench = Eigen::VectorXd::Zero(6 + 4 * pair_count);
  wrench.head<3>() = tool.wrench().force;
  wrench.segment<3>(3) = tool.wrench().torque / kLength;
  const double size = wrench.norm();
  if (size == 0.0) return 0.0;
  if (columns.empty()) return 1.0;
  Eigen::MatrixXd A(wrench.size(), static_cast<Eigen::Index>(columns.size()));
  for (size_t i = 0; i < columns.size(); ++i) A.col(static_cast<Eigen::Index>(i)) = columns[i];
  return distance_to_cone(A, wrench / size);
}

// The least gap that the planes prove, over all pairs that are near, m.
double proven_gap(const SeparatedTool& tool) {
  double least = 1.0;
  for (const PlanePair& pair : tool.pairs()) {
    double above = 1e9, below = -1e9;
    for (const Vector3& v : pair.above->vertices) above = std::min(above, pair.n.dot(v) - pair.above->radius);
    for (const Vector3& w : pair.below->vertices) below = std::max(below, pair.n.dot(w) + pair.below->radius);
    least = std::min(least, above - below);
  }
  return least;
}

struct Scene {
  const char* name;
  SceneGeometry geometry;
  double height;  // m at which the tool is free
};

Shape random_hull(std::mt19937& engine, int count, double radius) {
  std::normal_distribution<double> normal;
  std::vector<Vector3> points;
  for (int i = 0; i < count; ++i)
    points.push_back(radius * Vector3(normal(engine), normal(engine), normal(engine)).normalized());
  return make_hull(points);
}

std::vector<Scene> scenes() {
  std::mt19937 engine(5);
  const Shape box = make_box({0.02, 0.015, 0.01});
  const std::vector<Shape> steps = {make_box({0.05, 0.05, 0.01}, placed_at(0, 0, -0.01)),
                                    make_box({0.01, 0.05, 0.01}, placed_at(0.02, 0, 0.002, {0.0, 0.0, 10.0})),
                                    make_box({0.01, 0.02, 0.01}, placed_at(-0.015, 0.01, 0.0, {5.0, 0.0, 30.0}))};
  return {{"box on steps", touching_scene(box, steps), 0.05},
          {"box on pillar", touching_scene(box, {make_box({0.006, 0.004, 0.02}, placed_at(0, 0, -0.02))}), 0.04},
          {"hull on hull", touching_scene(random_hull(engine, 18, 0.02), {random_hull(engine, 60, 0.03)}), 0.06},
          {"hull of 230 on steps", touching_scene(random_hull(engine, 230, 0.02), steps), 0.05},
          {"capsule on balls",
           touching_scene(make_capsule(0.005, 0.02, placed_at(0, 0, 0, {0.0, 90.0, 0.0})),
                          {make_sphere(0.01, placed_at(0.015, 0, 0)), make_sphere(0.01, placed_at(-0.015, 0.001, 0)),
                           make_plane(placed_at(0, 0, -0.005))}),
           0.04}};
}

TEST(SeparatedTool, IsApartAndFeelsASumOfPushes) {
  std::mt19937 engine(17);
  std::uniform_real_distribution<double> uniform(-1.0, 1.0);
  for (const Scene& scene : scenes()) {
    int touching = 0;
    for (int trial = 0; trial < 6; ++trial) {
      SCOPED_TRACE(std::string(scene.name) + ", trial " + std::to_string(trial));
      SeparatedTool tool(scene.geometry, parameters());
      Pose hand = placed_at(0.004 * uniform(engine), 0.004 * uniform(engine), scene.height);
      ASSERT_TRUE(tool.start(hand));
      const auto random_turn = [&]() -> Vector3 {
        return 20.0 * Vector3(uniform(engine), uniform(engine), uniform(engine));
      };
      const auto random_height = [&] { return 0.004 * uniform(engine) + 0.006; };
      for (int leg = 0; leg < 3; ++leg) {
        const Pose next = placed_at(0.01 * uniform(engine), 0.01 * uniform(engine), random_height(), random_turn());
        const int steps = 1 + static_cast<int>(tool.way(displacement(hand, next, Vector3::Zero())) / 2e-4);
        for (int step = 1; step <= steps; ++step) {
          ASSERT_TRUE(tool.follow(interpolate(hand, next, static_cast<double>(step) / steps)));
          ASSERT_GE(proven_gap(tool), kThinSkin - 1e-8) << "leg " << leg << ", step " << step;
          if (step % 10 != 0 && step != steps) continue;
          touching += tool.touches();
          ASSERT_LT(distance_from_pushes(tool), 1e-5) << "leg " << leg << ", step " << step;
        }
        hand = next;
      }
    }
    EXPECT_GT(touching, 40) << scene.name;
  }
}

TEST(SeparatedTool, StartsOutOfWhatItIsShallowlyIn) {
  const auto scene = touching_scene(make_box(Vector3::Constant(0.01)), {make_box({0.1, 0.1, 0.02})});
  SeparatedTool tool(scene, parameters());
  EXPECT_TRUE(tool.start(placed_at(0, 0, 0.03 - 0.5e-3)));
  EXPECT_NEAR(tool.pose().p.z(), 0.03 + kThinSkin, 1e-8);
  EXPECT_FALSE(tool.start(placed_at(0, 0, 0.03 - 2e-3)));
}

TEST(SeparatedTool, MovesAboutItsCentreOfMass) {
  // A rod whose mass is at one end: pressed at the other end, which turns it.
  SceneGeometry scene =
      touching_scene(make_box({0.05, 0.005, 0.005}), {make_box({0.01, 0.1, 0.1}, placed_at(0.06, 0, -0.1))});
  scene.tool.mass.centre_of_mass = {-0.03, 0.0, 0.0};
  SeparatedTool tool(scene, parameters());
  ASSERT_TRUE(tool.start(placed_at(0, 0, 0.0052)));
  const double depth = 10e-6;
  for (int step = 1; step <= 21; ++step) ASSERT_TRUE(tool.follow(placed_at(0, 0, 0.0052 - 10e-6 * step)));
  const double lever = 0.08;  // from the centre of mass to the rod's end
  const Wrench wrench = tool.wrench();
  EXPECT_NEAR(wrench.torque.y(), -wrench.force.z() * lever, 1e-3 * wrench.force.z() * lever);
  const double force = kToolStiffness * (depth + kThinSkin) / (1.0 + lever * lever / (kLength * kLength));
  EXPECT_NEAR(wrench.force.z(), force, 1e-3 * force);
}

TEST(SeparatedTool, PiecesThatTheSceneKeepsApartDoNotTouch) {
  SceneGeometry scene = touching_scene(make_box(Vector3::Constant(0.01)), {make_box({0.1, 0.1, 0.02})});
  scene.bodies[0].pieces[0].contact_type = 2;
  scene.bodies[0].pieces[0].contact_affinity = 2;
  SeparatedTool tool(scene, parameters());
  EXPECT_TRUE(tool.start(placed_at(0, 0, 0.01)));
  EXPECT_FALSE(tool.touches());
  EXPECT_EQ(tool.wrench().force.norm(), 0.0);
}

TEST(SeparatedTool, RefusesAToolWithAHalfSpace) {
  const auto scene = touching_scene(make_plane(), {make_sphere(0.01)});
  EXPECT_THROW(SeparatedTool(scene, parameters()), std::invalid_argument);
}

}  // namespace
}  // namespace tegotae
