// SPDX-License-Identifier: Apache-2.0
#include <tegotae/math/rotation.hpp>
#include <tegotae/runtime/workspace_mapping.hpp>

#include <tests/allocation_counter.hpp>
#include <tests/random_shapes.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace tegotae {
namespace {

using test::random_unit;

class Random {
 public:
  explicit Random(std::uint64_t seed) : random_(seed) {}
  double number(double least, double most) { return std::uniform_real_distribution<double>(least, most)(random_); }
  Vector3 vector(double size) { return number(0.0, size) * random_unit(random_); }
  Pose pose() { return {vector(0.2), rotation_from_vector(vector(3.0))}; }
  WorkspaceSettings settings() {
    WorkspaceSettings settings;
    settings.translation_scale = std::exp(number(-3.0, 3.0));
    settings.rotation_scale = std::exp(number(-2.0, 2.0));
    settings.force_scale = std::exp(number(-3.0, 3.0));
    return settings;
  }

 private:
  std::mt19937_64 random_;
};

InterfaceState at(const Pose& X_D, const Twist& V_D = {}) {
  InterfaceState state;
  state.X_WT = X_D;
  state.V_WT = V_D;
  return state;
}

double distance(const Pose& a, const Pose& b) {
  return (a.p - b.p).norm() + rotation_vector(a.q * b.q.conjugate()).norm();
}

TEST(WorkspaceMapping, WithoutScalesAndClutchPosesAndWrenchesPassBitForBit) {
  Random random(1);
  WorkspaceMapping mapping({}, random.pose());
  for (int i = 0; i < 1000; ++i) {
    const InterfaceState state = at(random.pose(), {random.vector(1.0), random.vector(10.0)});
    const InterfaceState mapped = mapping.to_world(state, false);
    ASSERT_EQ(mapped.X_WT.p, state.X_WT.p);
    ASSERT_EQ(mapped.X_WT.q.coeffs(), state.X_WT.q.coeffs());
    ASSERT_EQ(mapped.V_WT.linear, state.V_WT.linear);
    ASSERT_EQ(mapped.V_WT.angular, state.V_WT.angular);
    const Wrench wrench{random.vector(10.0), random.vector(1.0)};
    ASSERT_EQ(mapping.to_device(wrench).force, wrench.force);
    ASSERT_EQ(mapping.to_device(wrench).torque, wrench.torque);
    ASSERT_EQ(mapping.to_world(wrench).torque, wrench.torque);
  }
}

TEST(WorkspaceMapping, PowerAtTheDeviceIsTheSamePartOfThePowerInTheWorld) {
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const WorkspaceSettings settings = random.settings();
    WorkspaceMapping mapping(settings, random.pose());
    mapping.rebase(random.pose(), random.pose());
    const Twist V_D{random.vector(1.0), random.vector(10.0)};
    const Twist V_W = mapping.to_world(at(random.pose(), V_D), false).V_WT;
    const Wrench in_world{random.vector(20.0), random.vector(2.0)}, felt = mapping.to_device(in_world);
    const double at_device = felt.force.dot(V_D.linear) + felt.torque.dot(V_D.angular);
    const double at_world = in_world.force.dot(V_W.linear) + in_world.torque.dot(V_W.angular);
    ASSERT_NEAR(at_device, settings.power_scale() * at_world, 1e-12 * (1.0 + std::abs(at_device)));
    ASSERT_LT((mapping.to_world(felt).force - in_world.force).norm(), 1e-13);
    ASSERT_LT((mapping.to_world(felt).torque - in_world.torque).norm(), 1e-13);
  }
}

// The same of the work over a path, from the poses themselves and not the twists.
TEST(WorkspaceMapping, WorkOverAPathIsScaledByTheSameNumber) {
  Random random(3);
  for (int run = 0; run < 20; ++run) {
    const WorkspaceSettings settings = random.settings();
    WorkspaceMapping mapping(settings, random.pose());
    Pose X_D = random.pose();
    mapping.rebase(X_D, random.pose());
    Pose X_W = mapping.to_world(at(X_D), false).X_WT;
    double at_device = 0.0, at_world = 0.0;
    for (int i = 0; i < 500; ++i) {
      const Pose X_D_next = displaced(X_D, X_D.p, random.vector(1e-3), random.vector(1e-2));
      const Pose X_W_next = mapping.to_world(at(X_D_next), false).X_WT;
      const Wrench in_world{random.vector(20.0), random.vector(2.0)}, felt = mapping.to_device(in_world);
      const Vector6 way_D = displacement(X_D, X_D_next, Vector3::Zero());
      const Vector6 way_W = displacement(X_W, X_W_next, Vector3::Zero());
      at_device += felt.force.dot(way_D.head<3>()) + felt.torque.dot(way_D.tail<3>());
      at_world += in_world.force.dot(way_W.head<3>()) + in_world.torque.dot(way_W.tail<3>());
      X_D = X_D_next;
      X_W = X_W_next;
    }
    EXPECT_NEAR(at_device, settings.power_scale() * at_world, 1e-10 * (1.0 + std::abs(at_device)));
  }
}

TEST(WorkspaceMapping, GripToToolAndBackIsTheGrip) {
  Random random(4);
  for (int i = 0; i < 1000; ++i) {
    WorkspaceMapping mapping(random.settings(), random.pose());
    const Pose X_D0 = random.pose();
    mapping.rebase(X_D0, random.pose());
    // Within half a turn of the tool, beyond which the shorter way is the other one.
    const double most = 3.0 / std::max(1.0, mapping.settings().rotation_scale);
    const Pose X_D = displaced(X_D0, X_D0.p, random.vector(0.2), random.vector(most));
    ASSERT_LT(distance(mapping.device_pose(mapping.world_pose(X_D)), X_D), 1e-12);
  }
}

TEST(WorkspaceMapping, ThereAndBackEndsWhereItBegan) {
  Random random(5);
  WorkspaceMapping mapping(random.settings(), random.pose());
  std::vector<Pose> path{random.pose()};
  mapping.rebase(path[0], random.pose());
  const Pose begin = mapping.to_world(at(path[0]), false).X_WT;
  for (int i = 0; i < 2000; ++i) {
    path.push_back(displaced(path.back(), path.back().p, random.vector(1e-3), random.vector(0.02)));
    mapping.to_world(at(path.back()), false);
  }
  Pose end;
  for (auto X_D = path.rbegin(); X_D != path.rend(); ++X_D) end = mapping.to_world(at(*X_D), false).X_WT;
  EXPECT_LT(distance(begin, end), 1e-11);
}

TEST(WorkspaceMapping, TheToolTurnsTheWayTheHandDoesTimesTheScale) {
  WorkspaceSettings settings;
  settings.rotation_scale = 2.5;
  settings.translation_scale = 4.0;
  const Pose X_W0{{0.1, 0.2, 0.3}, rotation_from_vector({0.3, -0.2, 0.9})};
  WorkspaceMapping mapping(settings, X_W0);
  // Beyond a whole turn of the tool, without a leap.
  Pose last = X_W0;
  for (int i = 1; i <= 400; ++i) {
    const Pose X_D{X_W0.p + Vector3(1e-4 * i, 0.0, 0.0), rotation_from_vector({0.0, 0.01 * i, 0.0}) * X_W0.q};
    const Pose X_W = mapping.to_world(at(X_D), false).X_WT;
    ASSERT_NEAR(X_W.p.x() - X_W0.p.x(), 4e-4 * i, 1e-12);
    ASSERT_LT((rotation_vector(X_W.q * last.q.conjugate()) - Vector3(0.0, 0.025, 0.0)).norm(), 1e-12);
    last = X_W;
  }
}

TEST(WorkspaceMapping, ClutchedTheToolStaysAndGoesOnWithoutALeap) {
  Random random(6);
  for (int run = 0; run < 100; ++run) {
    WorkspaceMapping mapping(run % 2 == 0 ? WorkspaceSettings() : random.settings(), random.pose());
    Pose X_D = random.pose();
    mapping.rebase(X_D, random.pose());
    const Pose X_W = mapping.to_world(at(X_D), false).X_WT;
    for (int i = 0; i < 100; ++i) {
      X_D = displaced(X_D, X_D.p, random.vector(5e-3), random.vector(0.05));
      const InterfaceState clutched = mapping.to_world(at(X_D, {random.vector(1.0), random.vector(1.0)}), true);
      ASSERT_EQ(clutched.X_WT.p, X_W.p);
      ASSERT_EQ(clutched.X_WT.q.coeffs(), X_W.q.coeffs());
      ASSERT_EQ(clutched.V_WT.linear, Vector3::Zero());
    }
    ASSERT_LT(distance(mapping.to_world(at(X_D), false).X_WT, X_W), 1e-12) << "let go";
  }
}

TEST(WorkspaceMapping, WhatIsFeltOfAStiffnessFollowsFromPowerAndScales) {
  Random random(7);
  const WorkspaceSettings settings = random.settings();
  WorkspaceMapping mapping(settings, Pose());
  // A spring of 1000 N/m and 10 N m/rad in the world.
  const double dx = 1e-3, turn = 1e-2;
  const Pose moved{{dx, 0.0, 0.0}, rotation_from_vector({turn, 0.0, 0.0})};
  const Pose X_W = mapping.world_pose(moved);
  const Wrench felt = mapping.to_device({-1000.0 * X_W.p, -10.0 * rotation_vector(X_W.q)});
  EXPECT_NEAR(-felt.force.x() / dx, settings.felt_stiffness(1000.0), 1e-9 * settings.felt_stiffness(1000.0));
  EXPECT_NEAR(-felt.torque.x() / turn, settings.felt_rotational_stiffness(10.0),
              1e-9 * settings.felt_rotational_stiffness(10.0));
}

TEST(WorkspaceMapping, AllocatesNothing) {
  Random random(8);
  WorkspaceMapping mapping(random.settings(), random.pose());
  const test::AllocationCounter counter;
  for (int i = 0; i < 1000; ++i) mapping.to_device(Wrench{mapping.to_world(at(random.pose()), i % 7 == 0).X_WT.p, {}});
  EXPECT_EQ(counter.count(), 0U);
}

}  // namespace
}  // namespace tegotae
