// SPDX-License-Identifier: Apache-2.0
#include <tegotae/math/rotation.hpp>
#include <tegotae/model/near_pieces.hpp>
#include <tegotae/model/representation_interpolator.hpp>

#include <tests/allocation_counter.hpp>

#include <gtest/gtest.h>

#include <memory>

namespace tegotae {
namespace {

SceneGeometry scene_of(int moving) {
  SceneGeometry scene;
  scene.bodies.resize(static_cast<size_t>(moving) + 1);
  for (int i = 0; i < moving; ++i) scene.bodies[static_cast<size_t>(i) + 1].moving_index = i;
  scene.moving_count = moving;
  return scene;
}

TEST(NearPieces, EachMovingBodyIsNamedOnce) {
  const SceneGeometry scene = scene_of(3);
  std::vector<BodyState> states(3);
  states[2].X_WB.p = Vector3(1.0, 2.0, 3.0);
  states[2].V_WB.linear = Vector3(0.1, 0.0, 0.0);
  const std::vector<NearPair> pairs{{0, 3, 0, 0.1}, {0, 0, 5, 0.2}, {1, 3, 2, 0.3}, {0, 1, 0, 0.4}};
  const auto model = std::make_unique<IntermediateRepresentation>();
  const test::AllocationCounter counter;
  name_near_pieces(scene, pairs, states, *model);
  EXPECT_EQ(counter.count(), 0u);
  ASSERT_EQ(model->pair_count, 4);
  ASSERT_EQ(model->body_count, 2);
  EXPECT_EQ(model->pairs[0].near_body, 0);
  EXPECT_EQ(model->pairs[1].near_body, -1);
  EXPECT_EQ(model->pairs[1].body_piece, 5);
  EXPECT_EQ(model->pairs[2].near_body, 0);
  EXPECT_EQ(model->pairs[2].tool_piece, 1);
  EXPECT_EQ(model->pairs[3].near_body, 1);
  EXPECT_EQ(model->pairs[3].distance, 0.4);
  EXPECT_EQ(model->bodies[0].moving_index, 2);
  EXPECT_EQ(model->bodies[0].X_WB.p.z, 3.0);
  EXPECT_EQ(model->bodies[0].V_WB.linear.x, 0.1);
  EXPECT_EQ(model->bodies[1].moving_index, 0);
}

TEST(NearPieces, WhatDoesNotFitIsCounted) {
  const SceneGeometry scene = scene_of(kMaxNearBodies + 5);
  const std::vector<BodyState> states(static_cast<size_t>(scene.moving_count));
  std::vector<NearPair> pairs;
  for (int i = 0; i < scene.moving_count; ++i) pairs.push_back({0, i + 1, 0, 0.01 * i});
  const auto model = std::make_unique<IntermediateRepresentation>();
  name_near_pieces(scene, pairs, states, *model);
  EXPECT_EQ(model->body_count, kMaxNearBodies);
  EXPECT_EQ(model->pair_count, kMaxNearBodies);
  EXPECT_EQ(model->dropped_pairs, 5);
  pairs.assign(kMaxNearPieces + 7, {0, 0, 0, 0.1});
  name_near_pieces(scene, pairs, states, *model);
  EXPECT_EQ(model->pair_count, kMaxNearPieces);
  EXPECT_EQ(model->dropped_pairs, 7);
}

std::unique_ptr<IntermediateRepresentation> model_with_body(std::uint64_t sequence, const Pose& X_WB,
                                                            const Vector3& p_WC, const Twist& V_WB) {
  auto model = std::make_unique<IntermediateRepresentation>();
  model->sequence = sequence;
  model->period = 0.05;
  model->pair_count = model->body_count = 1;
  model->pairs[0].near_body = 0;
  model->bodies[0] = {4, X_WB, V_WB, p_WC};
  return model;
}

TEST(NearPieces, BodiesMoveFromOneModelToTheNext) {
  const auto interpolator = std::make_unique<RepresentationInterpolator>();
  const Pose first{Vector3(0.0, 0.0, 0.0), Quaternion::Identity()};
  const Pose second{Vector3(0.1, 0.0, 0.0), rotation_from_vector({0.0, 0.0, 0.4})};
  interpolator->accept(*model_with_body(1, first, Vector3::Zero(), {}));
  interpolator->accept(*model_with_body(2, second, Vector3(0.1, 0.0, 0.0), {}));
  const IntermediateRepresentation& half = interpolator->at(0.5);
  ASSERT_EQ(half.body_count, 1);
  EXPECT_EQ(half.pair_count, 1);
  EXPECT_NEAR(half.bodies[0].X_WB.p.x, 0.05, 1e-15);
  EXPECT_NEAR(rotation_vector(half.bodies[0].X_WB.pose().q).z(), 0.2, 1e-12);
  EXPECT_NEAR(interpolator->at(2.0).bodies[0].X_WB.p.x, 0.1, 1e-15) << "held where physics is late";
}

TEST(NearPieces, ABodyThatComesNearIsFollowedBackByItsTwist) {
  const auto interpolator = std::make_unique<RepresentationInterpolator>();
  Twist V_WB;
  V_WB.linear = Vector3(1.0, 0.0, 0.0);
  V_WB.angular = Vector3(0.0, 0.0, 2.0);
  const Pose X_WB{Vector3(0.0, 0.1, 0.0), Quaternion::Identity()};
  interpolator->accept(*model_with_body(1, X_WB, Vector3::Zero(), V_WB));
  const NearBody& start = interpolator->at(0.0).bodies[0];
  EXPECT_NEAR(start.p_WC.x, -0.05, 1e-15);
  EXPECT_NEAR(rotation_vector(start.X_WB.pose().q).z(), -0.1, 1e-12);
  const Vector3 expected = Vector3(-0.05, 0.0, 0.0) + 0.1 * Vector3(std::sin(0.1), std::cos(0.1), 0.0);
  EXPECT_LT((start.X_WB.p.vector() - expected).norm(), 1e-12);
  EXPECT_LT((interpolator->at(1.0).bodies[0].X_WB.p.vector() - X_WB.p).norm(), 1e-15);
}

}  // namespace
}  // namespace tegotae
