// SPDX-License-Identifier: Apache-2.0
#include <tegotae/shape/bounding_box.hpp>
#include <tegotae/shape/support.hpp>

#include <tests/random_shapes.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

namespace tegotae {
namespace {

std::vector<Shape> one_of_each(std::mt19937_64& random) {
  return {make_box({0.1, 0.2, 0.3}),       make_sphere(0.2),
          make_capsule(0.1, 0.2),          make_cylinder(0.1, 0.2),
          make_ellipsoid({0.1, 0.2, 0.3}), make_hull(test::random_hull_points(random, 60, 0.3))};
}

TEST(Support, HullIsTheBestVertexFromAnyStart) {
  std::mt19937_64 random(21);
  const Shape hull = make_hull(test::random_hull_points(random, 230, 0.1));
  const auto& vertices = hull.polytope->vertices;
  std::uniform_int_distribution<int> any(0, static_cast<int>(vertices.size()) - 1);
  for (int i = 0; i < 2000; ++i) {
    const Vector3 d = test::random_unit(random);
    double best = -1.0;
    for (const auto& v : vertices) best = std::max(best, d.dot(v));
    EXPECT_EQ(d.dot(support(hull, d, any(random)).p), best);
  }
}

TEST(Support, BoxVertexNumbersAreThoseOfItsPolytope) {
  std::mt19937_64 random(22);
  const Shape box = make_box({0.1, 0.2, 0.3});
  for (int i = 0; i < 100; ++i) {
    const SupportPoint s = support(box, test::random_unit(random));
    EXPECT_EQ(s.p, box.polytope->vertices[static_cast<size_t>(s.vertex)]);
  }
}

// The support value of a smooth shape is known; and no stand-in vertex lies further out, nor more than the stated error
// further in.
TEST(Support, CurvedShapesEncloseTheirStandInsByTheStatedError) {
  std::mt19937_64 random(23);
  for (const Shape& shape : one_of_each(random)) {
    double worst = 0.0;
    for (int i = 0; i < 3000; ++i) {
      const Vector3 d = test::random_unit(random);
      double stand_in = -1.0;
      for (const auto& v : shape.polytope->vertices) stand_in = std::max(stand_in, d.dot(v));
      const double gap = d.dot(support(shape, d).p) - stand_in;
      EXPECT_GE(gap, -1e-15) << name_of(shape.kind);
      worst = std::max(worst, gap);
    }
    EXPECT_LE(worst, shape.polytope_error + 1e-15) << name_of(shape.kind);
    if (shape.polytope_error > 0.0) {
      EXPECT_GE(worst, 0.2 * shape.polytope_error) << name_of(shape.kind);
    }
  }
}

TEST(Support, ClosedForms) {
  const Vector3 d = Vector3(1.0, -2.0, 2.0) / 3.0;
  EXPECT_NEAR(d.dot(support(make_sphere(0.2), 5.0 * d).p), 0.2, 1e-15);
  EXPECT_NEAR(d.dot(support(make_capsule(0.1, 0.2), d).p), 0.1 + 0.2 * 2.0 / 3.0, 1e-15);
  EXPECT_NEAR(d.dot(support(make_cylinder(0.1, 0.2), d).p), 0.1 * std::sqrt(5.0) / 3.0 + 0.2 * 2.0 / 3.0, 1e-15);
  const Vector3 axes(0.1, 0.2, 0.3);
  EXPECT_NEAR(d.dot(support(make_ellipsoid(axes), d).p), axes.cwiseProduct(d).norm(), 1e-15);
}

TEST(BoundingBox, IsTightAroundTheSupportPoints) {
  std::mt19937_64 random(24);
  for (Shape shape : one_of_each(random)) {
    shape.X_BS = test::random_pose(random, 0.2);
    const Pose X_WB = test::random_pose(random, 1.0);
    const BoundingBox box = bounding_box(shape, X_WB);
    const Pose X_WS = X_WB * shape.X_BS;
    for (int axis = 0; axis < 3; ++axis) {
      const Vector3 d_S = X_WS.q.conjugate() * Vector3::Unit(axis);
      EXPECT_NEAR(box.upper(axis), (X_WS * support(shape, d_S).p)(axis), 1e-14);
      EXPECT_NEAR(box.lower(axis), (X_WS * support(shape, -d_S).p)(axis), 1e-14);
    }
  }
}

TEST(BoundingBox, PlaneClosesOnlyTheSideOfAnAlignedNormal) {
  const BoundingBox level = bounding_box(make_plane(), Pose{{0.0, 0.0, 0.5}, Quaternion::Identity()});
  EXPECT_EQ(level.upper.z(), 0.5);
  EXPECT_TRUE(std::isinf(level.upper.x()) && std::isinf(level.lower.z()));
  const BoundingBox tilted =
      bounding_box(make_plane(), Pose{Vector3::Zero(), rotation_from_vector(Vector3(0.1, 0.0, 0.0))});
  EXPECT_TRUE(std::isinf(tilted.upper.z()));
}

TEST(BoundingBox, OverlapIsInclusiveAndEmptyOverlapsNothing) {
  const BoundingBox a{Vector3::Zero(), Vector3::Ones()};
  EXPECT_TRUE(a.overlaps({Vector3::Ones(), Vector3::Constant(2.0)}));
  EXPECT_FALSE(a.overlaps({Vector3(1.1, 0.0, 0.0), Vector3(2.0, 1.0, 1.0)}));
  EXPECT_TRUE(a.enlarged(0.2).overlaps({Vector3(1.1, 0.0, 0.0), Vector3(2.0, 1.0, 1.0)}));
  EXPECT_FALSE(a.overlaps(BoundingBox{}));
  EXPECT_EQ(BoundingBox{}.united(a).upper, a.upper);
}

TEST(Shape, RefusesImpossibleLengths) {
  EXPECT_THROW(make_sphere(0.0), std::invalid_argument);
  EXPECT_THROW(make_box({0.1, -0.1, 0.1}), std::invalid_argument);
  EXPECT_THROW(make_capsule(0.1, std::nan("")), std::invalid_argument);
  EXPECT_THROW(make_cylinder(0.1, -1.0), std::invalid_argument);
  EXPECT_THROW(make_ellipsoid({std::numeric_limits<double>::infinity(), 1.0, 1.0}), std::invalid_argument);
}

}  // namespace
}  // namespace tegotae
