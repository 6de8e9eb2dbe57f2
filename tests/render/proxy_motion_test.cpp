// SPDX-License-Identifier: Apache-2.0
// The proxy method in motion: nothing is passed through, nothing jumps, nothing is allocated.
#include <tests/allocation_counter.hpp>
#include <tests/contact/separating_axis.hpp>
#include <tests/random_shapes.hpp>
#include <tests/render/proxy_rig.hpp>
#include <tests/sweep_size.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tegotae::test {
namespace {

// A plate of 1 mm struck at 1 m/s and pressed 50 mm deep, from straight above to 6 degrees over the plate, with a spin.
TEST(ProxyMotion, AThinPlateIsNeverPoppedThrough) {
  std::mt19937_64 random(3);
  for (int i = 0; i < sweep_size(150); ++i) {
    ProxyRig rig({make_box({0.02, 0.015, 0.01})});
    rig.add_body(make_box({2.0, 2.0, 0.0005}));
    const double polar = (i % 15) * 6.0 * std::numbers::pi / 180.0, azimuth = 0.7 * i;
    const int ticks = static_cast<int>(0.09 / std::cos(polar) / 1e-3);
    const Vector3 along(std::sin(polar) * std::cos(azimuth), std::sin(polar) * std::sin(azimuth), -std::cos(polar));
    const Quaternion turn = random_rotation(random);
    const Vector3 spin = 3.0 * random_vector(random, 1.0);
    Pose X_WT;
    for (int k = 0; k < ticks + 10; ++k) {
      // The way begins 40 mm above the plate and ends 50 mm below it, over its middle.
      const Vector3 end = Vector3(0.0, 0.0, -0.05);
      X_WT = {end - 1e-3 * std::max(0, ticks - k) * along, rotation_from_vector(1e-3 * k * spin) * turn};
      rig.tick(X_WT);
      ASSERT_GT(rig.clearance(), 0.4e-6) << i << " " << k;
      ASSERT_GT(rig.output.X_WP.p.z(), 0.0) << i << " " << k;
    }
    rig.hold(X_WT, 200);
    EXPECT_GT(rig.output.X_WP.p.z(), 0.0) << i;
    EXPECT_GT(rig.output.wrench.force.z(), 0.5 * ProxyRig::kStiffness * 0.05) << i;
  }
}

TEST(ProxyMotion, NothingIsPenetratedInARandomSweep) {
  std::mt19937_64 random(11);
  int touching = 0;
  for (int i = 0; i < sweep_size(40); ++i) {
    const Vector3 tool_half = Vector3(0.02, 0.02, 0.02) + random_vector(random, 0.012);
    ProxyRig rig({make_box(tool_half)});
    const Vector3 halves[] = {{0.05, 0.04, 0.03}, {0.1, 0.1, 0.0005}, {0.005, 0.005, 0.08}};
    std::vector<Pose> poses;
    for (const Vector3& half : halves) {
      const Pose X_WB = random_pose(random, 0.04);
      poses.push_back(X_WB);
      rig.add_body(make_box(half), X_WB);
    }
    const Vector3 swing = random_unit(random), turn = random_unit(random);
    for (int k = 0; k < 600; ++k) {
      const double t = 1e-3 * k;
      const Vector3 p = Vector3(0.0, 0.0, 0.2) * std::cos(5.0 * t) + 0.05 * std::sin(7.0 * t) * swing;
      rig.tick({p, rotation_from_vector(2.0 * std::sin(4.0 * t) * turn)});
      touching += rig.output.wrench.force.norm() > 0.1 ? 1 : 0;
      for (size_t b = 0; b < poses.size(); ++b) {
        const SeparatingAxis axes(tool_half, rig.output.X_WP, halves[b], poses[b]);
        ASSERT_GT(axes.greatest_gap(), 0.0) << i << " " << k << " " << b;
      }
    }
  }
  EXPECT_GT(touching, sweep_size(40) * 100);
}

TEST(ProxyMotion, HullsCylindersAndCapsulesAreNotPenetratedEither) {
  std::mt19937_64 random(12);
  for (int i = 0; i < sweep_size(24); ++i) {
    const Shape tools[] = {make_hull(random_hull_points(random, 60, 0.03)), make_cylinder(0.015, 0.03),
                           make_capsule(0.01, 0.03), make_sphere(0.02), make_ellipsoid({0.01, 0.02, 0.03})};
    ProxyRig rig({tools[i % 5]});
    rig.add_body(make_hull(random_hull_points(random, 100, 0.05)), random_pose(random, 0.02));
    rig.add_body(make_cylinder(0.01, 0.06), random_pose(random, 0.04));
    rig.add_body(make_plane(), at(0.0, 0.0, -0.06));
    const Vector3 swing = random_unit(random), turn = random_unit(random);
    for (int k = 0; k < 600; ++k) {
      const double t = 1e-3 * k;
      const Vector3 p = Vector3(0.0, 0.0, 0.2) * std::cos(5.0 * t) + 0.05 * std::sin(7.0 * t) * swing;
      rig.tick({p, rotation_from_vector(2.0 * std::sin(4.0 * t) * turn)});
      ASSERT_GT(rig.clearance(), 0.0) << i << " " << k;
    }
  }
}

// They touch along a line, not at a point: the tool neither tips nor sticks as it slides along.
TEST(ProxyMotion, CapsulesSideBySideSlideFreely) {
  const Pose lying{Vector3::Zero(), rotation_from_vector({0.0, std::numbers::pi / 2.0, 0.0})};
  for (const auto make : {+[] { return make_capsule(0.02, 0.1); }, +[] { return make_cylinder(0.02, 0.1); }}) {
    Shape tool = make(), object = make();
    tool.X_BS = object.X_BS = lying;
    ProxyRig rig({tool});
    rig.add_body(object);
    const double depth = 2e-3;
    for (int i = 0; i <= 3000; ++i) {
      const double t = 1e-3 * i;
      const Wrench& wrench = rig.tick(at(0.03 * std::sin(3.0 * t), 0.0, 0.042 - std::min(4e-3 * t, 2e-3 + depth)));
      ASSERT_LT(std::abs(wrench.force.x()), 0.02) << t;
      ASSERT_LT(wrench.torque.norm(), 1e-4) << t;
    }
    EXPECT_NEAR(rig.output.wrench.force.z(), ProxyRig::kStiffness * (depth + 2e-6), 0.02);
  }
}

// On a smooth floor the tool keeps up with a hand of any speed, however small the margin.
TEST(ProxyMotion, AFastHandIsNotDraggedBack) {
  for (const double margin : {1e-5, 1e-3}) {
    for (const double speed : {0.7, 1.0, 3.0, 10.0}) {
      ProxyRig rig({make_box({0.02, 0.02, 0.02})});
      rig.parameters.margin = margin;
      rig.add_body(make_plane());
      rig.tick(at(0.0, 0.0, 0.021));
      rig.hold(at(0.0, 0.0, 0.02 - 3e-3), 600);
      for (int i = 0; i <= 100; ++i) {
        const double way = speed * ProxyRig::kPeriod * i;
        const Wrench& wrench = rig.tick(at({way, 0.2 * way, 0.02 - 3e-3}, {0.0, 0.0, 20.0 * way}));
        ASSERT_LT(wrench.force.head<2>().norm(), 0.04) << margin << " " << speed << " " << i;
        ASSERT_LT(wrench.torque.norm(), 2e-3) << margin << " " << speed << " " << i;
      }
      EXPECT_NEAR(rig.output.wrench.force.z(), ProxyRig::kStiffness * (3e-3 + 2e-6), 0.04);
      EXPECT_GT(rig.clearance(), 0.0);
    }
  }
}

// Boxes side by side make a floor: no seam of it is felt, flat or tilted, at any speed.
TEST(ProxyMotion, SeamsOfAFloorOfBoxesAreNotFelt) {
  for (const double speed : {0.0937, 0.333, 0.977}) {
    for (const double tilt : {0.0, 0.1}) {
      ProxyRig rig({make_box({0.03, 0.015, 0.03})});
      for (int i = -5; i <= 5; ++i) rig.add_body(make_box({0.02, 0.02, 0.02}), at(0.04 * i, 0.0, -0.02));
      const double height = 0.03 * std::cos(tilt) + 0.03 * std::sin(tilt);
      rig.hold(at({-0.1, 0.0, height + 1e-3}, {0.0, tilt, 0.0}), 2);
      rig.hold(at({-0.1, 0.0, height - 1e-3}, {0.0, tilt, 0.0}), 300);
      LargestChange change;
      for (int i = 0; i < static_cast<int>(0.2 / speed * 1e3); ++i) {
        change.add(rig.tick(at({-0.1 + 1e-3 * speed * i, 0.0, height - 1e-3}, {0.0, tilt, 0.0})));
        ASSERT_LT(std::abs(rig.output.wrench.force.x()), 0.04) << speed << " " << tilt << " " << i;
        ASSERT_GT(rig.clearance(), 0.0);
      }
      EXPECT_LT(change.force, 0.04) << speed << " " << tilt;
      EXPECT_LT(change.torque, 2e-3) << speed << " " << tilt;
    }
  }
}

// A step in the floor is one, however low.
TEST(ProxyMotion, AStepInTheFloorIsNoSeam) {
  ProxyRig rig({make_box({0.01, 0.01, 0.01})});
  rig.add_body(make_box({0.05, 0.05, 0.02}), at(-0.05, 0.0, -0.02));
  rig.add_body(make_box({0.05, 0.05, 0.02}), at(0.05, 0.0, -0.02 + 20e-6));
  rig.hold(at(-0.03, 0.0, 0.011), 2);
  rig.hold(at(-0.03, 0.0, 0.009), 100);
  for (int i = 0; i <= 200; ++i) rig.tick(at(-0.03 + 1e-4 * i, 0.0, 0.009));
  // The hand stands flush with the step, then 1 mm beyond it: held back by a side 20 um high.
  rig.hold(at(-0.01 + 1e-3, 0.0, 0.009), 20);
  EXPECT_NEAR(rig.output.wrench.force.x(), -ProxyRig::kStiffness * 1e-3, 0.05);
}

// The force follows the hand without steps: what changes in a tick is at most a few times what the hand's own motion
// through the coupling makes.
TEST(ProxyMotion, AFaceRockedOnAFloorIsFeltWithoutSteps) {
  ProxyRig rig({make_box({0.1, 0.1, 0.1})});
  rig.add_body(make_plane());
  rig.tick(at(0.0, 0.0, 0.101));
  rig.hold(at(0.0, 0.0, 0.1 - 0.3e-3), 20);
  LargestChange change;
  for (int i = 0; i <= 4000; ++i) {
    const double angle = 0.5 * std::numbers::pi / 180.0 * std::sin(2.0 * std::numbers::pi * i / 4000.0);
    change.add(rig.tick(at({0.0, 0.0, 0.1 - 0.3e-3}, {angle, 0.0, 0.0})));
  }
  EXPECT_LT(change.force, 0.04);
  EXPECT_LT(change.torque, 2e-3);
}

TEST(ProxyMotion, PastATablesEdgeNothingIsLeft) {
  ProxyRig rig({make_box({0.02, 0.02, 0.02})});
  rig.add_body(make_box({0.1, 0.1, 0.1}));
  double last = 0.0;
  rig.tick(at(0.05, 0.0, 0.121));
  for (int i = 0; i <= 1000; ++i) {
    const double x = 0.05 + 1e-4 * i;  // 0.1 m/s
    rig.tick(at(x, 0.0, 0.12 - 1e-3));
    ASSERT_GT(rig.clearance(), 0.0);
    if (rig.output.wrench.force.norm() > 1e-6) last = x;
  }
  // The tool leaves where its trailing edge passes the table's; it has tilted about its centre by then, by the torque
  // of 1 mm of stretch at a lever arm of half its edge, which puts that edge back by half an edge times the tilt.
  const double l2 = rig.metric_length() * rig.metric_length();
  const double tilt = 1e-3 * 0.02 / (l2 + 0.02 * 0.02);
  EXPECT_NEAR(last, 0.12 + 0.02 * tilt, 3e-4);
}

TEST(ProxyMotion, FromInsideTheToolIsBroughtOutSlowly) {
  for (const double depth : {1e-4, 5e-3, 30e-3}) {
    ProxyRig rig({make_box({0.02, 0.02, 0.02})});
    rig.add_body(make_box({0.1, 0.1, 0.05}));
    const Pose X_WT = at(0.01, 0.02, 0.07 - depth);
    LargestChange change;
    change.add({});
    int ticks = 0;
    for (; ticks < 5000 && rig.output.wrench.force.z() < 0.99 * ProxyRig::kStiffness * depth; ++ticks) {
      change.add(rig.tick(X_WT));
    }
    EXPECT_LT(change.force, 1.01 * ProxyRig::kStiffness * 1e-5);
    EXPECT_NEAR(ticks, depth / 1e-5, 0.02 * depth / 1e-5 + 3.0) << "10 mm/s";
    rig.hold(X_WT, 100);
    EXPECT_GT(rig.clearance(), 0.0);
  }
}

TEST(ProxyMotion, AMovingObjectPushesTheTool) {
  ProxyRig rig({make_box({0.02, 0.02, 0.02})});
  const int wall = rig.add_body(make_box({0.02, 0.1, 0.1}), at(0.045, 0.0, 0.0), true);
  for (int i = 0; i < 400; ++i) {
    const double x = 0.045 - 5e-5 * i;  // 50 mm/s
    rig.move_body(wall, at(x, 0.0, 0.0));
    rig.tick(at(0.0, 0.0, 0.0));
    const double overlap = 0.04 - x;
    if (overlap > 1e-4) {
      ASSERT_NEAR(rig.output.wrench.force.x(), -ProxyRig::kStiffness * overlap,
                  0.01 * ProxyRig::kStiffness * overlap + 0.02);
    }
  }
  ASSERT_EQ(rig.output.bodies.moving().size(), 1u);
  EXPECT_LT((rig.output.bodies.moving()[0].on_body.force + rig.output.wrench.force).norm(), 1e-3);
}

// The tool is pushed along by a body of any speed, and free as soon as that has gone.
TEST(ProxyMotion, AFastObjectIsNotPassedThrough) {
  for (const double speed : {1.0, 3.0, 10.0}) {
    ProxyRig rig({make_box({0.02, 0.02, 0.02})});
    const int wall = rig.add_body(make_box({0.02, 0.1, 0.1}), at(0.045, 0.0, 0.0), true);
    const Pose held = at(0.0, 0.0, 0.0);
    rig.tick(held);
    double x = 0.045;
    for (; x > -0.05; x -= speed * ProxyRig::kPeriod) {
      rig.move_body(wall, at(x, 0.0, 0.0));
      rig.tick(held);
      ASSERT_NEAR(rig.output.X_WP.p.x(), std::min(0.0, x - 0.04), 5e-6) << speed;
    }
    for (; x < 0.06; x += speed * ProxyRig::kPeriod) {
      rig.move_body(wall, at(x, 0.0, 0.0));
      rig.tick(held);
      ASSERT_NEAR(rig.output.X_WP.p.x(), std::min(0.0, x - 0.04), 5e-6) << speed;
    }
    EXPECT_EQ(rig.output.wrench.force.norm(), 0.0);
  }
}

TEST(ProxyMotion, RenderingAllocatesNothing) {
  ProxyRig rig({make_box({0.02, 0.02, 0.02}), make_sphere(0.01)});
  rig.add_body(make_box({0.1, 0.1, 0.1}));
  rig.add_body(make_plane(), at(0.0, 0.0, -0.1));
  rig.parameters.friction = 0.5;
  rig.parameters.viscous_friction = 1.0;
  rig.tick(at(0.0, 0.0, 0.2));
  const AllocationCounter counter;
  for (int i = 0; i < 500; ++i) {
    if (i == 250) ++rig.model->sequence;
    rig.tick(at({1e-4 * i, 0.0, 0.13 - 1e-4 * i}, {0.1, 0.05 * std::sin(0.1 * i), 0.0}));
  }
  EXPECT_EQ(counter.count(), 0u);
}

TEST(ProxyMotion, InvalidInputGivesNoForceAndDoesNotStay) {
  ProxyRig rig({make_box({0.02, 0.02, 0.02})});
  rig.add_body(make_plane());
  rig.tick(at(0.0, 0.0, 0.021));
  rig.hold(at(0.0, 0.0, 0.0195), 3);
  const double force = rig.output.wrench.force.z();
  rig.tick(at(0.0, std::nan(""), 0.0195));
  EXPECT_EQ(rig.output.status, RenderStatus::kInvalidInput);
  EXPECT_EQ(rig.output.wrench.force.norm(), 0.0);
  rig.tick(at(0.0, 0.0, 0.0195));
  EXPECT_NEAR(rig.output.wrench.force.z(), force, 1e-6);
  const auto empty = std::make_unique<IntermediateRepresentation>();
  rig.method->render({*empty, at(0.0, 0.0, 0.0195), 1e-3}, rig.output);
  EXPECT_EQ(rig.output.status, RenderStatus::kNoModel);
}

}  // namespace
}  // namespace tegotae::test
