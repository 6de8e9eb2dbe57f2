// SPDX-License-Identifier: Apache-2.0
#include <tegotae/model/representation_interpolator.hpp>

#include <tests/allocation_counter.hpp>

#include <gtest/gtest.h>

#include <memory>
#include <vector>

namespace tegotae {
namespace {

struct PlaneSpec {
  int body;
  Vector3 n_W, p_W;
  std::vector<ContactPoint> points;
};

std::unique_ptr<IntermediateRepresentation> model_of(std::uint64_t sequence, const std::vector<PlaneSpec>& planes) {
  auto model = std::make_unique<IntermediateRepresentation>();
  model->sequence = sequence;
  model->period = 0.05;
  for (const PlaneSpec& spec : planes) {
    ContactPlane& plane = model->planes[static_cast<size_t>(model->plane_count++)];
    plane.body = spec.body;
    plane.n_W = spec.n_W;
    plane.p_W = spec.p_W;
    plane.first_point = model->point_count;
    plane.point_count = static_cast<int>(spec.points.size());
    for (const ContactPoint& point : spec.points) model->points[static_cast<size_t>(model->point_count++)] = point;
  }
  return model;
}

const Vector3 kUp(0.0, 0.0, 1.0);

TEST(RepresentationInterpolator, BeforeAnyModelItIsEmpty) {
  auto interpolator = std::make_unique<RepresentationInterpolator>();
  EXPECT_EQ(interpolator->at(0.5).sequence, 0u);
  EXPECT_EQ(interpolator->at(0.5).plane_count, 0);
}

TEST(RepresentationInterpolator, TheFirstModelStandsAtOnce) {
  auto interpolator = std::make_unique<RepresentationInterpolator>();
  interpolator->accept(*model_of(1, {{0, kUp, {0, 0, 1}, {{Vector3(1, 2, 3), 7}}}}));
  EXPECT_EQ(interpolator->at(0.0).planes[0].p_W.vector(), Vector3(0, 0, 1));
  EXPECT_EQ(interpolator->at(0.0).points[0].p_T.vector(), Vector3(1, 2, 3));
  EXPECT_EQ(interpolator->newest_period(), 0.05);
}

TEST(RepresentationInterpolator, PlanesAndPointsMoveLinearlyAndNormalsStayUnit) {
  auto interpolator = std::make_unique<RepresentationInterpolator>();
  interpolator->accept(*model_of(1, {{0, kUp, {0, 0, 1}, {{Vector3(0, 0, 0), 7}}}}));
  interpolator->accept(*model_of(2, {{0, Vector3(0.6, 0, 0.8), {0, 0, 2}, {{Vector3(1, 0, 0), 7}}}}));
  const IntermediateRepresentation& quarter = interpolator->at(0.25);
  EXPECT_LT((quarter.planes[0].p_W.vector() - Vector3(0, 0, 1.25)).norm(), 1e-15);
  EXPECT_LT((quarter.points[0].p_T.vector() - Vector3(0.25, 0, 0)).norm(), 1e-15);
  EXPECT_NEAR(quarter.planes[0].n_W.vector().norm(), 1.0, 1e-15);
  EXPECT_GT(quarter.planes[0].n_W.x, 0.0);
  EXPECT_EQ(interpolator->at(-1.0).planes[0].p_W.z, 1.0);
  EXPECT_EQ(interpolator->at(7.0).planes[0].p_W.z, 2.0);
}

TEST(RepresentationInterpolator, PlanesAreMatchedByTheirPiecesNotByTheirPlace) {
  auto interpolator = std::make_unique<RepresentationInterpolator>();
  interpolator->accept(*model_of(1, {{4, kUp, {0, 0, 4}, {}}, {9, kUp, {0, 0, 9}, {}}}));
  interpolator->accept(*model_of(2, {{9, kUp, {0, 0, 10}, {}}, {4, kUp, {0, 0, 5}, {}}}));
  const IntermediateRepresentation& half = interpolator->at(0.5);
  EXPECT_NEAR(half.planes[0].p_W.z, 9.5, 1e-15);
  EXPECT_NEAR(half.planes[1].p_W.z, 4.5, 1e-15);
}

TEST(RepresentationInterpolator, WhatHasNoPartnerAppearsAndLeavesAtOnce) {
  auto interpolator = std::make_unique<RepresentationInterpolator>();
  interpolator->accept(
      *model_of(1, {{0, kUp, {0, 0, 0}, {{Vector3(1, 0, 0), 1}, {Vector3(2, 0, 0), 2}, {Vector3(4, 0, 0), 4}}}}));
  interpolator->accept(
      *model_of(2, {{0, kUp, {0, 0, 0}, {{Vector3(20, 0, 0), 2}, {Vector3(30, 0, 0), 3}, {Vector3(40, 0, 0), 4}}},
                    {1, kUp, {0, 0, 8}, {{Vector3(5, 0, 0), 1}}}}));
  const IntermediateRepresentation& start = interpolator->at(0.0);
  ASSERT_EQ(start.plane_count, 2);
  ASSERT_EQ(start.points_of(start.planes[0]).size(), 3u);
  EXPECT_EQ(start.points[0].p_T.x, 2.0);
  EXPECT_EQ(start.points[1].p_T.x, 30.0);
  EXPECT_EQ(start.points[2].p_T.x, 4.0);
  EXPECT_EQ(start.planes[1].p_W.z, 8.0);
  EXPECT_EQ(start.points[3].p_T.x, 5.0);
}

TEST(RepresentationInterpolator, APlaneThatChangedSidesIsNotTurnedThroughTheObject) {
  auto interpolator = std::make_unique<RepresentationInterpolator>();
  interpolator->accept(*model_of(1, {{0, kUp, {0, 0, 1}, {}}}));
  interpolator->accept(*model_of(2, {{0, -kUp, {0, 0, -1}, {}}}));
  EXPECT_EQ(interpolator->at(0.1).planes[0].p_W.z, -1.0);
  EXPECT_EQ(interpolator->at(0.1).planes[0].n_W.z, -1.0);
}

TEST(RepresentationInterpolator, WorksAtFullCapacityWithoutAllocating) {
  auto a = std::make_unique<IntermediateRepresentation>();
  a->sequence = 1;
  a->plane_count = kMaxPlanes;
  a->point_count = kMaxContactPoints;
  const int each = kMaxContactPoints / kMaxPlanes;
  for (int i = 0; i < kMaxPlanes; ++i) {
    ContactPlane& plane = a->planes[static_cast<size_t>(i)];
    plane.body = i;
    plane.n_W = kUp;
    plane.first_point = i * each;
    plane.point_count = each;
    for (int j = 0; j < each; ++j) {
      const int index = i * each + j;
      const int feature = j + 1;
      a->points[static_cast<size_t>(index)].feature = static_cast<std::uint64_t>(feature);
    }
  }
  auto b = std::make_unique<IntermediateRepresentation>(*a);
  for (auto& point : b->points) point.p_T = Vector3(1.0, 1.0, 1.0);
  auto interpolator = std::make_unique<RepresentationInterpolator>();
  const test::AllocationCounter counter;
  interpolator->accept(*a);
  interpolator->accept(*b);
  for (const ContactPoint& point : interpolator->at(0.5).points) EXPECT_EQ(point.p_T.y, 0.5);
  EXPECT_EQ(counter.count(), 0u);
}

}  // namespace
}  // namespace tegotae
