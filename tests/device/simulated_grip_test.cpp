// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/simulated_grip.hpp>
#include <tegotae/math/rotation.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace tegotae {
namespace {

constexpr double kSubstep = 20e-6;

TEST(SimulatedGrip, AFreeMassUnderConstantForceFollowsTheParabola) {
  SimulatedGrip grip({0.2, 1e-3}, {}, kSubstep);
  const Wrench wrench{{0.5, -1.0, 2.0}, {0.0, 0.0, 3e-3}};
  grip.integrate(0.1, wrench, {}, {});
  EXPECT_LT((grip.state().X_WG.p - 0.5 * 0.01 / 0.2 * wrench.force).norm(), 1e-14);
  EXPECT_LT((grip.state().V_WG.linear - 0.1 / 0.2 * wrench.force).norm(), 1e-12);
  EXPECT_NEAR(rotation_vector(grip.state().X_WG.q).z(), 0.5 * 0.01 * 3.0, 1e-14);
  EXPECT_NEAR(grip.state().V_WG.angular.z(), 0.3, 1e-13);
}

TEST(SimulatedGrip, TheHandsMassMovesWithTheGrip) {
  SimulatedGrip grip({0.2, 1e-3, 1.5, 0.01}, {0.3, 2e-3, 4.0, 0.05}, kSubstep);
  EXPECT_DOUBLE_EQ(grip.mass(), 0.5);
  EXPECT_DOUBLE_EQ(grip.inertia(), 3e-3);
  EXPECT_DOUBLE_EQ(grip.damping(), 5.5);
  EXPECT_DOUBLE_EQ(grip.rotational_damping(), 0.06);
}

// x = A exp(-s t) (cos w t + s/w sin w t), released from rest at A.
double released(double amplitude, double mass, double damping, double stiffness, double time) {
  const double s = damping / (2.0 * mass), w = std::sqrt(stiffness / mass - s * s);
  return amplitude * std::exp(-s * time) * (std::cos(w * time) + s / w * std::sin(w * time));
}

TEST(SimulatedGrip, ADampedSpringFollowsItsClosedForm) {
  const HandImpedance hand{0.05, 2e-4, 1.0, 5e-4, 1255.0, 2.0};
  SimulatedGrip grip({0.05, 1e-4, 0.5, 5e-4}, hand, kSubstep);
  grip.set_state({{{1e-3, 0.0, -2e-3}, rotation_from_vector({0.0, 0.02, 0.0})}, {}});
  for (int i = 1; i <= 100; ++i) {
    grip.integrate(1e-3, {}, {}, {});
    const double time = 1e-3 * i;
    const double way = released(1.0, 0.1, 1.5, 1255.0, time);
    EXPECT_NEAR(grip.state().X_WG.p.x(), 1e-3 * way, 1e-3 * 1e-5) << time;
    EXPECT_NEAR(grip.state().X_WG.p.z(), -2e-3 * way, 2e-3 * 1e-5) << time;
    EXPECT_NEAR(rotation_vector(grip.state().X_WG.q).y(), 0.02 * released(1.0, 3e-4, 1e-3, 2.0, time), 0.02 * 1e-5);
  }
}

double error_at(double substep) {
  SimulatedGrip grip({0.1, 1e-3}, {0.0, 0.0, 1.0, 0.0, 1000.0, 0.0}, substep);
  grip.set_state({{{1e-3, 0.0, 0.0}, Quaternion::Identity()}, {}});
  grip.integrate(0.1, {}, {}, {});
  return std::abs(grip.state().X_WG.p.x() - released(1e-3, 0.1, 1.0, 1000.0, 0.1));
}

TEST(SimulatedGrip, ItsErrorIsOfSecondOrder) {
  const double coarse = error_at(400e-6), fine = error_at(200e-6);
  EXPECT_GT(coarse, 1e-8);
  EXPECT_NEAR(coarse / fine, 4.0, 0.1);
}

TEST(SimulatedGrip, FollowsAMovingHandWithTheViscousLag) {
  // At constant speed the hand's spring carries the interface's damping alone.
  SimulatedGrip grip({0.2, 1e-3, 2.0, 0.02}, {0.3, 1e-3, 5.0, 0.05, 700.0, 2.0}, kSubstep);
  const Twist V_WH{{0.1, 0.0, 0.0}, {0.0, 0.0, 0.4}};
  for (int i = 0; i < 3000; ++i) {
    const double begin = 1e-3 * i;
    grip.integrate(1e-3, {}, {begin * V_WH.linear, rotation_from_vector(begin * V_WH.angular)}, V_WH);
  }
  EXPECT_NEAR(grip.state().V_WG.linear.x(), 0.1, 1e-5);
  EXPECT_NEAR(3.0 * 0.1 - grip.state().X_WG.p.x(), 2.0 * 0.1 / 700.0, 1e-7);
  EXPECT_NEAR(3.0 * 0.4 - rotation_vector(grip.state().X_WG.q).z(), 0.02 * 0.4 / 2.0, 1e-5);
}

TEST(SimulatedGrip, CoulombFrictionHoldsBelowItsForceAndBrakesAboveIt) {
  GripMechanics mechanics{0.2, 1e-3};
  mechanics.friction_force = 0.3;
  mechanics.friction_torque = 0.01;
  SimulatedGrip grip(mechanics, {}, kSubstep);
  grip.integrate(0.1, {{0.2, 0.2, 0.0}, {0.0, 0.009, 0.0}}, {}, {});
  EXPECT_EQ(grip.state().X_WG.p.norm(), 0.0);
  EXPECT_EQ(grip.state().V_WG.angular.norm(), 0.0);
  grip.integrate(0.1, {{0.5, 0.0, 0.0}, {0.0, 0.0, 0.015}}, {}, {});
  EXPECT_NEAR(grip.state().V_WG.linear.x(), 0.1 * (0.5 - 0.3) / 0.2, 1e-12);
  EXPECT_NEAR(grip.state().V_WG.angular.z(), 0.1 * (0.015 - 0.01) / 1e-3, 1e-12);
  // Coasting from 0.1 m/s it stops after v^2/(2 a), at most a sub-step late, and stays.
  grip.set_state({{}, {{0.1, 0.0, 0.0}, Vector3::Zero()}});
  grip.integrate(0.5, {}, {}, {});
  EXPECT_NEAR(grip.state().X_WG.p.x(), 0.01 / (2.0 * 0.3 / 0.2), 0.1 * kSubstep);
  EXPECT_EQ(grip.state().V_WG.linear.norm(), 0.0);
}

TEST(SimulatedGrip, TurnsFarAboutAChangingAxisAsItsAngularVelocitySays) {
  SimulatedGrip grip({0.2, 1e-3}, {}, kSubstep);
  grip.set_state({{}, {Vector3::Zero(), {0.0, 0.0, 5.0}}});
  grip.integrate(1.0, {}, {}, {});
  EXPECT_NEAR(std::abs(grip.state().X_WG.q.dot(rotation_from_vector({0.0, 0.0, 5.0}))), 1.0, 1e-14);
  EXPECT_NEAR(grip.state().X_WG.q.norm(), 1.0, 1e-15);
}

TEST(SimulatedGrip, RefusesWhatCannotBe) {
  EXPECT_THROW(SimulatedGrip({0.0, 1e-3}, {}, kSubstep), std::invalid_argument);
  EXPECT_THROW(SimulatedGrip({0.1, -1e-3}, {}, kSubstep), std::invalid_argument);
  EXPECT_THROW(SimulatedGrip({0.1, 1e-3, -1.0}, {}, kSubstep), std::invalid_argument);
  EXPECT_THROW(SimulatedGrip({0.1, 1e-3}, {-0.1}, kSubstep), std::invalid_argument);
  EXPECT_THROW(SimulatedGrip({0.1, 1e-3}, {}, 0.0), std::invalid_argument);
  EXPECT_THROW(SimulatedGrip({std::numeric_limits<double>::infinity(), 1e-3}, {}, kSubstep), std::invalid_argument);
}

}  // namespace
}  // namespace tegotae
