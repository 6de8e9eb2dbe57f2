// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/simulated_presets.hpp>
#include <tegotae/math/rotation.hpp>

#include <tests/allocation_counter.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace tegotae {
namespace {

constexpr double kSimulatedPeriod = 1e-3;  // s

Trajectory resting(const Pose& X_WT = {}) { return Trajectory({{0.0, X_WT}}); }

SimulatedDevice free_mass(double mass = 0.2) {
  SimulatedDevice device;
  device.mechanics = {mass, 1e-3};
  return device;
}

InterfaceCommand push(double force) { return {{{force, 0.0, 0.0}, Vector3::Zero()}, 0.0}; }

/// Velocity of the free mass after each period, the command of period k being `force(k)`, written at its beginning.
std::vector<double> velocities(SimulatedHandInterface& interface, int periods, const std::vector<double>& forces) {
  std::vector<double> result;
  InterfaceState state;
  for (int k = 0; k < periods; ++k) {
    EXPECT_EQ(interface.read(k * kSimulatedPeriod, state), InterfaceStatus::kOk);
    result.push_back(interface.grip().V_WG.linear.x());
    interface.write(push(static_cast<size_t>(k) < forces.size() ? forces[static_cast<size_t>(k)] : 0.0));
  }
  return result;
}

TEST(SimulatedHandInterface, HoldsACommandForItsPeriod) {
  SimulatedHandInterface interface(resting(), free_mass(), {});
  const auto v = velocities(interface, 5, {1.0, 3.0, -4.0});
  const double per_newton = kSimulatedPeriod / 0.2;
  EXPECT_EQ(v[0], 0.0);
  EXPECT_NEAR(v[1], 1.0 * per_newton, 1e-15);
  EXPECT_NEAR(v[2], 4.0 * per_newton, 1e-15);
  EXPECT_NEAR(v[3], 0.0, 1e-15);
  EXPECT_NEAR(v[4], 0.0, 1e-15);
}

TEST(SimulatedHandInterface, DelaysACommandByExactlyOneSample) {
  SimulatedDevice device = free_mass();
  device.delay = kSimulatedPeriod;
  SimulatedHandInterface interface(resting(), device, {});
  const auto v = velocities(interface, 6, {1.0, 3.0, -4.0});
  const double per_newton = kSimulatedPeriod / 0.2;
  EXPECT_EQ(v[1], 0.0);
  EXPECT_NEAR(v[2], 1.0 * per_newton, 1e-15);
  EXPECT_NEAR(v[3], 4.0 * per_newton, 1e-15);
  EXPECT_NEAR(v[4], 0.0, 1e-15);
}

TEST(SimulatedHandInterface, TheDelayStaysOneSampleForAMinute) {
  // Times that are sums of periods round differently at each tick.
  SimulatedDevice device = free_mass();
  device.delay = kSimulatedPeriod;
  SimulatedHandInterface interface(resting(), device, {});
  InterfaceState state;
  for (int k = 0; k < 60000; ++k) {
    interface.read(k * kSimulatedPeriod, state);
    if (k > 1) {
      ASSERT_EQ(interface.displayed().force.x(), (k - 1) % 7 - 3.0) << k;
    }
    interface.write(push(k % 7 - 3.0));
  }
  EXPECT_EQ(interface.dropped_commands(), 0U);
}

TEST(SimulatedHandInterface, DelaysByAFractionOfAPeriod) {
  SimulatedDevice device = free_mass();
  device.delay = 0.3 * kSimulatedPeriod;
  SimulatedHandInterface interface(resting(), device, {});
  const auto v = velocities(interface, 4, {1.0});
  EXPECT_NEAR(v[1], 0.7 * kSimulatedPeriod / 0.2, 1e-14);
  EXPECT_NEAR(v[2], 1.0 * kSimulatedPeriod / 0.2, 1e-14);
}

TEST(SimulatedHandInterface, ClipsToWhatTheMotorsGive) {
  SimulatedDevice device = free_mass();
  device.capability.max_force = 3.3;
  device.capability.max_torque = 0.0;
  SimulatedHandInterface interface(resting(), device, {});
  interface.write({{{0.0, -8.0, 6.0}, {0.1, 0.0, 0.0}}, 0.0});
  EXPECT_LT((interface.displayed().force - Vector3(0.0, -2.64, 1.98)).norm(), 1e-12);
  EXPECT_EQ(interface.displayed().torque.norm(), 0.0);
  interface.write(push(std::numeric_limits<double>::quiet_NaN()));
  EXPECT_EQ(interface.displayed().force.norm(), 0.0);
}

TEST(SimulatedHandInterface, RoundsPoseToTheEncoderAndKeepsTheTruthBeside) {
  SimulatedDevice device = free_mass();
  device.capability.encoder_step = 1e-4;
  device.encoder_angle = 1e-3;
  const Pose start{{0.0, 0.0, 0.5}, rotation_from_vector({0.3, 0.0, 0.0})};
  SimulatedHandInterface interface(resting(start), device, {});
  const Vector3 turn(0.0, 2.6e-3, 0.4e-3);
  interface.set_grip({{{2.34e-4, -2.36e-4, 0.5}, rotation_from_vector(turn) * start.q}, {}});
  InterfaceState state;
  interface.read(0.0, state);
  EXPECT_LT((state.X_WT.p - Vector3(2e-4, -2e-4, 0.5)).norm(), 1e-12);
  EXPECT_LT((rotation_vector(state.X_WT.q * start.q.conjugate()) - Vector3(0.0, 3e-3, 0.0)).norm(), 1e-12);
  EXPECT_EQ(interface.grip().X_WG.p.x(), 2.34e-4);
}

TEST(SimulatedHandInterface, AnUnquantisedPoseIsTheTrueOne) {
  SimulatedHandInterface interface(resting(), free_mass(), {});
  interface.set_grip({{{1.0 / 3.0, 0.1, 0.2}, rotation_from_vector({0.1, 0.7, 0.2})}, {}});
  InterfaceState state;
  interface.read(0.0, state);
  EXPECT_EQ(state.X_WT.p, interface.grip().X_WG.p);
  EXPECT_EQ(state.X_WT.q.coeffs(), interface.grip().X_WG.q.coeffs());
}

TEST(SimulatedHandInterface, VelocityIsTheDifferenceOfReadingsOverItsWindow) {
  for (const double window : {0.0, 1e-3, 5e-3, 0.02}) {
    SimulatedDevice device = free_mass();
    device.velocity_window = window;
    SimulatedHandInterface interface(resting(), device, {});
    const double acceleration = 1.0 / 0.2;
    InterfaceState state;
    for (int k = 0; k <= 50; ++k) {
      interface.read(k * kSimulatedPeriod, state);
      interface.write(push(1.0));
    }
    // Under constant acceleration the difference is the velocity half a window ago.
    const double lag = 0.5 * std::max(window, kSimulatedPeriod);
    EXPECT_NEAR(state.V_WT.linear.x(), acceleration * (0.05 - lag), 1e-11) << window;
  }
}

TEST(SimulatedHandInterface, VelocityCarriesTheEncodersStep) {
  SimulatedDevice device = free_mass();
  device.capability.encoder_step = 1e-5;
  device.velocity_window = 0.01;
  SimulatedHandInterface interface(resting(), device, {});
  interface.set_grip({{}, {{0.0123, 0.0, 0.0}, Vector3::Zero()}});
  InterfaceState state;
  std::set<long> steps;
  for (int k = 0; k < 200; ++k) {
    interface.read(k * kSimulatedPeriod, state);
    if (k < 20) continue;
    const double in_steps = state.V_WT.linear.x() / (1e-5 / 0.01);
    EXPECT_NEAR(in_steps, std::round(in_steps), 1e-6);
    steps.insert(std::lround(in_steps));
  }
  EXPECT_EQ(steps, (std::set<long>{12, 13}));
}

TEST(SimulatedHandInterface, AFirmHandTakesTheGripAlongItsTrajectory) {
  const Trajectory intended({{5.0, {}}, {6.0, {{0.1, 0.0, 0.0}, rotation_from_vector({0.0, 0.0, 0.5})}}});
  SimulatedHandInterface interface(intended, simulated_device("laboratory"), simulated_hand("firm"));
  InterfaceState state;
  for (int k = 0; k <= 3000; ++k) interface.read(k * kSimulatedPeriod, state);
  EXPECT_NEAR(state.X_WT.p.x(), 0.1, 1e-6);
  EXPECT_NEAR(rotation_vector(state.X_WT.q).z(), 0.5, 1e-6);
}

TEST(SimulatedHandInterface, AClockThatFailsIsReportedAndMovesNothing) {
  SimulatedHandInterface interface(resting(), free_mass(), {});
  interface.set_grip({{}, {{1.0, 0.0, 0.0}, Vector3::Zero()}});
  InterfaceState state;
  EXPECT_EQ(interface.read(std::numeric_limits<double>::quiet_NaN(), state), InterfaceStatus::kLost);
  EXPECT_EQ(interface.read(1e9, state), InterfaceStatus::kLost);
  EXPECT_EQ(interface.grip().X_WG.p.norm(), 0.0);
  EXPECT_EQ(interface.read(0.5, state), InterfaceStatus::kOk);
  EXPECT_NEAR(state.X_WT.p.x(), 0.5, 1e-12);
}

TEST(SimulatedHandInterface, CommandsTooFastAreCounted) {
  SimulatedDevice device = free_mass();
  device.delay = 1e-3;
  SimulatedHandInterface interface(resting(), device, {});
  for (int i = 0; i < 100; ++i) interface.write(push(1.0));
  EXPECT_EQ(interface.dropped_commands(), 100U - 22U);
}

TEST(SimulatedHandInterface, AllocatesNothingOnceMade) {
  SimulatedDevice device = simulated_device("stylus");
  SimulatedHandInterface interface(resting(), device, simulated_hand("moderate"));
  InterfaceState state;
  const test::AllocationCounter counter;
  for (int k = 0; k < 100; ++k) {
    interface.read(k * kSimulatedPeriod, state);
    interface.write(push(0.5));
  }
  EXPECT_EQ(counter.count(), 0U);
}

TEST(SimulatedHandInterface, RefusesWhatCannotBe) {
  const auto make = [](const SimulatedDevice& device) { SimulatedHandInterface(resting(), device, {}); };
  SimulatedDevice slow = free_mass(), coarse = free_mass(), backwards = free_mass();
  slow.delay = 0.2;
  coarse.capability.encoder_step = -1e-5;
  backwards.velocity_window = -1.0;
  for (const SimulatedDevice& device : {slow, coarse, backwards, free_mass(0.0)}) {
    EXPECT_THROW(make(device), std::invalid_argument);
  }
}

TEST(SimulatedPresets, CanAllBeMadeAndHeldAndNameTheirSources) {
  for (const auto& device : simulated_devices()) {
    EXPECT_FALSE(device.source.empty());
    EXPECT_EQ(device.value.capability.name, device.name);
    for (const auto& hand : simulated_hands()) {
      SimulatedHandInterface interface(resting(), device.value, hand.value);
      InterfaceState state;
      EXPECT_EQ(interface.read(kSimulatedPeriod, state), InterfaceStatus::kOk);
      EXPECT_EQ(state.X_WT.p.norm(), 0.0);
    }
  }
  EXPECT_EQ(simulated_hand("relaxed").mass, 0.554);
  try {
    simulated_device("no-such");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("stylus"), std::string::npos);
  }
}

TEST(SimulatedPresets, EveryHandCanHoldATool) {
  // A hand whose rotation is damped less than its translation at the tool's gyration length limits the stiffness.
  for (const auto& hand : simulated_hands()) {
    EXPECT_GE(hand.value.rotational_damping, hand.value.damping * 0.0999 * 0.0999) << hand.name;
    EXPECT_GT(hand.value.rotational_stiffness, 0.0);
  }
}

}  // namespace
}  // namespace tegotae
