// SPDX-License-Identifier: Apache-2.0
#include <tegotae/contact/closest_points.hpp>
#include <tegotae/lab/convex_split.hpp>
#include <tegotae/lab/input_error.hpp>
#include <tegotae/world/mujoco_world.hpp>

#include <tests/lab/program_run.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tegotae {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;

// An angle iron of two legs, 60 mm long and 20 mm thick, 30 mm deep.
const std::string kAngle = R"(v 0 0 0
v .06 0 0
v .06 .02 0
v .02 .02 0
v .02 .06 0
v 0 .06 0
v 0 0 .03
v .06 0 .03
v .06 .02 .03
v .02 .02 .03
v .02 .06 .03
v 0 .06 .03
f 4 3 2 1
f 1 6 5 4
f 7 8 9 10
f 10 11 12 7
f 1 2 8 7
f 2 3 9 8
f 3 4 10 9
f 4 5 11 10
f 5 6 12 11
f 6 1 7 12
)";
constexpr double kAngleVolume = 0.03 * (0.06 * 0.02 + 0.04 * 0.02);  // m^3

Polytope box_at(const Vector3& p, const Vector3& half) {
  std::vector<Vector3> corners;
  for (int i = 0; i < 8; ++i) {
    corners.push_back(p + half.cwiseProduct(Vector3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1)));
  }
  return convex_hull(corners);
}

TEST(ConvexSplit, WhatOverlapsCountsOnceInTheUnion) {
  const Polytope a = box_at({0.0, 0.0, 0.0}, {1.0, 1.0, 1.0}), b = box_at({1.0, 0.0, 0.0}, {1.0, 1.0, 1.0});
  EXPECT_NEAR(union_volume({a}, 40), 8.0, 1e-9);
  EXPECT_NEAR(union_volume({a, a}, 40), 8.0, 1e-9);
  EXPECT_NEAR(union_volume({a, b}, 60), 12.0, 0.01);
  EXPECT_NEAR(union_volume({a, box_at({9.0, 0.0, 0.0}, {1.0, 1.0, 1.0})}, 66), 16.0, 0.1);
}

TEST(ConvexSplit, AMeshThatIsNoSolidIsRefused) {
  Mesh mesh;
  mesh.vertices = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.triangles = {{0, 1, 2}};
  try {
    split_convex(mesh, {}, "leaf.obj");
    FAIL() << "not refused";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), AllOf(HasSubstr("leaf.obj: the mesh has a hole"), HasSubstr("close it")));
  }
}

TEST(ConvexSplit, AMeshThatIsConvexStaysWhole) {
  Mesh cube;
  for (const double z : {-1.0, 1.0}) {
    for (const double y : {-1.0, 1.0}) {
      for (const double x : {-1.0, 1.0}) cube.vertices.emplace_back(x, y, z);
    }
  }
  cube.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                    {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
  const ConvexSplit split = split_convex(cube, {}, "cube.obj");
  ASSERT_EQ(split.pieces.size(), 1U);
  EXPECT_EQ(split.pieces[0].vertices.size(), 8U);
  EXPECT_NEAR(split.union_volume, 8.0, 1e-12);
}

TEST(ConvexSplit, AnAngleIsSplitIntoHullsOfItsVolumeAndAlwaysTheSameOnes) {
  const TemporaryFolder folder;
  const Mesh mesh = read_mesh(folder.write("angle.obj", kAngle));
  SplitSettings settings;
  settings.pieces = 4;
  settings.resolution = 20000;
  const ConvexSplit split = split_convex(mesh, settings, "angle.obj"),
                    again = split_convex(mesh, settings, "angle.obj");
  EXPECT_NEAR(split.mesh_volume, kAngleVolume, 1e-12);
  EXPECT_NEAR(split.union_volume, kAngleVolume, 0.03 * kAngleVolume);
  EXPECT_GT(split.sum_volume, 0.99 * split.union_volume);
  EXPECT_LT(split.sum_volume, 1.05 * kAngleVolume);
  ASSERT_LE(split.pieces.size(), 4U);
  ASSERT_GE(split.pieces.size(), 2U);
  ASSERT_EQ(again.pieces.size(), split.pieces.size());
  for (size_t i = 0; i < split.pieces.size(); ++i) EXPECT_EQ(split.pieces[i].vertices, again.pieces[i].vertices);
}

TEST(ConvexSplit, TheProgramWritesWhatASceneIncludes) {
  const TemporaryFolder folder;
  const std::string mesh = folder.write("angle.obj", kAngle);
  const ProgramResult result = run_program({"split", mesh, "--pieces", "4", "--resolution", "20000"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("angle-assets.xml"));
  EXPECT_EQ(result.err, "");
  const std::string scene = folder.write("scene.xml", R"(<mujoco>
    <asset><include file="angle-assets.xml"/></asset>
    <worldbody><body name="angle"><include file="angle-geoms.xml"/></body>
    <body name="tool" mocap="true" pos="0 0 1"><geom size="0.01"/></body></worldbody></mujoco>)");
  const auto world = load_mujoco_world(scene, "tool");
  EXPECT_TRUE(world->warnings().empty()) << world->warnings().front();
  ASSERT_EQ(world->geometry().bodies.size(), 1U);
  const Body& body = world->geometry().bodies[0];
  EXPECT_GE(body.pieces.size(), 2U);
  // The pieces stand where the mesh is: the inner corner is free, the legs are not.
  const auto distance = [&body](const Vector3& p) {
    const Shape ball = make_sphere(1e-4);
    double least = 1e300;
    for (const Shape& piece : body.pieces) {
      ClosestPointsCache cache;
      const ClosestPoints closest =
          closest_points(PlacedShape(ball, {p, Quaternion::Identity()}), PlacedShape(piece, body.X_WB), cache);
      least = std::min(least, closest.separation == Separation::kSeparated ? closest.distance : 0.0);
    }
    return least;
  };
  EXPECT_GT(distance({0.04, 0.04, 0.015}), 0.015);
  EXPECT_EQ(distance({0.05, 0.01, 0.015}), 0.0);
  EXPECT_EQ(distance({0.01, 0.05, 0.015}), 0.0);
}

TEST(ConvexSplit, TheProgramTellsOfBadMeshesAndMissingNode) {
  const TemporaryFolder folder;
  const std::string mesh = folder.write("angle.obj", kAngle), bad = folder.write("bad.obj", "v 0 0\n");
  ProgramResult result = run_program({"split", bad});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("bad.obj:1: a vertex needs three finite numbers"));
  result = run_program({"split", (folder.path() / "gone.stl").string()});
  EXPECT_THAT(result.err, HasSubstr("no such mesh file"));
  result = run_program({"split", mesh}, "PATH=/nowhere");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("install Debian's package nodejs"));
  result = run_program({"split", mesh, "--pieces", "0"});
  EXPECT_EQ(result.exit_code, 2);
}

}  // namespace
}  // namespace tegotae
