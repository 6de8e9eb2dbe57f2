// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/body_wrenches.hpp>
#include <tegotae/shape/mass_properties.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

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

// Two boxes squeeze the tool, which feels one fortieth of what they push with.
TEST(BodyWrenches, ALightBodyIsNotThrownByWhatTheHandDoesNotFeel) {
  const double period = 0.01;
  const auto pushed = [period](double mass, double gyration_length) {
    std::vector<NearBody> near(2);
    near[0].moving_index = 0;
    near[0].mass = mass;
    near[0].gyration_length = gyration_length;
    near[1].moving_index = 1;
    BodyWrenches bodies;
    bodies.add(0, Vector3::Zero(), Vector3(0.0, 0.5, 0.0), Vector3(41.0, 0.0, 0.0), Vector3::Zero());
    bodies.add(1, Vector3::Zero(), Vector3(0.0, 0.5, 0.0), Vector3(-40.0, 0.0, 0.0), Vector3::Zero());
    const Wrench displayed{Vector3(-1.0, 0.0, 0.0), Vector3(0.0, 0.0, 0.5)};
    bodies.share(displayed, Vector3::Zero(), 1.0, near, period);
    return bodies.moving()[0].on_body;
  };
  const double shown = std::sqrt(1.25);
  EXPECT_NEAR(pushed(0.001, 10.0).force.norm(), shown, 1e-12) << "what is felt, it gets";
  EXPECT_NEAR(pushed(0.1, 10.0).force.norm(), 0.1 * BodyWrenches::kFastestThrow / period, 1e-12);
  EXPECT_NEAR(pushed(100.0, 10.0).force.norm(), BodyWrenches::kGreatestAmplification * shown, 1e-12);
  EXPECT_NEAR(pushed(0.0, 0.0).force.norm(), BodyWrenches::kGreatestAmplification * shown, 1e-12) << "unknown";
  // A couple: no more torque than the force that it may have, at the longest arm.
  const Wrench turned = pushed(0.1, 0.02);
  EXPECT_NEAR(turned.torque.norm(), 5.0 * BodyWrenches::kLongestArm * 0.02, 1e-12);
  EXPECT_NEAR(turned.torque.norm(), 0.5 * turned.force.norm(), 1e-12) << "one factor for both";
}

// The corners of boxes and the ends of rods are within the longest arm: a push at one is not cut.
TEST(BodyWrenches, APushAtACornerIsReceivedWhole) {
  for (const Vector3& half : {Vector3(0.02, 0.02, 0.015), Vector3(0.5, 0.001, 0.001), Vector3(0.1, 0.1, 0.001)}) {
    const MassProperties mass = mass_properties(make_box(half), 1000.0);
    std::vector<NearBody> near(1);
    near[0].moving_index = 0;
    near[0].mass = mass.mass;
    near[0].gyration_length = mass.gyration_length();
    for (const Vector3& along : {Vector3(1.0, 0.0, 0.0), Vector3(0.0, 1.0, 0.0), Vector3(0.0, 0.0, 1.0)}) {
      BodyWrenches bodies;
      bodies.add(0, Vector3::Zero(), half, 12.0 * along, Vector3::Zero());
      bodies.share({-12.0 * along, Vector3::Zero()}, half, 0.03, near, 0.002);
      EXPECT_LT((bodies.moving()[0].on_body.force - 12.0 * along).norm(), 1e-12);
      EXPECT_LT((bodies.moving()[0].on_body.torque - half.cross(12.0 * along)).norm(), 1e-12);
    }
  }
}

}  // namespace
}  // namespace tegotae
