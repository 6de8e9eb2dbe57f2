// SPDX-License-Identifier: Apache-2.0
#include <tegotae/shape/mass_properties.hpp>

#include <tests/random_shapes.hpp>

#include <gtest/gtest.h>

#include <numbers>

namespace tegotae {
namespace {

constexpr double kPi = std::numbers::pi;

TEST(MassProperties, CubeGyrationLengthIsEdgeOverRootSix) {
  const MassProperties cube = mass_properties(make_box(Vector3::Constant(0.1)), 1000.0);
  EXPECT_NEAR(cube.mass, 8.0, 1e-12);
  EXPECT_NEAR(cube.gyration_length(), 0.2 / std::sqrt(6.0), 1e-15);
}

TEST(MassProperties, HullOfABoxIsTheBox) {
  std::mt19937_64 random(31);
  const Pose X_BS = test::random_pose(random, 0.3);
  const Shape box = make_box({0.1, 0.2, 0.3}, X_BS);
  const Shape hull = make_hull(box.polytope->vertices, X_BS);
  const MassProperties a = mass_properties(box, 500.0), b = mass_properties(hull, 500.0);
  EXPECT_NEAR(a.mass, b.mass, 1e-12);
  EXPECT_LT((a.centre_of_mass - b.centre_of_mass).norm(), 1e-14);
  EXPECT_LT((a.inertia - b.inertia).norm(), 1e-13);
  EXPECT_LT((a.centre_of_mass - X_BS.p).norm(), 1e-14);
}

TEST(MassProperties, ClosedFormsOfCurvedShapes) {
  const MassProperties sphere = mass_properties(make_sphere(0.2), 1.0);
  EXPECT_NEAR(sphere.mass, 4.0 / 3.0 * kPi * 0.008, 1e-15);
  EXPECT_NEAR(sphere.inertia(0, 0), 0.4 * sphere.mass * 0.04, 1e-16);
  const MassProperties cylinder = mass_properties(make_cylinder(0.1, 0.2), 1.0);
  EXPECT_NEAR(cylinder.inertia(2, 2), 0.5 * cylinder.mass * 0.01, 1e-16);
  EXPECT_NEAR(cylinder.inertia(0, 0), cylinder.mass * (3.0 * 0.01 + 0.16) / 12.0, 1e-16);
  // A capsule without length is a sphere.
  const MassProperties capsule = mass_properties(make_capsule(0.2, 1e-12), 1.0);
  EXPECT_LT((capsule.inertia - sphere.inertia).norm(), 1e-12);
}

// The stand-in polytopes are integrated by a different formula; they miss only the bulge over their faces.
TEST(MassProperties, CurvedShapesAgreeWithTheirStandIns) {
  for (const Shape& shape :
       {make_sphere(0.2), make_capsule(0.1, 0.2), make_cylinder(0.1, 0.2), make_ellipsoid({0.1, 0.2, 0.3})}) {
    const MassProperties exact = mass_properties(shape, 1.0);
    const MassProperties inscribed = mass_properties(make_hull(shape.polytope->vertices), 1.0);
    EXPECT_LT(inscribed.mass, exact.mass);
    EXPECT_GT(inscribed.mass, 0.97 * exact.mass) << name_of(shape.kind);
    EXPECT_LT((inscribed.inertia - exact.inertia).norm(), 0.05 * exact.inertia.norm()) << name_of(shape.kind);
  }
}

TEST(MassProperties, TwoHalvesMakeTheWhole) {
  const MassProperties halves[] = {
      mass_properties(make_box({0.05, 0.1, 0.1}, Pose{{-0.05, 0.0, 0.0}, Quaternion::Identity()}), 1000.0),
      mass_properties(make_box({0.05, 0.1, 0.1}, Pose{{0.05, 0.0, 0.0}, Quaternion::Identity()}), 1000.0)};
  const MassProperties whole = combined(halves), cube = mass_properties(make_box(Vector3::Constant(0.1)), 1000.0);
  EXPECT_NEAR(whole.mass, cube.mass, 1e-12);
  EXPECT_LT(whole.centre_of_mass.norm(), 1e-15);
  EXPECT_LT((whole.inertia - cube.inertia).norm(), 1e-14);
}

TEST(MassProperties, PlaneHasNone) { EXPECT_THROW(mass_properties(make_plane(), 1.0), std::invalid_argument); }

}  // namespace
}  // namespace tegotae
