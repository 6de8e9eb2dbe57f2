// SPDX-License-Identifier: Apache-2.0
// The renderer rests at a gap of 2e-6 m: normals and distances there and far below, on bodies of 0.2 m anywhere in the
// world.
#include <tegotae/contact/closest_points.hpp>
#include <tegotae/shape/support.hpp>

#include <tests/random_shapes.hpp>
#include <tests/sweep_size.hpp>

#include <gtest/gtest.h>

namespace tegotae::test {
namespace {

constexpr double kGaps[] = {2e-6, 1e-7, 1e-8};
const Vector3 kHalf(0.1, 0.08, 0.12);

// From the centre of a box turned by q to the middle of its lowest vertex, edge or face.
Vector3 to_lowest(const Quaternion& q) {
  const Matrix3 R = q.toRotationMatrix();
  Vector3 p = Vector3::Zero();
  for (int k = 0; k < 3; ++k) {
    if (std::abs(R(2, k)) > 1e-5) p -= std::copysign(kHalf[k], R(2, k)) * R.col(k);
  }
  return p;
}

// The pose of A in B such that the middle of A's lowest feature is `gap` over B's top face (z up), off its centre by
// `slide` along x.
Pose resting(const Quaternion& q, double slide, double gap) {
  Vector3 p = Vector3(slide, 0.0, kHalf.z() + gap) - to_lowest(q);
  // A tilt too small to count as one still lowers a corner.
  p.z() = kHalf.z() + gap + q.toRotationMatrix().row(2).cwiseAbs().dot(kHalf);
  return {p, q};
}

// Where the closest points lie on edges or vertices of the Minkowski difference the direction is their difference over
// their distance: coordinates of 0.2 m leave 1e-16 m in one, so 1e-9 rad at 2e-6 m is asked, and in proportion below.
double rounding_angle(double gap) { return 2e-15 / gap; }

struct Expectation {
  double gap;
  double distance_tolerance;
  double normal_tolerance;
};

void expect_on_top(const Shape& a, const Shape& b, const Pose& X_BA, const Expectation& expected,
                   std::mt19937_64& random) {
  const Pose X_WB = random_pose(random, 0.5);
  ClosestPointsCache cache;
  for (int repeat = 0; repeat < 2; ++repeat) {
    const ClosestPoints found = closest_points({a, X_WB * X_BA}, {b, X_WB}, cache);
    ASSERT_EQ(found.separation, Separation::kSeparated);
    ASSERT_NEAR(found.distance, expected.gap, expected.distance_tolerance);
    ASSERT_NEAR(found.lower_bound, expected.gap, expected.distance_tolerance + expected.normal_tolerance * 0.4);
    const Vector3 n = X_WB.q * Vector3::UnitZ();
    ASSERT_LT((found.n_W - n).norm(), expected.normal_tolerance);
    ASSERT_NEAR(n.dot(found.p_WA - found.p_WB), expected.gap, expected.distance_tolerance);
  }
}

Shape box_as_hull(const Shape& box) { return make_hull(box.polytope->vertices); }

// A vertex, an edge or a face of the tool over a face of the object.
void sweep_on_face(const Shape& a, const Shape& b) {
  std::mt19937_64 random(3);
  for (int i = 0; i < sweep_size(6000) && !::testing::Test::HasFatalFailure(); ++i) {
    const double gap = kGaps[random() % 3];
    const Quaternion turn = rotation_from_vector(Vector3(0.0, 0.0, uniform(random, 0.0, 3.0)));
    const Quaternion tilt = rotation_from_vector(Vector3(uniform(random, 0.1, 1.4), 0.0, 0.0));
    Quaternion q = turn;                                         // a face
    if (i % 3 == 1) q = (turn * tilt).normalized();              // an edge
    if (i % 3 == 2) q = random_rotation(random);                 // a vertex
    const double slide = i % 3 == 0 && i % 2 == 0 ? 0.15 : 0.0;  // a face may overhang
    expect_on_top(a, b, resting(q, slide, gap), {gap, 1e-15, rounding_angle(gap)}, random);
  }
}

TEST(ClosestPointsSmallGap, VertexEdgeAndFaceOverAFace) {
  const Shape box = make_box(kHalf);
  sweep_on_face(box, box);
  sweep_on_face(box_as_hull(box), box);
  sweep_on_face(box, box_as_hull(box));
}

// The same with the object's vertex, edge or face under a face of the tool: the normal is the tool's.
TEST(ClosestPointsSmallGap, RolesSwapped) {
  const Shape box = make_box(kHalf);
  std::mt19937_64 random(4);
  for (int i = 0; i < sweep_size(3000); ++i) {
    const double gap = kGaps[i % 3];
    const Pose X_AB = resting(random_rotation(random), 0.0, gap);
    const Pose X_WA = random_pose(random, 0.5);
    ClosestPointsCache cache;
    const ClosestPoints found = closest_points({box, X_WA}, {box, X_WA * X_AB}, cache);
    const Vector3 n = X_WA.q * Vector3::UnitZ();
    ASSERT_EQ(found.separation, Separation::kSeparated);
    ASSERT_NEAR(found.distance, gap, 1e-15);
    ASSERT_LT((found.n_W + n).norm(), rounding_angle(gap));
  }
}

// Crossed edges: each box stands on an edge, one above the other.
TEST(ClosestPointsSmallGap, EdgeOverEdge) {
  const Shape box = make_box(kHalf);
  std::mt19937_64 random(5);
  for (int i = 0; i < sweep_size(3000); ++i) {
    const double gap = kGaps[i % 3];
    const Quaternion tilt_a = rotation_from_vector(Vector3(uniform(random, 0.2, 1.3), 0.0, 0.0));
    const Quaternion tilt_b = rotation_from_vector(Vector3(uniform(random, 0.2, 1.3), 0.0, 0.0));
    const Quaternion turn = rotation_from_vector(Vector3(0.0, 0.0, uniform(random, 0.05, 3.0)));
    const Quaternion q_a = (turn * tilt_a).normalized();
    const Pose X_GB = {to_lowest(tilt_b), tilt_b};  // its highest edge is opposite its lowest
    const Pose X_GA = {Vector3(0.0, 0.0, gap) - to_lowest(q_a), q_a};
    const Pose X_WG = random_pose(random, 0.3);
    ClosestPointsCache cache;
    const ClosestPoints found = closest_points({box, X_WG * X_GA}, {box, X_WG * X_GB}, cache);
    ASSERT_EQ(found.separation, Separation::kSeparated);
    ASSERT_NEAR(found.distance, gap, 1e-15);
    ASSERT_LT((found.n_W - X_WG.q * Vector3::UnitZ()).norm(), rounding_angle(gap));
    ASSERT_LT((found.p_WA - X_WG.p).norm(), 3e-6);
  }
}

// Faces that are parallel within a tiny angle: the normal must be as near to the face's as that angle.
TEST(ClosestPointsSmallGap, NearlyParallelFacesKeepTheirNormalFromTickToTick) {
  const Shape box = make_box(kHalf);
  std::mt19937_64 random(6);
  for (const double angle : {1e-9, 1e-8, 1e-7, 1e-6}) {
    for (int i = 0; i < sweep_size(1000); ++i) {
      const Quaternion q = rotation_from_vector(Vector3(angle * random_unit(random)));
      const Pose X_BA = resting(q, uniform(random, -0.15, 0.15), 2e-6);
      const Pose X_WB = random_pose(random, 0.5);
      ClosestPointsCache cache;
      const ClosestPoints found = closest_points({box, X_WB * X_BA}, {box, X_WB}, cache);
      ASSERT_EQ(found.separation, Separation::kSeparated);
      ASSERT_GT(found.distance, 1.9e-6);
      ASSERT_LT((found.n_W - X_WB.q * Vector3::UnitZ()).norm(), 1.001 * angle + 1e-10);
    }
  }
}

// Curved shapes over a box face: the normal is the face's, found through the support function alone.
TEST(ClosestPointsSmallGap, CurvedShapesOverAFace) {
  const Shape box = make_box(kHalf);
  const Vector3 axes(0.04, 0.06, 0.1);
  const Shape shapes[] = {make_sphere(0.05), make_capsule(0.03, 0.05), make_ellipsoid(axes), make_cylinder(0.04, 0.06)};
  std::mt19937_64 random(7);
  for (int i = 0; i < sweep_size(8000); ++i) {
    const Shape& shape = shapes[i % 4];
    const double gap = kGaps[random() % 3];
    const Quaternion q = random_rotation(random);
    const Vector3 lowest = q * support(shape, q.conjugate() * Vector3(0.0, 0.0, -1.0)).p;
    const Pose X_BA = {Vector3(0.0, 0.0, kHalf.z() + gap) - lowest, q};
    expect_on_top(shape, box, X_BA, {gap, 1e-3 * gap, 1e-7}, random);
    ASSERT_FALSE(HasFatalFailure()) << name_of(shape.kind) << " at a gap of " << gap << " m, case " << i;
  }
}

}  // namespace
}  // namespace tegotae::test
