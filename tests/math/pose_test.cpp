// SPDX-License-Identifier: Apache-2.0
#include <tegotae/math/plain.hpp>
#include <tegotae/math/pose.hpp>
#include <tegotae/math/rotation.hpp>

#include <gtest/gtest.h>

namespace tegotae {
namespace {

Pose example_pose() { return {Vector3(0.1, -0.2, 0.3), rotation_from_vector(Vector3(0.4, -1.0, 0.7))}; }

TEST(Pose, InverseUndoes) {
  const Pose X = example_pose();
  const Vector3 p(1.0, 2.0, 3.0);
  EXPECT_LT((X.inverse() * (X * p) - p).norm(), 1e-14);
  EXPECT_LT(((X * X.inverse()).p).norm(), 1e-15);
}

TEST(Pose, InterpolationEndsAtItsArgumentsAndTakesTheShortArc) {
  const Pose a = example_pose();
  Pose b = displaced(a, a.p, Vector3(0.2, 0.0, 0.0), Vector3(0.0, 0.5, 0.0));
  b.q.coeffs() = -b.q.coeffs();
  EXPECT_LT(displacement(a, interpolate(a, b, 0.0), Vector3::Zero()).norm(), 1e-14);
  EXPECT_LT(displacement(b, interpolate(a, b, 1.0), Vector3::Zero()).norm(), 1e-14);
  const Vector6 half = displacement(a, interpolate(a, b, 0.5), Vector3::Zero());
  EXPECT_NEAR(half(0), 0.1, 1e-14);
  EXPECT_NEAR(half(4), 0.25, 1e-14);
}

TEST(Pose, DisplacementIsInverseOfDisplaced) {
  const Pose X = example_pose();
  const Vector3 centre_B(0.05, 0.02, -0.03), dr(1e-3, -2e-3, 3e-3), dtheta(0.1, 0.2, -0.3);
  const Vector6 d = displacement(X, displaced(X, X * centre_B, dr, dtheta), centre_B);
  EXPECT_LT((d.head<3>() - dr).norm(), 1e-15);
  EXPECT_LT((d.tail<3>() - dtheta).norm(), 1e-14);
}

TEST(Pose, PlainTwinsKeepEveryBit) {
  const Pose X = example_pose();
  const Pose back = PlainPose(X);
  EXPECT_EQ(back.p, X.p);
  EXPECT_EQ(back.q.coeffs(), X.q.coeffs());
}

TEST(Wrench, ShiftedKeepsTheMomentOfTheForce) {
  const Wrench at_origin{Vector3(0.0, 0.0, 2.0), Vector3::Zero()};
  const Wrench about_point = at_origin.shifted(Vector3(1.0, 0.0, 0.0));
  EXPECT_EQ(about_point.torque, Vector3(0.0, -2.0, 0.0));
}

TEST(Twist, VelocityOfAPoint) {
  const Twist V{Vector3(1.0, 0.0, 0.0), Vector3(0.0, 0.0, 2.0)};
  EXPECT_EQ(V.at(Vector3(0.0, 1.0, 0.0)), Vector3(-1.0, 0.0, 0.0));
}

}  // namespace
}  // namespace tegotae
