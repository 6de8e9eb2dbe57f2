// SPDX-License-Identifier: Apache-2.0
#include <tegotae/contact/penetration_polytope.hpp>

#include <tests/random_shapes.hpp>

#include <gtest/gtest.h>

#include <algorithm>

namespace tegotae::gjk {
namespace {

constexpr double kCoplanar = 1e-14;

const std::array<Vector3, 4> kTetrahedron = {Vector3(1.0, 0.0, -0.5), Vector3(-0.5, 0.8, -0.5),
                                             Vector3(-0.5, -0.8, -0.5), Vector3(0.0, 0.0, 1.0)};

TEST(GrowingPolytope, StartsWithOutwardFacesWhateverTheOrderOfCorners) {
  std::array<int, 4> order = {0, 1, 2, 3};
  do {
    GrowingPolytope polytope(kCoplanar);
    std::array<Vector3, 4> corner;
    for (size_t k = 0; k < 4; ++k) corner[k] = kTetrahedron[static_cast<size_t>(order[k])];
    ASSERT_TRUE(polytope.start(corner));
    EXPECT_GT(polytope.nearest_face().d, 0.1);
    EXPECT_NEAR(polytope.nearest_face().n.norm(), 1.0, 1e-15);
  } while (std::next_permutation(order.begin(), order.end()));
}

TEST(GrowingPolytope, RefusesAFlatStart) {
  GrowingPolytope polytope(kCoplanar);
  EXPECT_FALSE(
      polytope.start({Vector3(0.0, 0.0, 0.0), Vector3(0.0, 0.0, 0.0), Vector3(0.0, 1.0, 0.0), Vector3(1.0, 1.0, 0.0)}));
}

// Grown by the nearest face's own direction on the unit sphere, the nearest face moves out towards the sphere.
TEST(GrowingPolytope, NearestFaceNeverComesCloserAndStopsAtTheCapacity) {
  GrowingPolytope polytope(kCoplanar);
  std::array<Vector3, 4> corner = kTetrahedron;
  for (Vector3& p : corner) p.normalize();
  ASSERT_TRUE(polytope.start(corner));
  double nearest = polytope.nearest_face().d;
  int grown = 0;
  for (;; ++grown) {
    const GrowingPolytope::Face& face = polytope.nearest_face();
    EXPECT_GE(face.d, nearest - 1e-15);
    nearest = face.d;
    const Vector3 direction = face.n;
    if (!polytope.grow(face, direction)) break;
  }
  EXPECT_EQ(grown, GrowingPolytope::kMaxPoints - 4);
  EXPECT_GT(nearest, 0.97);
}

// The corners of a cube: each new corner is coplanar with faces that stand, which must not leave flat triangles.
TEST(GrowingPolytope, CoplanarPointsOfACube) {
  std::mt19937_64 random(1);
  for (int trial = 0; trial < 200; ++trial) {
    const Quaternion q = trial == 0 ? Quaternion(1.0, 0.0, 0.0, 0.0) : tegotae::test::random_rotation(random);
    const auto corner_along = [&](const Vector3& n) {
      const Vector3 n_C = q.conjugate() * n;
      return Vector3(q * Vector3(n_C.x() > 0.0 ? 1.0 : -1.0, n_C.y() > 0.0 ? 1.0 : -1.0, n_C.z() > 0.0 ? 1.0 : -1.0));
    };
    GrowingPolytope polytope(kCoplanar);
    ASSERT_TRUE(polytope.start({Vector3(q * Vector3(1.0, 1.0, 1.0)), Vector3(q * Vector3(-1.0, -1.0, 1.0)),
                                Vector3(q * Vector3(-1.0, 1.0, -1.0)), Vector3(q * Vector3(1.0, -1.0, -1.0))}));
    for (int k = 0; k < 4; ++k) {
      const GrowingPolytope::Face& face = polytope.nearest_face();
      const Vector3 p = corner_along(face.n);
      if (face.n.dot(p) - face.d <= kCoplanar) break;
      ASSERT_TRUE(polytope.grow(face, p));
    }
    EXPECT_NEAR(polytope.nearest_face().d, 1.0, 1e-14);
  }
}

}  // namespace
}  // namespace tegotae::gjk
