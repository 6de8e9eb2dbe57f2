// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/body_wrenches.hpp>

#include <gtest/gtest.h>

namespace tegotae {
namespace {

ContactPlane plane_of(int moving_index, const Vector3& p_WC) {
  ContactPlane plane;
  plane.moving_index = moving_index;
  plane.p_WC = p_WC;
  return plane;
}

// Sum of what the moving bodies receive, about the world's origin.
Wrench total(const BodyWrenches& bodies) {
  Wrench sum;
  for (const BodyWrench& body : bodies.moving()) sum = sum + body.on_body.shifted(body.p_WC);
  return sum;
}

TEST(BodyWrenches, ForceActsAboutTheCentreOfMass) {
  BodyWrenches bodies;
  bodies.add(plane_of(3, {1.0, 0.0, 0.0}), {1.0, 2.0, 0.0}, {0.0, 0.0, 5.0});
  ASSERT_EQ(bodies.moving().size(), 1u);
  EXPECT_EQ(bodies.moving()[0].moving_index, 3);
  EXPECT_EQ(bodies.moving()[0].on_body.force, Vector3(0.0, 0.0, 5.0));
  EXPECT_EQ(bodies.moving()[0].on_body.torque, Vector3(10.0, 0.0, 0.0));
}

TEST(BodyWrenches, PlanesOfOneBodyAddUpAndStaticBodiesAreNotListed) {
  BodyWrenches bodies;
  bodies.add(plane_of(1, Vector3::Zero()), Vector3::Zero(), {1.0, 0.0, 0.0});
  bodies.add(plane_of(-1, Vector3::Zero()), Vector3::Zero(), {9.0, 9.0, 9.0});
  bodies.add(plane_of(1, Vector3::Zero()), Vector3::Zero(), {2.0, 0.0, 0.0});
  ASSERT_EQ(bodies.moving().size(), 1u);
  EXPECT_EQ(bodies.moving()[0].on_body.force, Vector3(3.0, 0.0, 0.0));
  bodies.clear();
  EXPECT_TRUE(bodies.moving().empty());
}

TEST(BodyWrenches, WhatIsDisplayedIsWhatTheBodiesReceive) {
  BodyWrenches bodies;
  const Vector3 centre(0.1, 0.2, 0.3);
  bodies.add(plane_of(0, {1.0, 0.0, 0.0}), {0.9, 0.1, 0.0}, {1.0, 0.0, -2.0});
  bodies.add(plane_of(1, {0.0, 1.0, 0.0}), {0.0, 0.8, 0.1}, {0.0, 3.0, 0.0});
  const Wrench displayed{Vector3(0.3, -4.0, 1.0), Vector3(0.1, 0.0, -0.2)};
  bodies.match(displayed, centre);
  const Wrench sum = total(bodies), expected = -displayed.shifted(centre);
  EXPECT_LT((sum.force - expected.force).norm(), 1e-14);
  EXPECT_LT((sum.torque - expected.torque).norm(), 1e-14);
}

TEST(BodyWrenches, MatchingWhatWasComputedChangesNothing) {
  BodyWrenches bodies;
  const Vector3 centre(0.1, 0.2, 0.3), p_W(0.9, 0.1, 0.0), force(1.0, 0.0, -2.0);
  bodies.add(plane_of(0, {1.0, 0.0, 0.0}), p_W, force);
  const Wrench before = bodies.moving()[0].on_body;
  bodies.match({-force, (p_W - centre).cross(-force)}, centre);
  EXPECT_LT((bodies.moving()[0].on_body.force - before.force).norm(), 1e-15);
  EXPECT_LT((bodies.moving()[0].on_body.torque - before.torque).norm(), 1e-14);
}

TEST(BodyWrenches, StaticBodiesKeepTheirShareOfTheDifference) {
  BodyWrenches bodies;
  bodies.add(plane_of(0, Vector3::Zero()), Vector3::Zero(), {1.0, 0.0, 0.0});
  bodies.add(plane_of(-1, Vector3::Zero()), Vector3::Zero(), {0.0, 3.0, 0.0});
  bodies.match({Vector3(-2.0, -3.0, 0.0), Vector3::Zero()}, Vector3::Zero());
  EXPECT_LT((bodies.moving()[0].on_body.force - Vector3(1.25, 0.0, 0.0)).norm(), 1e-15);
}

TEST(BodyWrenches, WithoutAnyPushNobodyReceives) {
  BodyWrenches bodies;
  bodies.match({Vector3(1.0, 2.0, 3.0), Vector3::Zero()}, Vector3::Zero());
  EXPECT_TRUE(bodies.moving().empty());
}

TEST(BodyWrenches, AsManyBodiesAsPlanes) {
  BodyWrenches bodies;
  for (int i = 0; i < kMaxPlanes; ++i) bodies.add(plane_of(i, Vector3::Zero()), Vector3::Zero(), Vector3::UnitX());
  EXPECT_EQ(bodies.moving().size(), static_cast<size_t>(kMaxPlanes));
}

}  // namespace
}  // namespace tegotae
