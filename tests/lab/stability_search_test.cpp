// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/simulated_presets.hpp>
#include <tegotae/lab/decay_judge.hpp>
#include <tegotae/lab/stability_search.hpp>
#include <tegotae/lab/stiffness_bounds.hpp>

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <unsupported/Eigen/MatrixFunctions>

#include <cmath>
#include <limits>

namespace tegotae {
namespace {

TEST(StabilitySearch, FindsTheLimitFromAnySide) {
  for (const double guess : {100.0, 990.0, 1010.0, 3000.0, 50000.0}) {
    const StabilityLimit limit = find_stability_limit([](double k) { return k <= 1000.0; }, guess, 0.01);
    EXPECT_LE(limit.largest_stable, 1000.0) << guess;
    EXPECT_GT(limit.smallest_unstable, 1000.0) << guess;
    EXPECT_LE(limit.smallest_unstable, 1.01 * limit.largest_stable) << guess;
    EXPECT_LE(limit.runs, 16) << guess;
  }
}

TEST(StabilitySearch, SaysWhereNothingOrAllIsStable) {
  const StabilityLimit none = find_stability_limit([](double) { return false; }, 1000.0, 0.01);
  EXPECT_EQ(none.largest_stable, 0.0);
  EXPECT_LT(none.smallest_unstable, 10.0);
  const StabilityLimit all = find_stability_limit([](double) { return true; }, 1000.0, 0.01);
  EXPECT_GT(all.largest_stable, 1e5);
  EXPECT_EQ(all.smallest_unstable, std::numeric_limits<double>::infinity());
}

/// A wall x = 0 of one degree of freedom, bilateral, so that it is linear: force -K x of the sample, held.
struct Wall {
  double mass, damping, hand_stiffness, period;
  int delay;  // samples

  /// Whether all roots of the characteristic polynomial of the sampled loop lie inside the unit circle.
  bool is_stable_by_its_roots(double stiffness) const {
    Eigen::Matrix3d continuous = Eigen::Matrix3d::Zero();  // position, velocity, held force
    continuous(0, 1) = 1.0;
    continuous.row(1) << -hand_stiffness / mass, -damping / mass, 1.0 / mass;
    const Eigen::Matrix3d held = (continuous * period).exp();
    const Eigen::Index order = 2 + delay;
    Eigen::MatrixXd loop = Eigen::MatrixXd::Zero(order, order);  // position, velocity, commands that wait
    loop.topLeftCorner(2, 2) = held.topLeftCorner(2, 2);
    if (delay == 0) {
      loop.col(0) -= stiffness * held.topRightCorner(2, 1);
    } else {
      loop.block(0, order - 1, 2, 1) = held.topRightCorner(2, 1);
      loop(2, 0) = -stiffness;
      for (Eigen::Index i = 3; i < order; ++i) loop(i, i - 1) = 1.0;
    }
    return loop.eigenvalues().cwiseAbs().maxCoeff() < 1.0;
  }

  double critical_stiffness() const {
    double low = 1.0, high = 1e6;
    while (high - low > 1e-6 * low) {
      const double middle = 0.5 * (low + high);
      (is_stable_by_its_roots(middle) ? low : high) = middle;
    }
    return low;
  }

  /// The same wall at the simulated interface, kicked with 1 mm/s.
  bool decays(double stiffness) const {
    SimulatedDevice device;
    device.mechanics = {mass, 1e-3, damping};
    device.delay = delay * period;
    HandImpedance hand;
    hand.stiffness = hand_stiffness;
    SimulatedHandInterface interface(Trajectory({{0.0, Pose()}}), device, hand);
    interface.set_grip({{}, {{1e-3, 0.0, 0.0}, Vector3::Zero()}});
    DecayJudge judge(0.0);
    InterfaceState state;
    for (int k = 0; k <= 5000; ++k) {
      interface.read(k * period, state);
      if (!judge.add(state.time, interface.grip().V_WG.linear.norm())) break;
      interface.write({{{-stiffness * state.X_WT.p.x(), 0.0, 0.0}, Vector3::Zero()}, 0.0});
    }
    return judge.decayed();
  }
};

TEST(StabilitySearch, FindsTheCriticalStiffnessOfASampledWall) {
  for (const int delay : {0, 1, 2}) {
    for (const double hand_stiffness : {0.0, 700.0}) {
      const Wall wall{0.4, 6.0, hand_stiffness, 1e-3, delay};
      const double critical = wall.critical_stiffness();
      const StabilityLimit limit =
          find_stability_limit([&](double k) { return wall.decays(k); }, 0.7 * critical, 0.005);
      EXPECT_NEAR(limit.largest_stable / critical, 1.0, 0.02) << delay << ' ' << hand_stiffness;
      EXPECT_NEAR(limit.smallest_unstable / critical, 1.0, 0.02) << delay << ' ' << hand_stiffness;
    }
  }
}

TEST(StiffnessBounds, TheLinearOneIsTheWallsToFirstOrderInTheDelay) {
  for (const int delay : {0, 1, 2}) {
    // A great mass: the natural frequency times the delay is small.
    const Wall wall{20.0, 6.0, 0.0, 1e-3, delay};
    StiffnessBoundInput input;
    input.device.mechanics.damping = 2.0;
    input.device.delay = delay * 1e-3;
    input.hand.damping = 4.0;
    input.hand.rotational_damping = 100.0;
    EXPECT_NEAR(stiffness_bounds(input).linear / wall.critical_stiffness(), 1.0, 2e-3) << delay;
  }
}

TEST(StiffnessBounds, AreTheirFormulas) {
  StiffnessBoundInput input;
  input.device.mechanics = {0.2, 1e-3, 2.0, 0.01, 0.3, 6e-4};
  input.device.capability.encoder_step = 50e-6;
  input.device.encoder_angle = 1e-3;
  input.device.delay = 1e-3;
  input.hand.damping = 5.0;
  input.hand.rotational_damping = 0.03;
  input.damping = 0.5;
  input.metric_length = 0.1;
  const StiffnessBounds bounds = stiffness_bounds(input);
  EXPECT_NEAR(bounds.linear_translation, 7.5 / 1.5e-3, 1e-9);
  EXPECT_NEAR(bounds.linear_rotation, (0.04 / 0.01 + 0.5) / 1.5e-3, 1e-9);
  EXPECT_EQ(bounds.linear, bounds.linear_rotation);
  EXPECT_NEAR(bounds.colgate_schenkel, 2.0 * (0.01 / 0.01 - 0.5) / 1e-3, 1e-9);
  EXPECT_NEAR(bounds.abbott_okamura, 2.0 * 6e-4 / 1e-3 / 0.01, 1e-9);
}

TEST(StiffnessBounds, WithoutQuantisationDampingAloneLimits) {
  StiffnessBoundInput input;
  input.device.mechanics = {0.2, 1e-3, 2.0, 0.1};
  input.metric_length = 0.1;
  EXPECT_NEAR(stiffness_bounds(input).abbott_okamura, 4000.0, 1e-9);
  input.damping = 3.0;
  EXPECT_EQ(stiffness_bounds(input).colgate_schenkel, 0.0);
}

}  // namespace
}  // namespace tegotae
