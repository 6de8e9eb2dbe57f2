// SPDX-License-Identifier: Apache-2.0
#include <tegotae/contact/interior_point.hpp>
#include <tegotae/contact/intersection.hpp>

#include <tests/contact/half_space_oracle.hpp>
#include <tests/contact/intersection_cases.hpp>
#include <tests/sweep_size.hpp>

#include <gtest/gtest.h>

#include <numbers>
#include <ostream>
#include <string>

namespace tegotae {
namespace {

using test::IntersectionCase;
using test::kSame;

struct DegenerateCase {
  std::string name;
  IntersectionCase pair;  // before both are moved together
  size_t vertices = 0;    // of the closed intersection
};

Quaternion about(const Vector3& axis, double degrees) {
  return rotation_from_vector(degrees * std::numbers::pi / 180.0 * axis.normalized());
}

Shape tetrahedron() {
  const std::vector<Vector3> points{{0, 0, 0}, {0.6, 0, 0}, {0, 0.6, 0}, {0, 0, 0.6}};
  return make_hull(points);
}

Shape octahedron(double radius) {
  const std::vector<Vector3> points{{radius, 0, 0},  {-radius, 0, 0}, {0, radius, 0},
                                    {0, -radius, 0}, {0, 0, radius},  {0, 0, -radius}};
  return make_hull(points);
}

std::vector<DegenerateCase> degenerate_cases() {
  const Vector3 none = Vector3::Zero();
  const Quaternion same = Quaternion::Identity(), diamond = about({0, 0, 1}, 45.0);
  const Shape cube = make_box({0.5, 0.5, 0.5}), small = make_box({0.3, 0.3, 0.3}), thin = make_box({0.1, 0.8, 0.5});
  std::mt19937_64 random(40);
  const Shape hull = make_hull(test::random_hull_points(random, 20, 1.0));
  const double half_diagonal = 0.5 * std::numbers::sqrt2;
  return {
      {"face to face, same size, touching", {cube, cube, {{0, 0, 1.0}, same}, {}, none}, 4},
      {"face to face, same size, sunk in", {cube, cube, {{0, 0, 0.9}, same}, {}, none}, 8},
      {"face to face, same size, apart but dilated", {cube, cube, {{0, 0, 1.1}, same}, {}, {0, 0, 0.2}}, 8},
      {"face to face, other size, touching", {small, cube, {{0.1, 0.05, 0.8}, same}, {}, none}, 4},
      {"face to face, other size, turned", {small, cube, {{0.1, 0, 0.8}, about({0, 0, 1}, 20.0)}, {}, none}, 4},
      {"face to face, the larger on top", {cube, small, {{0.1, 0.05, 0.8}, same}, {}, none}, 4},
      {"face to face, overhanging", {cube, cube, {{0.3, 0.2, 1.0}, same}, {}, none}, 4},
      {"coplanar sides", {cube, cube, {{0.4, 0, 0}, same}, {}, none}, 8},
      {"coplanar sides, a smaller tool in a corner", {small, cube, {{0.2, 0.2, 0.2}, same}, {}, none}, 8},
      {"coplanar top and bottom, turned", {cube, cube, {{0, 0, 0}, diamond}, {}, none}, 16},
      {"coplanar sides, crossing", {thin, cube, {{0.1, 0, 0}, same}, {}, none}, 8},
      {"a box with itself", {cube, cube, {}, {}, none}, 8},
      {"a hull with itself", {hull, hull, {}, {}, none}, 20},
      {"an octahedron with itself", {octahedron(0.5), octahedron(0.5), {}, {}, none}, 6},
      {"a cube turned by a right angle in itself", {cube, cube, {none, about({0, 1, 0}, 90.0)}, {}, none}, 8},
      {"shared edge, touching", {cube, cube, {{1.0, 1.0, 0}, same}, {}, none}, 2},
      {"shared edge, partly", {cube, cube, {{1.0, 1.0, 0.3}, same}, {}, none}, 2},
      {"shared edge, overlapping", {tetrahedron(), cube, {{-0.5, -0.5, -0.2}, same}, {}, none}, 4},
      {"an edge along a face", {cube, cube, {{0, 0, 0.5 + half_diagonal}, about({1, 0, 0}, 45.0)}, {}, none}, 2},
      {"shared vertex, touching", {cube, cube, {{1.0, 1.0, 1.0}, same}, {}, none}, 1},
      {"shared vertex, overlapping", {tetrahedron(), cube, {{-0.5, -0.5, -0.5}, same}, {}, none}, 4},
      {"vertex on face, touching", {octahedron(0.4), cube, {{0.1, 0.2, 0.9}, same}, {}, none}, 1},
      {"vertex on face, from inside", {octahedron(0.4), cube, {{0.05, 0, 0.1}, same}, {}, none}, 6},
      {"edge on edge, touching", {cube, cube, {{0, half_diagonal + 0.5, 1.0}, diamond}, {}, none}, 1},
      {"edge on edge, crossing in a face's plane", {cube, cube, {{0.6, 0, 0}, diamond}, {}, none}, 10},
      {"contained entirely", {small, cube, {{0.05, 0.02, -0.1}, diamond}, {}, none}, 8},
      {"containing entirely", {cube, small, {{0.05, 0.02, -0.1}, diamond}, {}, none}, 8},
      {"contained, touching a side", {small, cube, {{0.2, 0, 0}, same}, {}, none}, 8},
      {"apart", {cube, cube, {{1.0 + 1e-6, 0, 0}, same}, {}, none}, 0},
      {"on a floor", {cube, make_plane(), {{0, 0, 0.5}, same}, {}, none}, 4},
      {"in a floor to its top", {cube, make_plane(), {{0, 0, -0.5}, same}, {}, none}, 8},
      {"a corner on a floor", {octahedron(0.4), make_plane(), {{0, 0, 0.4}, same}, {}, none}, 1},
  };
}

void PrintTo(const DegenerateCase& degenerate, std::ostream* out) { *out << degenerate.name; }

class IntersectionDegenerate : public ::testing::TestWithParam<DegenerateCase> {};

// Moved about together: the coordinates are then rounded in ever other ways, the answer is to stay.
TEST_P(IntersectionDegenerate, LosesNoVertexAndGivesNoneTwice) {
  std::mt19937_64 random(41);
  ClipWorkspace workspace(64, 64);
  const int motions = test::sweep_size(60);
  for (int motion = 0; motion < motions; ++motion) {
    SCOPED_TRACE(motion);
    IntersectionCase pair = GetParam().pair;
    const Pose X = motion == 0 ? Pose{} : test::random_pose(random, 2.0);
    pair.X_WT = X * pair.X_WT;
    pair.X_WO = X * pair.X_WO;
    pair.dilation = X.q * pair.dilation;
    const auto half_spaces = test::half_spaces_of(pair.placed_tool(), pair.placed_object(), pair.dilation);
    const auto expected = test::merged(test::vertices_by_triples(half_spaces, 1e-11), kSame);
    ASSERT_EQ(expected.size(), GetParam().vertices) << "the oracle itself";
    const auto clipped = test::clip(pair, workspace);
    EXPECT_LE(test::set_distance(test::points_of(clipped), expected), kSame) << clipped.size();
    EXPECT_TRUE(test::features_differ(clipped));
    std::vector<IntersectionVertex> dual;
    const InteriorPoint inner = interior_point(pair.placed_tool(), pair.placed_object(), pair.dilation);
    EXPECT_EQ(intersection_by_duality(pair.placed_tool(), pair.placed_object(), pair.dilation, dual), inner.exists);
    if (inner.exists) {
      EXPECT_LE(test::set_distance(test::points_of(dual), expected), kSame) << dual.size();
    }
  }
}

std::string test_name(const ::testing::TestParamInfo<DegenerateCase>& info) {
  std::string name;
  for (const char c : info.param.name) {
    if (c != ',' && c != '\'') name += c == ' ' ? '_' : c;
  }
  return name;
}

INSTANTIATE_TEST_SUITE_P(Cases, IntersectionDegenerate, ::testing::ValuesIn(degenerate_cases()), test_name);

}  // namespace
}  // namespace tegotae
