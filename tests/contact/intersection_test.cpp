// SPDX-License-Identifier: Apache-2.0
#include <tegotae/contact/interior_point.hpp>
#include <tegotae/contact/intersection.hpp>
#include <tegotae/contact/tolerances.hpp>

#include <tests/contact/half_space_oracle.hpp>
#include <tests/contact/intersection_cases.hpp>
#include <tests/random_shapes.hpp>
#include <tests/sweep_size.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace tegotae {
namespace {

using test::IntersectionCase;
using test::kSame;
using test::points_of;

TEST(Intersection, TenThousandRandomPairsAgreeWithQhull) {
  std::mt19937_64 random(20);
  ClipWorkspace workspace(256, 512);
  int overlapping = 0, apart = 0, dilated = 0;
  for (int i = 0; i < test::sweep_size(10000); ++i) {
    const IntersectionCase pair = test::random_case(random);
    SCOPED_TRACE(::testing::Message() << "pair " << i << ": " << name_of(pair.tool.kind) << " in "
                                      << name_of(pair.object.kind) << " dilated by " << pair.dilation.transpose());
    const auto half_spaces = test::half_spaces_of(pair.placed_tool(), pair.placed_object(), pair.dilation);
    const auto clipped = test::clip(pair, workspace);
    const InteriorPoint inner = interior_point(pair.placed_tool(), pair.placed_object(), pair.dilation);
    if (!inner.exists) {
      EXPECT_TRUE(clipped.empty());
      ++apart;
      continue;
    }
    EXPECT_NEAR(test::least_slack(half_spaces, inner.p_W), inner.slack, 1e-12);
    // Where hardly anything is shared, 1e-9 m tells nothing about vertices.
    if (inner.slack < 1e-6) continue;
    const auto reference = test::vertices_by_qhull(half_spaces, inner.p_W);
    ASSERT_TRUE(reference.has_value());
    const auto expected = test::merged(*reference, 1e-8);
    std::vector<IntersectionVertex> dual;
    ASSERT_TRUE(intersection_by_duality(pair.placed_tool(), pair.placed_object(), pair.dilation, dual));
    EXPECT_LT(test::set_distance(points_of(clipped), expected), kSame) << clipped.size() << " / " << expected.size();
    EXPECT_LT(test::set_distance(points_of(dual), expected), kSame) << dual.size() << " / " << expected.size();
    EXPECT_TRUE(test::features_differ(clipped));
    ++overlapping;
    dilated += pair.dilation.norm() > 0.0 ? 1 : 0;
  }
  EXPECT_GT(overlapping, test::sweep_size(5000));
  EXPECT_GT(dilated, test::sweep_size(2000));
  EXPECT_GT(apart, test::sweep_size(100));
}

TEST(Intersection, QhullAgreesWithEveryThreePlanes) {
  std::mt19937_64 random(21);
  ClipWorkspace workspace(64, 128);
  int compared = 0;
  for (int i = 0; i < test::sweep_size(300); ++i) {
    const IntersectionCase pair = test::random_small_case(random);
    const InteriorPoint inner = interior_point(pair.placed_tool(), pair.placed_object(), pair.dilation);
    if (!inner.exists || inner.slack < 1e-6) continue;
    const auto half_spaces = test::half_spaces_of(pair.placed_tool(), pair.placed_object(), pair.dilation);
    const auto expected = test::merged(test::vertices_by_triples(half_spaces, 1e-11), kSame);
    EXPECT_LT(test::set_distance(points_of(test::clip(pair, workspace)), expected), kSame) << "pair " << i;
    ++compared;
  }
  EXPECT_GT(compared, test::sweep_size(150));
}

TEST(Intersection, InteriorPointIsTheCentreOfTheGreatestBall) {
  std::mt19937_64 random(22);
  for (int i = 0; i < test::sweep_size(1000); ++i) {
    const IntersectionCase pair = test::random_case(random);
    const InteriorPoint inner = interior_point(pair.placed_tool(), pair.placed_object(), pair.dilation);
    if (!inner.exists) continue;
    const auto half_spaces = test::half_spaces_of(pair.placed_tool(), pair.placed_object(), pair.dilation);
    // The program is concave: no better point nearby, no better point anywhere.
    for (int k = 0; k < 50; ++k) {
      const Vector3 other = inner.p_W + (k % 2 == 0 ? 1e-4 : 1e-1) * test::random_unit(random);
      EXPECT_LE(test::least_slack(half_spaces, other), inner.slack + 1e-12);
    }
  }
}

// A cube over a floor, apart by a gap: dilated by the gap and a margin, they share a slab as thick as the margin.
TEST(Intersection, InteriorPointOfShapesApartNeedsOnlyTheGapAndTheMargin) {
  const Shape cube = make_box({0.1, 0.1, 0.1}), floor = make_plane();
  for (const double gap : {1e-6, 1e-3, 0.5}) {
    const double margin = 1e-4;
    const PlacedShape tool(cube, {{0.3, -0.2, 0.1 + gap}, Quaternion::Identity()}), object(floor, {});
    EXPECT_FALSE(interior_point(tool, object, Vector3::Zero()).exists);
    EXPECT_FALSE(interior_point(tool, object, Vector3(0.0, 0.0, 0.999 * gap)).exists);
    const InteriorPoint inner = interior_point(tool, object, Vector3(0.0, 0.0, gap + margin));
    ASSERT_TRUE(inner.exists);
    EXPECT_NEAR(inner.slack, 0.5 * margin, 1e-12);
    EXPECT_NEAR(inner.p_W.z(), gap + 0.5 * margin, 1e-12);
    std::vector<IntersectionVertex> vertices;
    ASSERT_TRUE(intersection_by_duality(tool, object, Vector3(0.0, 0.0, gap + margin), vertices));
    EXPECT_EQ(vertices.size(), 8u);
  }
}

TEST(Intersection, TheOriginOfTheDualFormMustLieInsideBoth) {
  const Shape cube = make_box({0.1, 0.1, 0.1});
  const PlacedShape tool(cube, {{0.1, 0.0, 0.0}, Quaternion::Identity()}), object(cube, {});
  std::vector<IntersectionVertex> vertices;
  EXPECT_FALSE(intersection_by_duality(tool, object, Vector3::Zero(), {-0.05, 0.0, 0.0}, vertices));
  EXPECT_FALSE(intersection_by_duality(tool, object, Vector3::Zero(), {0.0, 0.0, 0.0}, vertices))
      << "on the tool's boundary";
  EXPECT_FALSE(intersection_by_duality(tool, object, Vector3::Zero(), Vector3::Constant(std::nan("")), vertices));
  EXPECT_TRUE(vertices.empty());
  // An origin near a corner serves as well as one in the middle.
  for (const double depth : {0.05, 1e-3, 1e-6}) {
    vertices.clear();
    EXPECT_TRUE(
        intersection_by_duality(tool, object, Vector3::Zero(), Vector3(depth, -0.1 + depth, 0.1 - depth), vertices));
    EXPECT_EQ(vertices.size(), 8u);
    for (const auto& vertex : vertices) EXPECT_NEAR(std::abs(vertex.p_W.y()), 0.1, 1e-12);
  }
}

TEST(Intersection, PrecisionDoesNotDependOnThePlaceInTheWorld) {
  std::mt19937_64 random(23);
  ClipWorkspace workspace(256, 512);
  const Vector3 away(600.0, -640.0, 480.0);  // 1 km; positions there are rounded to 1.1e-13 m
  int compared = 0;
  for (int i = 0; i < test::sweep_size(500); ++i) {
    IntersectionCase pair = test::random_case(random);
    const InteriorPoint inner = interior_point(pair.placed_tool(), pair.placed_object(), pair.dilation);
    if (!inner.exists || inner.slack < 1e-4 || !pair.object.is_bounded()) continue;
    const auto near = points_of(test::clip(pair, workspace));
    pair.X_WT.p += away;
    pair.X_WO.p += away;
    auto far = points_of(test::clip(pair, workspace));
    for (Vector3& p : far) p -= away;
    EXPECT_LT(test::set_distance(near, far), 1e-10) << "pair " << i;
    ++compared;
  }
  EXPECT_GT(compared, test::sweep_size(200));
}

TEST(Intersection, CurvedShapesAreTakenAsTheirStandIns) {
  ClipWorkspace workspace(2048, 4096);
  const Shape ball = make_sphere(0.1), can = make_cylinder(0.05, 0.1), floor = make_plane();
  for (const Shape* tool : {&ball, &can}) {
    for (const Shape* object : {&ball, &can, &floor}) {
      for (const Vector3& dilation : {Vector3(0, 0, 0), Vector3(0.001, 0, 0.003), Vector3(-0.02, 0.01, 0.04)}) {
        SCOPED_TRACE(::testing::Message()
                     << name_of(tool->kind) << " in " << name_of(object->kind) << " dilated by " << dilation);
        const IntersectionCase pair{
            *tool, *object, {{0.03, 0.02, 0.05}, Quaternion(0.9, 0.1, 0.2, 0.3).normalized()}, {}, dilation};
        const auto clipped = test::clip(pair, workspace);
        std::vector<IntersectionVertex> dual;
        ASSERT_TRUE(intersection_by_duality(pair.placed_tool(), pair.placed_object(), dilation, dual));
        EXPECT_GT(clipped.size(), 8u);
        EXPECT_LT(test::set_distance(points_of(clipped), points_of(dual)), kSame)
            << clipped.size() << " / " << dual.size();
      }
    }
  }
}

TEST(Intersection, RefusesWhatIsNotValid) {
  const Shape cube = make_box({0.1, 0.1, 0.1}), floor = make_plane();
  ClipWorkspace workspace(8, 6);
  std::vector<IntersectionVertex> vertices(64), dual;
  const double nan = std::nan("");
  const Pose broken{{nan, 0.0, 0.0}, Quaternion::Identity()}, turned{{}, Quaternion(nan, 0.0, 0.0, 0.0)};
  const PlacedShape good(cube, {});
  for (const Pose& X : {broken, turned}) {
    const PlacedShape bad(cube, X);
    EXPECT_EQ(intersection_by_clipping(bad, good, Vector3::Zero(), workspace, vertices), 0);
    EXPECT_EQ(intersection_by_clipping(good, bad, Vector3::Zero(), workspace, vertices), 0);
    EXPECT_FALSE(intersection_by_duality(bad, good, Vector3::Zero(), dual));
    EXPECT_FALSE(intersection_by_duality(good, bad, Vector3::Zero(), Vector3::Zero(), dual));
    EXPECT_FALSE(interior_point(good, bad, Vector3::Zero()).exists);
  }
  for (const double broken_length : {nan, std::numeric_limits<double>::infinity()}) {
    const Vector3 dilation(0.0, broken_length, 0.0);
    EXPECT_EQ(intersection_by_clipping(good, good, dilation, workspace, vertices), 0);
    EXPECT_FALSE(intersection_by_duality(good, good, dilation, Vector3::Zero(), dual));
    EXPECT_FALSE(interior_point(good, good, dilation).exists);
  }
  EXPECT_EQ(intersection_by_clipping(PlacedShape(floor, {}), good, Vector3::Zero(), workspace, vertices), 0);
  EXPECT_FALSE(intersection_by_duality(PlacedShape(floor, {}), good, Vector3::Zero(), dual));
  EXPECT_TRUE(dual.empty());
  EXPECT_EQ(intersection_by_clipping(PlacedShape(make_sphere(0.1), {}), good, Vector3::Zero(), workspace, vertices),
            kClipWorkspaceTooSmall);
  EXPECT_THROW(ClipWorkspace(0, 6), std::invalid_argument);
  EXPECT_THROW(ClipWorkspace(8, IntersectionFeature::kIndexLimit), std::invalid_argument);
}

TEST(Intersection, SaysHowManyVerticesDidNotFit) {
  const Shape cube = make_box({0.1, 0.1, 0.1});
  ClipWorkspace workspace(8, 6);
  const PlacedShape tool(cube, {{0.05, 0.05, 0.05}, Quaternion::Identity()}), object(cube, {});
  std::vector<IntersectionVertex> vertices(3, {Vector3::Constant(7.0), 0});
  EXPECT_EQ(intersection_by_clipping(tool, object, Vector3::Zero(), workspace, {vertices.data(), 2}), 8);
  EXPECT_NE(vertices[1].p_W.x(), 7.0);
  EXPECT_EQ(vertices[2].p_W.x(), 7.0);
}

}  // namespace
}  // namespace tegotae
