// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/simulated_hand_interface.hpp>
#include <tegotae/device/simulated_presets.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tegotae {
namespace {

constexpr double kPresetPeriod = 1e-3;  // s

// Greatest speeds, m/s and rad/s, in the second after the next, of the page's interface in a moderate hand that was
// pushed for a moment, with a damper of so much as a page's tick would display.
Twist speed_after_a_push(double damping, double rotational_damping) {
  const Trajectory still({{0.0, Pose()}, {1.0, Pose()}});
  SimulatedHandInterface interface(still, simulated_device("page"), simulated_hand("moderate"));
  Twist greatest;
  for (int i = 0; i < 2000; ++i) {
    InterfaceState state;
    EXPECT_EQ(interface.read(kPresetPeriod * i, state), InterfaceStatus::kOk);
    Wrench wrench{-damping * state.V_WT.linear, -rotational_damping * state.V_WT.angular};
    if (i < 20) wrench = {{1.0, 0.0, 0.0}, {0.0, 0.0, 0.01}};
    EXPECT_EQ(interface.write({wrench, 0.0}), InterfaceStatus::kOk);
    if (i < 1000) continue;
    greatest.linear = greatest.linear.cwiseMax(state.V_WT.linear.cwiseAbs());
    greatest.angular = greatest.angular.cwiseMax(state.V_WT.angular.cwiseAbs());
  }
  return greatest;
}

TEST(SimulatedPresets, ThePageComesToRestWithTheDampingThatItIsRatedFor) {
  const InterfaceCapability& rated = simulated_device("page").capability;
  const Twist rest = speed_after_a_push(rated.max_damping, rated.max_rotational_damping);
  EXPECT_LT(rest.linear.norm(), 1e-4);
  EXPECT_LT(rest.angular.norm(), 1e-4);
  const Twist shaking = speed_after_a_push(4.0 * rated.max_damping, 4.0 * rated.max_rotational_damping);
  EXPECT_GT(shaking.linear.norm(), 1e-2) << "the bound has a reason";
  EXPECT_GT(shaking.angular.norm(), 1e-2);
}

}  // namespace
}  // namespace tegotae
