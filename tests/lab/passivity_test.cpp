// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/passivity.hpp>
#include <tegotae/math/rotation.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace tegotae {
namespace {

constexpr Coupling kSpring{500.0, 0.0, 0.1};
const double kPi = std::numbers::pi;

TickRecord tick(const Pose& X_WT, const Wrench& displayed) {
  TickRecord record;
  record.X_WT = X_WT;
  record.displayed = displayed;
  return record;
}

PassivityObserver observed(const std::vector<double>& x, const std::function<double(size_t)>& force) {
  PassivityObserver observer(kSpring, Vector3::Zero());
  for (size_t i = 0; i < x.size(); ++i) {
    Wrench wrench;
    wrench.force.x() = force(i);
    observer.add(tick({{x[i], 0.0, 0.0}, Quaternion::Identity()}, wrench));
  }
  return observer;
}

std::vector<double> sine(double amplitude, int per_period, int count) {
  std::vector<double> x;
  for (int i = 0; i < count; ++i) x.push_back(amplitude * std::sin(2.0 * kPi * i / per_period));
  return x;
}

TEST(PassivityObserver, ASampledSpringGivesItsOwnEnergyAndNoMore) {
  const double amplitude = 2e-3;
  const int per_period = 40, periods = 25;
  const auto x = sine(amplitude, per_period, per_period * periods + 1);
  const auto observer = observed(x, [&](size_t i) { return -kSpring.stiffness * x[i]; });
  // k/2 sum dx^2 over a period of n samples is k a^2 n (1 - cos(2 pi/n))/2.
  const double delta = 2.0 * kPi / per_period;
  const double own = 0.5 * kSpring.stiffness * amplitude * amplitude * per_period * periods * (1.0 - std::cos(delta));
  EXPECT_NEAR(observer.allowed(), own, 1e-9 * own);
  EXPECT_NEAR(observer.given(), own, 1e-9 * own);
  EXPECT_LT(observer.excess(), 1e-12 * own);
}

TEST(PassivityObserver, ASpringThatIsASampleLateGivesMoreAsComputed) {
  const double amplitude = 2e-3;
  const int per_period = 40, periods = 25;
  const auto x = sine(amplitude, per_period, per_period * periods + 1);
  // Beyond a sine that went on for ever: the zero force of the first tick instead of -k x(-1), and the last tick.
  const auto observer = observed(x, [&](size_t i) { return i > 0 ? -kSpring.stiffness * x[i - 1] : 0.0; });
  const double delta = 2.0 * kPi / per_period, c = std::cos(delta);
  const double excess = kSpring.stiffness * amplitude * amplitude * per_period * periods * c * (1.0 - c);
  EXPECT_NEAR(observer.given() - observer.allowed(), excess, 0.01 * excess);
  EXPECT_NEAR(observer.excess(), excess, 0.01 * excess);
}

TEST(PassivityObserver, AWallIsPassiveButForBeingSampled) {
  const auto x = sine(2e-3, 37, 1000);
  const auto observer = observed(x, [&](size_t i) { return x[i] < 0.0 ? -kSpring.stiffness * x[i] : 0.0; });
  EXPECT_EQ(observer.contacts(), 27);
  EXPECT_GT(observer.given(), 0.0);
  EXPECT_LT(observer.excess(), 1e-15);
}

TEST(PassivityObserver, WhatFrictionTakesInOneContactIsNoCreditInTheNext) {
  // Contact 1 brakes and takes 1 N over 10 mm; contact 2 pushes along with 1 N over 1 mm.
  std::vector<double> x, force;
  for (int i = 0; i <= 100; ++i) {
    x.push_back(1e-4 * i);
    force.push_back(i < 100 ? -1.0 : 0.0);
  }
  for (int i = 0; i < 10; ++i) {
    x.push_back(x.back());
    force.push_back(0.0);
  }
  for (int i = 0; i <= 100; ++i) {
    x.push_back(x.back() + 1e-5);
    force.push_back(i < 100 ? 1.0 : 0.0);
  }
  const auto observer = observed(x, [&](size_t i) { return force[i]; });
  EXPECT_EQ(observer.contacts(), 2);
  EXPECT_NEAR(observer.given(), -0.01 + 0.001, 1e-12);
  const double own = 101 * 0.5 * kSpring.stiffness * 1e-10;
  EXPECT_NEAR(observer.excess(), 0.001 - own, 1e-7);
  EXPECT_EQ(observer.worst_contact(), observer.excess());
}

TEST(PassivityObserver, MotionInTheFreeCountsForNothing) {
  const auto x = sine(0.1, 50, 500);
  const auto observer = observed(x, [](size_t) { return 0.0; });
  EXPECT_EQ(observer.allowed(), 0.0);
  EXPECT_EQ(observer.contacts(), 0);
  EXPECT_EQ(observer.ticks_in_contact(), 0);
}

TEST(PassivityObserver, RotationCountsWithItsTorqueAboutTheGrip) {
  // The grip turns about its own origin by 0.01 rad; the displayed torque is about the centre of mass, 0.2 m away.
  const Vector3 p_TCm(0.2, 0.0, 0.0);
  PassivityObserver observer(kSpring, p_TCm);
  Wrench wrench;
  wrench.force = Vector3(0.0, 3.0, 0.0);
  wrench.torque = Vector3(0.0, 0.0, 0.5);
  observer.add(tick({}, wrench));
  observer.add(tick({Vector3::Zero(), rotation_from_vector({0.0, 0.0, 0.01})}, {}));
  EXPECT_NEAR(observer.given(), (0.5 + 0.2 * 3.0) * 0.01, 1e-15);
  const double centre_moved = 2.0 * 0.2 * std::sin(0.005);
  EXPECT_NEAR(observer.allowed(), 250.0 * (centre_moved * centre_moved + 0.01 * 1e-4), 1e-15);
}

}  // namespace
}  // namespace tegotae
