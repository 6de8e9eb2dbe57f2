// SPDX-License-Identifier: Apache-2.0
// Friction of the proxy method against Coulomb's law.
#include <tests/render/proxy_rig.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tegotae::test {
namespace {

constexpr double kHalf = 0.02;  // m, of the tool

ProxyRig block_on_floor(double mu) {
  ProxyRig rig({make_box(Vector3::Constant(kHalf))});
  rig.add_body(make_plane());
  rig.parameters.friction = mu;
  return rig;
}

// Drags the tool along x at 0.1 m/s, turned by `rotation`, its lowest point `depth` below the floor.
const Wrench& drag(ProxyRig& rig, const Vector3& rotation, double height, double depth, int ticks) {
  rig.tick(at({0.0, 0.0, height + 1e-4}, rotation));
  for (int i = 0; i < ticks; ++i) rig.tick(at({1e-4 * i, 0.0, height - depth}, rotation));
  return rig.output.wrench;
}

TEST(ProxyFriction, DragIsMuTimesNormalForceOnFaceEdgeAndVertex) {
  for (const double mu : {0.2, 0.5, 1.0}) {
    const Vector3 face = Vector3::Zero(), edge(0.5, 0.0, 0.0);
    const Quaternion on_corner = Quaternion::FromTwoVectors(Vector3(1.0, 1.1, 0.9), -Vector3::UnitZ());
    const Vector3 vertex = rotation_vector(on_corner);
    const double heights[] = {kHalf, kHalf * (std::cos(0.5) + std::sin(0.5)), 0.0};
    int i = 0;
    for (const Vector3& rotation : {face, edge, vertex}) {
      ProxyRig rig = block_on_floor(mu);
      const Matrix3 R = rotation_from_vector(rotation).toRotationMatrix();
      const double height = i == 2 ? kHalf * R.row(2).cwiseAbs().sum() : heights[i];
      const Wrench wrench = drag(rig, rotation, height, 1e-3, 400);
      EXPECT_NEAR(wrench.force.head<2>().norm(), mu * wrench.force.z(), 0.01 * mu * wrench.force.z()) << mu << " " << i;
      EXPECT_LT(wrench.force.x(), 0.0);
      if (i == 0) {
        EXPECT_NEAR(wrench.force.z(), ProxyRig::kStiffness * 1.002e-3, 0.01 * 9.0);
      }
      ++i;
    }
  }
}

// Dragged on an edge across it: both forces have lever arms about the centre, which turns and so changes the arms. The
// equilibrium at the turned pose, by fixed-point iteration; for little turn it is N = k delta / (1 + (x^2 -+ mu h x) /
// l^2).
double normal_force_at_equilibrium(double sign, double mu, double angle, double depth, double l2) {
  constexpr double k = ProxyRig::kStiffness;
  const auto height = [](double turned) { return kHalf * (std::cos(turned) + std::sin(turned)); };
  double N = k * depth, turn = 0.0;
  for (int i = 0; i < 2000; ++i) {
    const double x = kHalf * (std::sin(angle + turn) - std::cos(angle + turn)), h = height(angle + turn);
    turn += 0.1 * (N * (x - sign * mu * h) / (k * l2) - turn);
    N += 0.1 * (k * (height(angle + turn) + 2e-6 - height(angle) + depth) - N);
  }
  return N;
}

TEST(ProxyFriction, OnAnEdgeTheNormalForceIsThatOfEquilibrium) {
  const double mu = 0.3, angle = 0.5;
  for (const double depth : {0.1e-3, 1e-3}) {
    for (const double sign : {1.0, -1.0}) {
      ProxyRig rig = block_on_floor(mu);
      const double height = kHalf * (std::cos(angle) + std::sin(angle));
      const double l2 = rig.metric_length() * rig.metric_length();
      rig.tick(at({0.0, 0.0, height + 1e-4}, {angle, 0.0, 0.0}));
      for (int i = 0; i < 400; ++i) rig.tick(at({0.0, sign * 1e-4 * i, height - depth}, {angle, 0.0, 0.0}));
      const double N = normal_force_at_equilibrium(sign, mu, angle, depth, l2);
      EXPECT_NEAR(rig.output.wrench.force.z(), N, 0.005 * N) << sign << " " << depth;
      if (depth < 0.5e-3) {
        const double x = kHalf * (std::sin(angle) - std::cos(angle));
        const double linear = ProxyRig::kStiffness * (depth + 2e-6) / (1.0 + (x * x - sign * mu * height * x) / l2);
        EXPECT_NEAR(rig.output.wrench.force.z(), linear, 0.02 * linear) << sign;
      }
    }
  }
}

TEST(ProxyFriction, OnASlopeItSlipsAtTheAngleOfFriction) {
  const double mu = 0.5, critical = std::atan(mu) * 180.0 / std::numbers::pi;
  const auto slip_at = [mu](double degrees) {
    ProxyRig rig = block_on_floor(mu);
    rig.tick(at(0.0, 0.0, kHalf + 1e-4));
    rig.hold(at(0.0, 0.0, kHalf - 1e-3), 20);
    // The pull of the coupling leans by so much from the normal.
    const double stretch = 1e-3;
    const double x = stretch * std::tan(degrees * std::numbers::pi / 180.0);
    for (int i = 1; i <= 100; ++i) rig.tick(at(0.01 * i * x, 0.0, kHalf - stretch));
    const double elastic = rig.output.X_WP.p.x();
    rig.hold(at(x, 0.0, kHalf - stretch), 300);
    return std::max(std::abs(elastic), std::abs(rig.output.X_WP.p.x()));
  };
  EXPECT_LT(slip_at(critical - 0.5), 5e-6);
  EXPECT_GT(slip_at(critical + 0.5), 5e-6);
}

TEST(ProxyFriction, SticksForAMinuteWithoutCreep) {
  ProxyRig rig = block_on_floor(0.5);
  rig.tick(at(0.0, 0.0, kHalf + 1e-4));
  const auto wobble = [](int i) {
    const double t = 1e-3 * i;
    return at({3e-4 * std::sin(9.0 * t), 2e-4 * std::sin(2.0 * std::numbers::pi * t), kHalf - 1e-3},
              {0.004 * std::sin(14.0 * std::numbers::pi * t), 0.003 * std::sin(6.0 * std::numbers::pi * t),
               0.001 * std::sin(4.0 * std::numbers::pi * t)});
  };
  const int minute = 60000;
  for (int i = 0; i < 2000; ++i) rig.tick(wobble(0));
  const Vector3 first = rig.output.X_WP.p;
  for (int i = 0; i < minute; ++i) rig.tick(wobble(i));
  rig.hold(wobble(0), 2000);
  EXPECT_LT((rig.output.X_WP.p - first).norm(), 1e-6);
}

TEST(ProxyFriction, TwistOfASquareFaceIsThatOfUniformPressure) {
  const double mu = 0.5;
  ProxyRig rig = block_on_floor(mu);
  rig.tick(at(0.0, 0.0, kHalf + 1e-4));
  for (int i = 0; i < 500; ++i) rig.tick(at({0.0, 0.0, kHalf - 1e-3}, {0.0, 0.0, 1e-3 * i}));
  const double mean_distance = 2.0 * kHalf * 0.38259785823210635;
  const double expected = mu * rig.output.wrench.force.z() * mean_distance;
  EXPECT_NEAR(-rig.output.wrench.torque.z(), expected, 0.05 * expected);
}

TEST(ProxyFriction, TwistOfADiscIsThatOfUniformPressure) {
  const double mu = 0.5, radius = 0.02;
  ProxyRig rig({make_cylinder(radius, 0.02)});
  rig.add_body(make_plane());
  rig.parameters.friction = mu;
  rig.tick(at(0.0, 0.0, 0.0201));
  for (int i = 0; i < 500; ++i) rig.tick(at({0.0, 0.0, 0.019}, {0.0, 0.0, 1e-3 * i}));
  const double expected = mu * rig.output.wrench.force.z() * 2.0 / 3.0 * radius;
  EXPECT_NEAR(-rig.output.wrench.torque.z(), expected, 0.05 * expected);
}

TEST(ProxyFriction, IsCarriedByAMovingObject) {
  ProxyRig rig({make_box(Vector3::Constant(kHalf))});
  const int belt = rig.add_body(make_box({0.5, 0.5, 0.05}), at(0.0, 0.0, -0.05), true);
  rig.parameters.friction = 0.5;
  rig.tick(at(0.0, 0.0, kHalf + 1e-4));
  rig.hold(at(0.0, 0.0, kHalf - 1e-3), 20);
  for (int i = 1; i <= 20; ++i) {
    rig.move_body(belt, at(1e-5 * i, 0.0, -0.05));
    rig.tick(at(0.0, 0.0, kHalf - 1e-3));
    EXPECT_NEAR(rig.output.X_WP.p.x(), 1e-5 * i, 1e-6) << "sticks to it";
  }
  for (int i = 1; i <= 200; ++i) {
    rig.move_body(belt, at(2e-4 + 1e-4 * i, 0.0, -0.05));
    rig.tick(at(0.0, 0.0, kHalf - 1e-3));
  }
  EXPECT_NEAR(rig.output.wrench.force.x(), 0.5 * rig.output.wrench.force.z(), 0.01 * 4.5) << "slips under it";
  ASSERT_EQ(rig.output.bodies.moving().size(), 1u);
  EXPECT_LT((rig.output.bodies.moving()[0].on_body.force + rig.output.wrench.force).norm(), 0.01);
}

TEST(ProxyFriction, KineticAndViscousParts) {
  ProxyRig slow = block_on_floor(0.5);
  slow.parameters.kinetic_friction = 0.6;
  const Wrench kinetic = drag(slow, Vector3::Zero(), kHalf, 1e-3, 400);
  EXPECT_NEAR(-kinetic.force.x(), 0.3 * kinetic.force.z(), 0.01 * kinetic.force.z());
  ProxyRig syrup = block_on_floor(0.0);
  syrup.parameters.viscous_friction = 5.0;
  const Wrench viscous = drag(syrup, Vector3::Zero(), kHalf, 1e-3, 800);
  EXPECT_NEAR(-viscous.force.x(), 5.0 * 0.1, 0.01);
}

TEST(ProxyFriction, ComesFromTheSceneByItsRule) {
  Shape tool = make_box(Vector3::Constant(kHalf)), floor = make_plane();
  tool.friction = 0.2;
  floor.friction = 0.4;
  const auto ratio = [&](const Shape& a, const Shape& b, double scale) {
    ProxyRig rig({a});
    rig.add_body(b);
    rig.parameters.friction.reset();
    rig.parameters.friction_scale = scale;
    const Wrench wrench = drag(rig, Vector3::Zero(), kHalf, 1e-3, 300);
    return -wrench.force.x() / wrench.force.z();
  };
  EXPECT_NEAR(ratio(tool, floor, 1.0), 0.4, 0.004);
  EXPECT_NEAR(ratio(tool, floor, 0.5), 0.2, 0.002);
  floor.frictionless = true;
  EXPECT_NEAR(ratio(tool, floor, 1.0), 0.4, 0.004) << "one asks for friction";
  tool.frictionless = true;
  EXPECT_NEAR(ratio(tool, floor, 1.0), 0.0, 1e-6);
}

}  // namespace
}  // namespace tegotae::test
