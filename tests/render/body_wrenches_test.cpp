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

constexpr double kLength = 0.1;  // m

TEST(BodyWrenches, WhatIsDisplayedIsWhatTheBodyReceives) {
  const Vector3 centre(0.1, 0.2, 0.3), p_W(0.9, 0.1, 0.0), force(1.0, 0.0, -2.0);
  for (const double part : {1.0, 0.4, 0.0}) {
    BodyWrenches bodies;
    bodies.add(plane_of(0, {1.0, 0.0, 0.0}), p_W, force);
    const Wrench before = bodies.moving()[0].on_body;
    bodies.share(Wrench{-force, (p_W - centre).cross(-force)} * part, centre, kLength);
    EXPECT_LT((bodies.moving()[0].on_body.force - part * before.force).norm(), 1e-14);
    EXPECT_LT((bodies.moving()[0].on_body.torque - part * before.torque).norm(), 1e-14);
  }
}

TEST(BodyWrenches, OppositeOfTheDisplayedWrenchWhereItIsAPartOfTheComputedOne) {
  BodyWrenches bodies;
  const Vector3 centre(0.1, 0.2, 0.3);
  bodies.add(plane_of(0, {1.0, 0.0, 0.0}), {0.9, 0.1, 0.0}, {1.0, 0.0, -2.0});
  bodies.add(plane_of(1, {0.0, 1.0, 0.0}), {0.0, 0.8, 0.1}, {0.0, 3.0, 0.0});
  const Wrench sum = total(bodies);
  const Wrench displayed = -sum.shifted(-centre) * 0.7;
  bodies.share(displayed, centre, kLength);
  EXPECT_LT((total(bodies).force + displayed.force).norm(), 1e-14);
  EXPECT_LT((total(bodies).torque + displayed.shifted(centre).torque).norm(), 1e-14);
}

// What the limits keep from the floor is not given to the box beside it.
TEST(BodyWrenches, WhatIsWithheldFromAStaticBodyIsNotGivenToAMovingOne) {
  for (const double part : {1.0, 1.0 / 3.0, 0.0}) {
    BodyWrenches bodies;
    bodies.add(plane_of(-1, Vector3::Zero()), Vector3::Zero(), {0.0, -45.0, 0.0});
    bodies.add(plane_of(0, {0.1, 0.0, 0.0}), {0.1, 0.0, 0.0}, {0.9, 0.0, 0.0});
    bodies.share(Wrench{Vector3(-0.9, 45.0, 0.0), Vector3::Zero()} * part, Vector3::Zero(), kLength);
    EXPECT_LT((bodies.moving()[0].on_body.force - Vector3(0.9 * part, 0.0, 0.0)).norm(), 1e-12);
    EXPECT_LT(bodies.moving()[0].on_body.torque.norm(), 1e-12);
  }
}

// Force and torque saturate apart: the body is pushed through its centre, as it was.
TEST(BodyWrenches, ASpuriousTorqueOfTheLimitsIsNotPassedOn) {
  BodyWrenches bodies;
  bodies.add(plane_of(0, {1.0, 0.0, 0.0}), {0.5, 0.0, 0.0}, {36.0, 0.0, 0.0});
  bodies.share({Vector3(-15.0, 0.0, 0.0), Vector3(0.0, 0.0, -2.0)}, Vector3::Zero(), kLength);
  EXPECT_LT((bodies.moving()[0].on_body.force - Vector3(15.0, 0.0, 0.0)).norm(), 1e-12);
  EXPECT_LT(bodies.moving()[0].on_body.torque.norm(), 1e-12);
}

TEST(BodyWrenches, BodiesThatSqueezeTheToolAreNotDrivenApart) {
  BodyWrenches bodies;
  bodies.add(plane_of(0, {1.0, 0.0, 0.0}), {0.1, 0.0, 0.0}, {7e6, 0.0, 0.0});
  bodies.add(plane_of(1, {-1.0, 0.0, 0.0}), {-0.1, 0.0, 0.0}, {-7e6 + 0.01, 0.0, 0.0});
  BodyWrenches shown = bodies;
  bodies.share({}, Vector3::Zero(), kLength);
  EXPECT_EQ(bodies.moving()[0].on_body.force.norm() + bodies.moving()[1].on_body.force.norm(), 0.0);
  shown.share({Vector3(-0.01, 0.0, 0.0), Vector3::Zero()}, Vector3::Zero(), kLength);
  for (const BodyWrench& body : shown.moving()) {
    EXPECT_LE(body.on_body.force.norm(), BodyWrenches::kGreatestAmplification * 0.01 * (1.0 + 1e-12));
  }
}

// Two bodies that together turn the tool: no force, all torque.
TEST(BodyWrenches, ACoupleIsPassedOn) {
  BodyWrenches bodies;
  bodies.add(plane_of(0, {0.1, 0.0, 0.0}), {0.1, 0.0, 0.0}, {0.0, 2.0, 0.0});
  bodies.add(plane_of(1, {-0.1, 0.0, 0.0}), {-0.1, 0.0, 0.0}, {0.0, -2.0, 0.0});
  bodies.share({Vector3::Zero(), Vector3(0.0, 0.0, -0.2)}, Vector3::Zero(), kLength);
  EXPECT_LT((bodies.moving()[0].on_body.force - Vector3(0.0, 1.0, 0.0)).norm(), 1e-12);
}

TEST(BodyWrenches, WithoutAnyPushNobodyReceives) {
  BodyWrenches bodies;
  bodies.share({Vector3(1.0, 2.0, 3.0), Vector3::Zero()}, Vector3::Zero(), kLength);
  EXPECT_TRUE(bodies.moving().empty());
}

TEST(BodyWrenches, AsManyBodiesAsPlanes) {
  BodyWrenches bodies;
  for (int i = 0; i < kMaxPlanes; ++i) bodies.add(plane_of(i, Vector3::Zero()), Vector3::Zero(), Vector3::UnitX());
  EXPECT_EQ(bodies.moving().size(), static_cast<size_t>(kMaxPlanes));
}

}  // namespace
}  // namespace tegotae
