// SPDX-License-Identifier: Apache-2.0
#include <tegotae/shape/convex_hull.hpp>

#include <tests/random_shapes.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

namespace tegotae {
namespace {

void expect_well_formed(const Polytope& polytope, double size) {
  const auto V = polytope.vertices.size(), E = polytope.edges.size(), F = polytope.faces.size();
  EXPECT_EQ(V + F, E + 2) << "Euler's formula";
  EXPECT_EQ(polytope.neighbors.size(), 2 * E);
  for (const auto& face : polytope.faces) {
    EXPECT_NEAR(face.normal.norm(), 1.0, 1e-14);
    EXPECT_LT(face.normal.dot(polytope.centroid), face.offset);
    for (const auto& p : polytope.vertices) EXPECT_LE(face.normal.dot(p), face.offset + 1e-12 * size);
    for (const int v : polytope.vertices_of(face)) {
      EXPECT_NEAR(face.normal.dot(polytope.vertices[static_cast<size_t>(v)]), face.offset, 4e-12 * size);
    }
  }
  for (const auto& edge : polytope.edges) {
    const auto loop = polytope.vertices_of(polytope.faces[static_cast<size_t>(edge.face[0])]);
    bool runs_forward = false;
    for (size_t k = 0; k < loop.size(); ++k) {
      runs_forward |= loop[k] == edge.vertex[0] && loop[(k + 1) % loop.size()] == edge.vertex[1];
    }
    EXPECT_TRUE(runs_forward);
    for (int side = 0; side < 2; ++side) {
      const auto& face = polytope.faces[static_cast<size_t>(edge.face[side])];
      const auto vertices = polytope.vertices_of(face);
      const auto across = polytope.neighbors_of(face);
      const auto start = std::find(vertices.begin(), vertices.end(), edge.vertex[side]);
      ASSERT_NE(start, vertices.end());
      EXPECT_EQ(across[static_cast<size_t>(start - vertices.begin())], edge.face[1 - side]);
    }
  }
}

TEST(ConvexHull, CubeHasSixQuadFaces) {
  std::vector<Vector3> points;
  for (int i = 0; i < 8; ++i) points.emplace_back(i & 1, (i >> 1) & 1, (i >> 2) & 1);
  points.emplace_back(0.5, 0.5, 0.5);
  points.emplace_back(0.5, 0.5, 1.0);
  points.emplace_back(0.5, 1.0, 1.0);
  points.emplace_back(1.0, 1.0, 1.0);
  const Polytope cube = convex_hull(points);
  EXPECT_EQ(cube.vertices.size(), 8u);
  EXPECT_EQ(cube.faces.size(), 6u);
  EXPECT_EQ(cube.edges.size(), 12u);
  EXPECT_LT((cube.centroid - Vector3::Constant(0.5)).norm(), 1e-15);
  EXPECT_NEAR(cube.radius, std::sqrt(3.0), 1e-15);
  expect_well_formed(cube, 1.0);
}

TEST(ConvexHull, RandomHullsAreWellFormedAndKeepTheirExtremePoints) {
  std::mt19937_64 random(11);
  for (int count = 4; count < 400; count += 7) {
    const auto points = test::random_hull_points(random, count, 0.1);
    const Polytope hull = convex_hull(points);
    EXPECT_EQ(hull.vertices.size(), points.size());
    expect_well_formed(hull, 0.4);
  }
}

TEST(ConvexHull, CapsOfManyCoplanarVerticesAreOneFace) {
  std::vector<Vector3> points;
  const Quaternion turn = rotation_from_vector(Vector3(0.3, -0.7, 0.2));
  for (int k = 0; k < 115; ++k) {
    const double a = 2.0 * std::numbers::pi * k / 115;
    for (const double z : {-0.05, 0.05}) points.emplace_back(turn * Vector3(0.05 * std::cos(a), 0.05 * std::sin(a), z));
  }
  const Polytope prism = convex_hull(points);
  EXPECT_EQ(prism.vertices.size(), 230u);
  EXPECT_EQ(prism.faces.size(), 117u);
  expect_well_formed(prism, 0.1);
  // Mesh files and MuJoCo keep single precision.
  for (auto& p : points) p = p.cast<float>().cast<double>();
  const Polytope rounded = convex_hull(points, kSinglePrecisionCoplanarity);
  EXPECT_GT(convex_hull(points).faces.size(), 117u);
  EXPECT_EQ(rounded.vertices.size(), 230u);
  EXPECT_EQ(rounded.faces.size(), 117u);
}

TEST(ConvexHull, RefusesWhatSpansNoVolume) {
  const std::vector<Vector3> three{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  const std::vector<Vector3> flat{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {2, 1, 0}};
  std::vector<Vector3> infinite{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, std::numeric_limits<double>::infinity()}};
  const std::vector<Vector3> same(10, Vector3(1.0, 2.0, 3.0));
  EXPECT_THROW(convex_hull(three), std::invalid_argument);
  EXPECT_THROW(convex_hull(flat), std::invalid_argument);
  EXPECT_THROW(convex_hull(infinite), std::invalid_argument);
  EXPECT_THROW(convex_hull(same), std::invalid_argument);
  infinite[3].z() = std::nan("");
  EXPECT_THROW(convex_hull(infinite), std::invalid_argument);
}

}  // namespace
}  // namespace tegotae
