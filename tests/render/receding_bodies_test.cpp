// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/receding_bodies.hpp>
#include <tests/allocation_counter.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace tegotae {
namespace {

constexpr double kGyrationLength = 0.02;  // m
const Vector3 kForce(10.0, 0.0, 0.0);     // N, on the body
const Vector3 kCentre(0.5, 0.0, 0.0);     // of the body, m
const Vector3 kTool(0.2, -0.1, 0.0);      // centre of mass, m

// The tool pushes body 7 along x at `p_W`; a static body pushes the tool along z.
struct Push {
  explicit Push(const Vector3& p_W = kCentre) {
    near.resize(2);
    near[0].moving_index = 3;
    near[1].moving_index = 7;
    near[1].mass = 0.1;
    near[1].gyration_length = kGyrationLength;
    output.bodies.add(7, kCentre, p_W, kForce, Vector3::Zero());
    output.bodies.add(-1, Vector3::Zero(), kTool, Vector3(0.0, 0.0, -4.0), Vector3::Zero());
    output.wrench = {Vector3(-10.0, 0.0, 4.0), (p_W - kTool).cross(-kForce)};
    before = output.wrench;
  }
  void yield(const Twist& V_WB, const Twist& V_WT) {
    near[1].V_WB = V_WB;
    yield_to_receding(near, V_WT, kTool, output);
  }
  double kept() const { return output.bodies.moving()[0].on_body.force.x() / 10.0; }

  std::vector<NearBody> near;
  RenderOutput output;
  Wrench before;
};

TEST(RecedingBodies, ThePushFallsWithTheSpeedApart) {
  for (const double speed : {0.0, 0.1, 0.25, 0.4, 0.5, 3.0}) {
    Push push;
    push.yield({Vector3(speed, 5.0, 0.0), Vector3::Zero()}, {Vector3(0.0, -2.0, 1.0), Vector3::Zero()});
    EXPECT_NEAR(push.kept(), std::max(0.0, 1.0 - speed / kRecedingSpeed), 1e-12) << "across it there is no speed";
  }
}

TEST(RecedingBodies, WhatApproachesOrMovesAlongIsPushedAsEver) {
  for (const double speed : {0.0, 0.3, 2.0}) {
    Push push;
    push.yield({Vector3(0.5, 0.0, 0.0), Vector3::Zero()}, {Vector3(0.5 + speed, 0.0, 0.0), Vector3::Zero()});
    EXPECT_EQ(push.kept(), 1.0);
    EXPECT_EQ(push.output.wrench.force, push.before.force) << "bit for bit";
    EXPECT_EQ(push.output.wrench.torque, push.before.torque);
  }
}

TEST(RecedingBodies, TheHandFeelsWhatTheBodyGetsAndAllOfTheRest) {
  const Vector3 p_W = kCentre + Vector3(0.0, 0.03, 0.0);
  Push push(p_W);
  push.yield({Vector3(0.25, 0.0, 0.0), Vector3::Zero()}, {});
  EXPECT_NEAR(push.kept(), 0.5, 1e-12);
  EXPECT_LT((push.output.wrench.force - Vector3(-5.0, 0.0, 4.0)).norm(), 1e-12);
  EXPECT_LT((push.output.wrench.torque - (p_W - kTool).cross(-0.5 * kForce)).norm(), 1e-12);
  const Wrench on_body = push.output.bodies.moving()[0].on_body;
  EXPECT_LT((on_body.torque - (p_W - kCentre).cross(0.5 * kForce)).norm(), 1e-12);
}

TEST(RecedingBodies, ASpinThatTakesTheContactAwayCounts) {
  const Vector3 p_W = kCentre + Vector3(0.0, 0.03, 0.0);
  Push push(p_W);
  push.yield({Vector3::Zero(), Vector3(0.0, 0.0, -5.0)}, {});
  EXPECT_NEAR(push.kept(), 1.0 - 5.0 * 0.03 / kRecedingSpeed, 1e-12);
  Push with_tool(p_W);
  with_tool.yield({Vector3::Zero(), Vector3(0.0, 0.0, -5.0)}, {Vector3(0.15, 0.0, 0.0), Vector3::Zero()});
  EXPECT_NEAR(with_tool.kept(), 1.0, 1e-12) << "the tool follows";
}

TEST(RecedingBodies, ACoupleTurnsNothingThatTurnsAlready) {
  Push push;
  push.output.bodies.clear();
  push.output.bodies.add(7, kCentre, kCentre, Vector3::Zero(), Vector3(0.0, 0.0, 0.6));
  push.yield({Vector3::Zero(), Vector3(0.0, 0.0, 100.0)}, {});
  EXPECT_EQ(push.output.bodies.moving()[0].on_body.torque, Vector3::Zero());
}

TEST(RecedingBodies, AVelocityThatIsNotFiniteOrUnknownChangesNothing) {
  Push push;
  push.yield({Vector3::Constant(std::numeric_limits<double>::quiet_NaN()), Vector3::Zero()}, {});
  EXPECT_EQ(push.kept(), 1.0);
  Push unknown;
  unknown.near[1].moving_index = 8;
  unknown.yield({Vector3(3.0, 0.0, 0.0), Vector3::Zero()}, {});
  EXPECT_EQ(unknown.kept(), 1.0);
}

TEST(RecedingBodies, AllocatesNothing) {
  Push push;
  const test::AllocationCounter counter;
  push.yield({Vector3(0.2, 0.0, 0.0), Vector3::Zero()}, {});
  EXPECT_EQ(counter.count(), 0u);
}

}  // namespace
}  // namespace tegotae
