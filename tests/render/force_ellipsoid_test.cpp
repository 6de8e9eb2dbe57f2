// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/force_ellipsoid.hpp>

#include <gtest/gtest.h>

#include <limits>
#include <random>

namespace tegotae {
namespace {

TEST(ForceEllipsoid, InsideItIsASpring) {
  const EllipsoidForce f =
      ellipsoid_force(Vector3(1e-6, 2e-6, 1e-5), Vector3(1e-6, 1e-6, 1e-3), Vector3(10.0, 10.0, 1.0));
  EXPECT_FALSE(f.on_boundary);
  EXPECT_LT((f.force - Vector3(1.0, 2.0, 0.01)).norm(), 1e-14);
  EXPECT_LT((f.stiffness.diagonal() - Vector3(1e6, 1e6, 1e3)).norm(), 1e-6);
}

TEST(ForceEllipsoid, RoundBoundIsRadialReturn) {
  const Vector3 s(3e-3, 4e-3, 0.0);
  const EllipsoidForce f = ellipsoid_force(s, Vector3::Constant(1e-6), Vector3::Constant(2.0));
  EXPECT_TRUE(f.on_boundary);
  EXPECT_LT((f.force - 2.0 * s.normalized()).norm(), 1e-13);
}

TEST(ForceEllipsoid, BoundaryForcesAreProjections) {
  // Optimality of the projection: on the boundary, and s - C lambda along the outward normal.
  std::mt19937 engine(1);
  std::uniform_real_distribution<double> exponent(-4.0, 4.0);
  std::normal_distribution<double> normal;
  int slipping = 0;
  for (int i = 0; i < 20000; ++i) {
    Vector3 s, c, r;
    for (int j = 0; j < 3; ++j) {
      c[j] = std::pow(10.0, exponent(engine));
      r[j] = std::pow(10.0, exponent(engine));
      s[j] = normal(engine) * c[j] * r[j] * std::pow(10.0, exponent(engine));
    }
    const EllipsoidForce f = ellipsoid_force(s, c, r);
    const Vector3 p = f.force.cwiseQuotient(r), e = (s - c.cwiseProduct(f.force)).cwiseProduct(r);
    const double scale = s.cwiseProduct(r).cwiseAbs().maxCoeff();
    if (!f.on_boundary) {
      EXPECT_LE(p.norm(), 1.0 + 1e-14);
      EXPECT_LE(e.norm(), 1e-14 * scale);
      continue;
    }
    ++slipping;
    EXPECT_NEAR(p.norm(), 1.0, 1e-12);
    EXPECT_GE(e.dot(p), -1e-12 * scale);
    EXPECT_LE((e - e.dot(p) * p).norm(), 1e-11 * scale);
  }
  EXPECT_GT(slipping, 5000);
}

TEST(ForceEllipsoid, StiffnessIsTheDerivative) {
  const Vector3 c(2e-6, 3e-6, 1e-3), r(1.0, 2.0, 0.05);
  for (const Vector3& s : {Vector3(1e-5, -2e-5, 3e-4), Vector3(1e-7, 1e-7, 1e-6), Vector3(0.0, 5e-5, 0.0)}) {
    const EllipsoidForce f = ellipsoid_force(s, c, r);
    for (int j = 0; j < 3; ++j) {
      const double step = 1e-5 * s.norm();
      const Vector3 d = step * Vector3::Unit(j);
      const Vector3 difference =
          (ellipsoid_force(s + d, c, r).force - ellipsoid_force(s - d, c, r).force) / (2.0 * step);
      EXPECT_LE((difference - f.stiffness.col(j)).norm(), 1e-6 * f.stiffness.norm() + 1e-6);
    }
  }
}

TEST(ForceEllipsoid, ZeroAndInfiniteRadii) {
  const double infinity = std::numeric_limits<double>::infinity();
  const EllipsoidForce none = ellipsoid_force(Vector3::Ones(), Vector3::Ones(), Vector3::Zero());
  EXPECT_EQ(none.force, Vector3::Zero());
  EXPECT_EQ(none.stiffness, Matrix3::Zero());
  const EllipsoidForce mixed =
      ellipsoid_force(Vector3(3.0, 5.0, 7.0), Vector3(1.0, 2.0, 1.0), Vector3(1.0, infinity, 0.0));
  EXPECT_NEAR(mixed.force[0], 1.0, 1e-14);
  EXPECT_NEAR(mixed.force[1], 2.5, 1e-14);
  EXPECT_EQ(mixed.force[2], 0.0);
  EXPECT_NEAR(mixed.stiffness(1, 1), 0.5, 1e-14);
}

}  // namespace
}  // namespace tegotae
