// SPDX-License-Identifier: Apache-2.0
// What the proxy method shows at rest, against closed forms.
#include <tests/render/proxy_rig.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tegotae::test {
namespace {

constexpr double kHalfOfBox = 0.1;  // m, of the cube

ProxyRig cube_on_floor() {
  ProxyRig rig({make_box(Vector3::Constant(kHalfOfBox))});
  rig.add_body(make_plane());
  return rig;
}

TEST(ProxyStatic, InFreeAirThereIsNoForceAndTheProxyFollows) {
  ProxyRig rig = cube_on_floor();
  for (int i = 0; i < 100; ++i) {
    const Pose X_WT = at({0.01 * i, 0.0, 0.5 + 0.1 * std::sin(i)}, {0.1 * i, 0.0, 0.3});
    rig.tick(X_WT);
    EXPECT_LT(rig.output.wrench.force.norm(), 1e-9) << i;
    EXPECT_LT(rig.output.wrench.torque.norm(), 1e-9);
  }
}

TEST(ProxyStatic, AFacePressedFlatHasNoTorque) {
  ProxyRig rig = cube_on_floor();
  rig.tick(at(0.0, 0.0, kHalfOfBox + 1e-3));
  for (const double depth : {1e-4, 1e-3, 1e-2, 5e-2}) {
    const Wrench& wrench = rig.hold(at(0.003, 0.001, kHalfOfBox - depth), 100);
    EXPECT_NEAR(wrench.force.z(), ProxyRig::kStiffness * depth, 0.02 + 1e-4 * ProxyRig::kStiffness * depth);
    EXPECT_LT(wrench.force.head<2>().norm(), 1e-9);
    EXPECT_LT(wrench.torque.norm(), 1e-9);
  }
}

TEST(ProxyStatic, TellsHowDeepTheHandHoldsTheTool) {
  ProxyRig rig({make_box(Vector3::Constant(kHalfOfBox))});
  rig.add_body(make_plane());
  rig.hold(at(0.0, 0.0, kHalfOfBox + 0.05), 2);
  EXPECT_EQ(rig.output.deepest, 0.0);
  for (const double depth : {1e-3, 10e-3}) {
    rig.hold(at(0.0, 0.0, kHalfOfBox - depth), 50);
    EXPECT_NEAR(rig.output.deepest, depth, 1e-9);
  }
}

TEST(ProxyStatic, AnEdgeIsFeltAsTheClosedFormSays) {
  const double depth = 0.35e-3;
  for (double degrees = 45.0; degrees >= 2.0; degrees -= 1.0) {
    ProxyRig rig = cube_on_floor();
    const double angle = degrees * std::numbers::pi / 180.0;
    const double height = kHalfOfBox * (std::cos(angle) + std::sin(angle)),
                 lever = kHalfOfBox * (std::cos(angle) - std::sin(angle));
    rig.tick(at({0.0, 0.0, height + 1e-3}, {angle, 0.0, 0.0}));
    const Wrench& wrench = rig.hold(at({0.0, 0.0, height - depth}, {angle, 0.0, 0.0}), 5);
    const double force = ProxyRig::kStiffness * (depth + 2e-6) / (1.0 + std::pow(lever / rig.metric_length(), 2));
    EXPECT_NEAR(wrench.force.z(), force, 5e-3 * force) << degrees;
    EXPECT_NEAR(wrench.torque.norm(), lever * force, 5e-3 * force * kHalfOfBox) << degrees;
  }
}

// The paper's motion: in contact at constant depth the cube turns from its edge to its face, in one go. Without
// friction the force is that of the edge's lever arm, and the torque turns the cube back towards where it rests.
TEST(ProxyStatic, ACubeTurnedFromItsEdgeToItsFaceFollowsTheClosedForm) {
  const double depth = 0.35e-3;
  for (const double metric_length : {1.0, 2.0 * kHalfOfBox / std::sqrt(6.0)}) {
    ProxyRig rig = cube_on_floor();
    rig.parameters.coupling.metric_length = metric_length;
    const auto pose = [depth](double angle, double lift) {
      const double height = kHalfOfBox * (std::cos(angle) + std::sin(angle));
      return at({0.0, 0.0, height - depth + lift}, {angle, 0.0, 0.0});
    };
    const double start = std::numbers::pi / 4.0;
    for (int i = 0; i <= 10; ++i) rig.tick(pose(start, 1e-3 * (1.0 - 0.1 * i)));
    for (double angle = start; angle > 0.03; angle -= 4e-4) {
      const Wrench& wrench = rig.tick(pose(angle, 0.0));
      const double lever = kHalfOfBox * (std::cos(angle) - std::sin(angle));
      const double force = ProxyRig::kStiffness * (depth + 2e-6) / (1.0 + std::pow(lever / metric_length, 2));
      ASSERT_NEAR(wrench.force.z(), force, 0.01 * force) << angle;
      // The edge is at y = -lever from the centre: r x f about x is -lever f.
      ASSERT_NEAR(wrench.torque.x(), -lever * force, 0.01 * kHalfOfBox * force) << angle;
    }
  }
}

// Within half a percent.
void expect_equal_at_every_margin(const std::vector<Wrench>& wrenches) {
  for (const Wrench& wrench : wrenches) {
    EXPECT_LE((wrench.force - wrenches[0].force).norm(), 5e-3 * wrenches[0].force.norm());
    EXPECT_LE((wrench.torque - wrenches[0].torque).norm(), 5e-3 * wrenches[0].torque.norm());
  }
}

TEST(ProxyStatic, AnOverhangingPlateHasTheTorqueOfThePillarsEdgeAtEveryMargin) {
  // The plate's centre is 20 mm beyond the pillar's edge: it is held by that edge alone.
  std::vector<Wrench> at_margins;
  for (const double margin : {0.2e-3, 2e-3, 20e-3}) {
    ProxyRig rig({make_box({0.1, 0.1, 0.005})});
    rig.add_body(make_box({0.02, 0.03, 0.05}));
    rig.parameters.margin = margin;
    rig.tick(at(0.04, 0.0, 0.056));
    const double depth = 1e-3;
    const Wrench& wrench = rig.hold(at(0.04, 0.0, 0.055 - depth), 100);
    const double l2 = rig.metric_length() * rig.metric_length();
    const double expected = ProxyRig::kStiffness * (depth + 2e-6) / (1.0 + 0.02 * 0.02 / l2);
    EXPECT_NEAR(wrench.force.z(), expected, 0.01 * expected) << margin;
    EXPECT_NEAR(wrench.torque.y(), 0.02 * wrench.force.z(), 0.01 * 0.02 * expected) << margin;
    at_margins.push_back(wrench);
  }
  expect_equal_at_every_margin(at_margins);
}

TEST(ProxyStatic, AFaceOnACornerIsFeltAtTheCorner) {
  const Quaternion tilt = Quaternion::FromTwoVectors(Vector3(1.0, 1.0, 1.0), Vector3::UnitZ());
  std::vector<Wrench> at_margins;
  for (const double margin : {0.2e-3, 2e-3, 20e-3}) {
    ProxyRig rig({make_box(Vector3::Constant(kHalfOfBox))});
    rig.add_body(make_box(Vector3::Constant(kHalfOfBox)), {{0.0, 0.0, -kHalfOfBox * std::sqrt(3.0)}, tilt});
    rig.parameters.margin = margin;
    const double x = 0.03, y = -0.02, depth = 1e-3;
    rig.tick(at(x, y, kHalfOfBox + 1e-3));
    const Wrench& wrench = rig.hold(at(x, y, kHalfOfBox - depth), 50);
    const double l2 = rig.metric_length() * rig.metric_length();
    const double force = ProxyRig::kStiffness * (depth + 2e-6) / (1.0 + (x * x + y * y) / l2);
    EXPECT_NEAR(wrench.force.z(), force, 0.01 * force) << margin;
    EXPECT_NEAR(wrench.torque.x(), -y * force, 0.01 * force * 0.036) << margin;
    EXPECT_NEAR(wrench.torque.y(), x * force, 0.01 * force * 0.036) << margin;
    at_margins.push_back(wrench);
  }
  expect_equal_at_every_margin(at_margins);
}

TEST(ProxyStatic, AnEdgeOnAnEdgeIsFeltWhereTheyCross) {
  const double quarter = std::numbers::pi / 4.0, height = 2.0 * kHalfOfBox * std::sqrt(2.0);
  std::vector<Wrench> at_margins;
  for (const double margin : {0.2e-3, 2e-3, 20e-3}) {
    ProxyRig rig({make_box(Vector3::Constant(kHalfOfBox))});
    rig.add_body(make_box(Vector3::Constant(kHalfOfBox)), at({0.02, 0.0, 0.0}, {0.0, quarter, 0.0}));
    rig.parameters.margin = margin;
    rig.tick(at({0.0, 0.0, height + 1e-3}, {quarter, 0.0, 0.0}));
    const double depth = 0.5e-3;
    const Wrench& wrench = rig.hold(at({0.0, 0.0, height - depth}, {quarter, 0.0, 0.0}), 50);
    const double force = ProxyRig::kStiffness * (depth + 2e-6) / (1.0 + std::pow(0.02 / rig.metric_length(), 2));
    EXPECT_NEAR(wrench.force.z(), force, 0.01 * force) << margin;
    EXPECT_NEAR(wrench.torque.y(), -0.02 * force, 0.01 * 0.02 * force) << margin;
    at_margins.push_back(wrench);
  }
  expect_equal_at_every_margin(at_margins);
}

TEST(ProxyStatic, ASlotTooNarrowIsSharedWithoutChatter) {
  // A block of 40 mm in a slot that is 0.1 mm narrower; it starts inside, 20 um off the middle.
  ProxyRig rig({make_box({0.02, 0.02, 0.02})});
  rig.add_body(make_box({0.05, 0.05, 0.05}), at(-0.06995, 0.0, 0.0));
  rig.add_body(make_box({0.05, 0.05, 0.05}), at(0.06995, 0.0, 0.0));
  rig.hold(at(2e-5, 0.0, 0.0), 300);
  LargestChange change;
  for (int i = 0; i < 500; ++i) change.add(rig.tick(at(2e-5, 0.0, 0.0)));
  EXPECT_LT(change.force, 0.02);
  // Least sum over walls of the squared violation: the middle.
  EXPECT_NEAR(rig.output.wrench.force.x(), -ProxyRig::kStiffness * 2e-5, 0.01 * ProxyRig::kStiffness * 2e-5);
  EXPECT_LT(std::abs(rig.output.wrench.force.y()), 1e-6);
  // Along the slot it is free.
  rig.hold(at(2e-5, 0.001, 0.0), 50);
  EXPECT_LT(std::abs(rig.output.wrench.force.y()), 1e-6);
}

// Walls that oppose each other are left sideways as freely as if they were not there, up to the end of the slot.
TEST(ProxyStatic, ASlotTooNarrowLetsGoAlongItself) {
  for (const double tilt : {0.0, 0.002}) {
    for (const double offset : {0.0, 2e-5}) {
      ProxyRig rig({make_box({0.01005, 0.03, 0.02})});
      rig.add_body(make_box({0.03, 0.06, 0.025}), at(-0.04, 0.0, -0.025));
      rig.add_body(make_box({0.03, 0.06, 0.025}), at(0.04, 0.0, -0.025));
      rig.hold(at({offset, 0.0, -0.022}, {0.0, tilt, 0.0}), 50);
      for (int i = 0; i < 417; ++i) {
        const double z = -0.022 + 0.97e-4 * i;
        const Wrench& wrench = rig.tick(at({offset, 0.0, z}, {0.0, tilt, 0.0}));
        // Of the kilonewtons with which the walls push at each other, what a tilt of 1e-5 of the tool turns upwards.
        ASSERT_LT(std::abs(wrench.force.z()), 0.1) << z << " tilted by " << tilt << ", off by " << offset;
      }
      rig.hold(at({offset, 0.0, 0.03}, {0.0, tilt, 0.0}), 5);
      EXPECT_LT(rig.output.wrench.force.norm(), 1e-9) << "free; tilted by " << tilt << ", off by " << offset;
    }
  }
}

TEST(ProxyStatic, InAWedgeTheForceIsThatOfBothWalls) {
  // Walls 5 degrees to either side; an upright block is pressed down between them.
  const double half_angle = 5.0 * std::numbers::pi / 180.0;
  ProxyRig rig({make_box({0.01, 0.05, 0.03})});
  const double shift = 0.1 / std::cos(half_angle);
  rig.add_body(make_box({0.1, 0.2, 0.5}), at({shift, 0.0, 0.0}, {0.0, half_angle, 0.0}));
  rig.add_body(make_box({0.1, 0.2, 0.5}), at({-shift, 0.0, 0.0}, {0.0, -half_angle, 0.0}));
  // The lower edges touch where the gap is 20 mm wide.
  const double touch = 0.01 / std::tan(half_angle) + 0.03;
  rig.tick(at(0.0, 0.0, touch + 2e-3));
  const double depth = 1e-3;
  for (int i = 0; i <= 20; ++i) rig.tick(at(0.0, 0.0, touch + 2e-3 - i * (depth + 2e-3) / 20.0));
  LargestChange change;
  rig.hold(at(0.0, 0.0, touch - depth), 50);
  for (int i = 0; i < 200; ++i) change.add(rig.tick(at(0.0, 0.0, touch - depth)));
  EXPECT_LT(change.force, 0.02);
  EXPECT_NEAR(rig.output.wrench.force.z(), ProxyRig::kStiffness * (depth + 2e-6 / std::sin(half_angle)),
              0.01 * ProxyRig::kStiffness * depth);
  EXPECT_LT(rig.output.wrench.torque.norm(), 1e-3);
}

}  // namespace
}  // namespace tegotae::test
