// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/observed_interface.hpp>
#include <tegotae/device/simulated_presets.hpp>
#include <tegotae/device/spidar_presets.hpp>
#include <tegotae/math/rotation.hpp>

#include <tests/allocation_counter.hpp>

#include <gtest/gtest.h>

#include <memory>
#include <numbers>
#include <vector>

namespace tegotae {
namespace {

constexpr double kObservedPeriod = 1e-3;  // s

double turned(const Pose& a, const Pose& b) { return rotation_vector(a.q * b.q.conjugate()).norm(); }

std::unique_ptr<IntendedMotion> still(const Pose& X_WT) {
  return std::make_unique<IntendedTrajectory>(Trajectory({{0.0, X_WT}}));
}

SpidarSettings x3r_at(const Pose& X_WS) {
  SpidarSettings settings;
  settings.geometry = spidar_preset("x3r").geometry;
  settings.X_WS = X_WS;
  return settings;
}

const HandImpedance& hand() { return simulated_hand("moderate"); }

// The tool lies on the grip turned by 120 degrees: far from where the strings would hold it if it were not.
TEST(ObservedInterface, ASpidarHoldsAToolThatIsTurnedOnItsGrip) {
  const Pose X_WS{{0.3, -0.2, 0.5}, rotation_from_vector({0.0, 0.0, 0.4})};
  const Quaternion q_GT = rotation_from_vector({0.0, 2.0 * std::numbers::pi / 3.0, 0.0});
  const Pose X_WT{X_WS * Vector3(0.01, 0.0, -0.005), X_WS.q * rotation_from_vector({0.1, 0.0, 0.0}) * q_GT};
  const auto interface = observed_spidar(x3r_at(X_WS), hand(), still(X_WT), q_GT);
  const Wrench wrench{{1.0, -2.0, 0.5}, {0.02, 0.0, -0.03}};
  InterfaceState state;
  GripTruth truth;
  for (int k = 0; k < 2000; ++k) {
    ASSERT_EQ(interface->read(k * kObservedPeriod, state), InterfaceStatus::kOk) << k;
    ASSERT_EQ(interface->write({wrench, 0.0}), InterfaceStatus::kOk) << k;
    ASSERT_TRUE(interface->take(truth));
    ASSERT_EQ(truth.time, k * kObservedPeriod);
    ASSERT_FALSE(truth.falls_short) << k;
    ASSERT_LT((state.X_WT.p - truth.X_WT.p.vector()).norm(), 20e-6) << k;
    ASSERT_LT(turned(state.X_WT, truth.X_WT), 2e-3) << k;
    ASSERT_LT(turned(truth.X_WH, X_WT), 1e-12) << k;
    // As well as the driver knows the pose.
    ASSERT_LT((truth.displayed.force.vector() - wrench.force).norm(), 0.01) << k;
    ASSERT_LT((truth.displayed.torque.vector() - wrench.torque).norm(), 5e-4) << k;
  }
  EXPECT_FALSE(interface->take(truth));
  // At rest the hand's springs carry the wrench, in the world's axes.
  EXPECT_LT((truth.X_WT.p.vector() - X_WT.p - wrench.force / hand().stiffness).norm(), 2e-5);
  const Vector3 turn = rotation_vector(truth.X_WT.pose().q * X_WT.q.conjugate());
  EXPECT_LT((turn - wrench.torque / hand().rotational_stiffness).norm(), 3e-4);
}

TEST(ObservedInterface, TellsWhereTheMotorsFallShort) {
  const auto spidar = observed_spidar(x3r_at({}), hand(), still({}));
  const auto stylus = observed_device(simulated_device("stylus"), hand(), still({}));
  for (ObservedInterface* interface : {spidar.get(), stylus.get()}) {
    InterfaceState state;
    GripTruth truth;
    for (const double force : {1.0, 60.0}) {
      interface->read(0.0, state);
      interface->write({{{force, 0.0, 0.0}, Vector3::Zero()}, 0.0});
      ASSERT_TRUE(interface->take(truth));
      EXPECT_EQ(truth.falls_short, force > 50.0);
    }
  }
}

TEST(ObservedInterface, ADelayedDeviceDisplaysWhatItWasToldBefore) {
  const auto interface = observed_device(simulated_device("parallel"), hand(), still({}));
  InterfaceState state;
  GripTruth truth;
  for (int k = 0; k < 3; ++k) {
    interface->read(k * kObservedPeriod, state);
    interface->write({{{1.0 + k, 0.0, 0.0}, Vector3::Zero()}, 0.0});
    ASSERT_TRUE(interface->take(truth));
    EXPECT_EQ(truth.displayed.force.x, k) << "a millisecond late";
  }
}

TEST(ObservedInterface, GivesTheOldestTruthFirstAndKeepsThoseOfSeconds) {
  const auto interface = observed_device(simulated_device("page"), hand(), still({}));
  InterfaceState state;
  for (int k = 0; k < 5000; ++k) {
    interface->read(k * kObservedPeriod, state);
    interface->write({});
  }
  GripTruth truth;
  for (int k = 0; k < 5000; ++k) {
    ASSERT_TRUE(interface->take(truth));
    ASSERT_EQ(truth.time, k * kObservedPeriod);
  }
  EXPECT_FALSE(interface->take(truth));
}

TEST(ObservedInterface, NothingIsAllocatedOnceMade) {
  const auto interface = observed_spidar(x3r_at({}), hand(), still({}));
  InterfaceState state;
  GripTruth truth;
  const test::AllocationCounter counter;
  for (int k = 0; k < 100; ++k) {
    interface->read(k * kObservedPeriod, state);
    interface->write({{{0.1 * k, 0.0, 0.0}, Vector3::Zero()}, 0.0});
    interface->take(truth);
  }
  EXPECT_EQ(counter.count(), 0U);
}

}  // namespace
}  // namespace tegotae
