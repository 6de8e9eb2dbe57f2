// SPDX-License-Identifier: Apache-2.0
#include <tegotae/model/representation_builder.hpp>

#include <tests/free_body_world.hpp>
#include <tests/random_shapes.hpp>

#include <gtest/gtest.h>

#include <memory>

namespace tegotae {
namespace {

// The whole chain from a scene to its model.
struct Chain {
  explicit Chain(SceneGeometry the_scene) : scene(std::move(the_scene)), search(scene), builder(scene) {}

  const IntermediateRepresentation& build(const Pose& X_WT, const Reach& reach,
                                          std::span<const BodyState> bodies = {}) {
    builder.build(search.find(X_WT, bodies, reach), X_WT, bodies, *model);
    return *model;
  }

  SceneGeometry scene;
  NearObjectSearch search;
  RepresentationBuilder builder;
  std::unique_ptr<IntermediateRepresentation> model = std::make_unique<IntermediateRepresentation>();
};

Pose cube_at(double height, double tilt = 0.0) { return {{0.0, height, 0.0}, rotation_from_vector({0.0, 0.0, tilt})}; }

TEST(RepresentationBuilder, AFaceOverTheFloorBecomesAPlaneAndFourPoints) {
  Chain chain(test::cube_over_floor());
  const auto& model = chain.build(cube_at(0.101), {0.002, 0.0, 0.0});
  ASSERT_EQ(model.plane_count, 1);
  EXPECT_LT((model.planes[0].n_W.vector() - Vector3::UnitY()).norm(), 1e-12);
  EXPECT_NEAR(model.planes[0].p_W.y, 0.0, 1e-12);
  EXPECT_NEAR(model.planes[0].distance, 0.001, 1e-12);
  ASSERT_EQ(model.point_count, 4);
  for (const ContactPoint& point : model.points_of(model.planes[0])) {
    EXPECT_NEAR(std::abs(point.p_T.x), 0.1, 1e-12);
    EXPECT_NEAR(point.p_T.y, -0.1, 1e-12);
    EXPECT_NE(point.feature, 0u);
  }
}

TEST(RepresentationBuilder, BeyondReachThereIsNothing) {
  Chain chain(test::cube_over_floor());
  EXPECT_EQ(chain.build(cube_at(0.103), {0.002, 0.0, 0.0}).plane_count, 0);
  EXPECT_EQ(chain.build(cube_at(0.103), {0.002, 0.1, 0.02}).plane_count, 1) << "0.1 s at 0.02 m/s is another 2 mm";
}

TEST(RepresentationBuilder, PenetratingOrNotThePointsAreThoseWithinReachAndNoneLiesOnTheObjectsPlane) {
  Chain chain(test::cube_over_floor());
  for (const double depth : {-0.001, 0.0, 1e-7, 0.002, 0.02}) {
    for (const double tilt : {0.0, 0.001, 0.3, 0.78}) {
      const double height = 0.1 * (std::cos(tilt) + std::sin(tilt)) - depth;
      const auto& model = chain.build(cube_at(height, tilt), {0.003, 0.0, 0.0});
      ASSERT_EQ(model.plane_count, 1) << depth << " " << tilt;
      EXPECT_NEAR(model.planes[0].distance, -depth, 1e-9);
      EXPECT_LT((model.planes[0].n_W.vector() - Vector3::UnitY()).norm(), 1e-6);
      // Cube corners lower than the reach above the floor (or above the closest point while apart).
      int expected = 0;
      for (int i = 0; i < 8; ++i) {
        const Vector3 corner((i & 1) ? 0.1 : -0.1, (i & 2) ? 0.1 : -0.1, (i & 4) ? 0.1 : -0.1);
        expected += (cube_at(height, tilt) * corner).y() < std::max(0.0, -depth) + 0.003 ? 1 : 0;
      }
      EXPECT_EQ(model.point_count, expected) << depth << " " << tilt;
    }
  }
}

TEST(RepresentationBuilder, AnOverhangingToolTouchesAtTheObjectsCorners) {
  SceneGeometry scene = test::cube_over_floor();
  scene.bodies[0].pieces = {make_box(Vector3(0.03, 0.1, 0.02))};
  Chain chain(std::move(scene));
  const auto& model = chain.build(cube_at(0.0995), {0.004, 0.0, 0.0});
  ASSERT_EQ(model.point_count, 4);
  for (const ContactPoint& point : model.points_of(model.planes[0])) {
    EXPECT_NEAR(std::abs(point.p_T.x), 0.03, 1e-9) << "no wider than the pillar, whatever the reach";
    EXPECT_NEAR(std::abs(point.p_T.z), 0.02, 1e-9);
    EXPECT_NEAR(point.p_T.y, -0.1, 1e-9);
  }
}

TEST(RepresentationBuilder, CurvedPiecesTouchAtTheirClosestPoint) {
  SceneGeometry scene = test::cube_over_floor();
  scene.tool.pieces = {make_sphere(0.05)};
  scene.bodies[0].pieces = {make_plane({{0.0, 0.1, 0.0}, rotation_from_vector({-1.5707963267948966, 0.0, 0.0})})};
  Chain chain(std::move(scene));
  const auto& model = chain.build(cube_at(0.0495), {0.002, 0.0, 0.0});
  ASSERT_EQ(model.plane_count, 1);
  EXPECT_NEAR(model.planes[0].distance, -0.0005, 1e-9);
  double lowest = 0.0;
  for (const ContactPoint& point : model.points_of(model.planes[0])) {
    lowest = std::min(lowest, point.p_T.y - point.radius);
    if (point.radius > 0.0) {
      EXPECT_LT(point.p_T.vector().norm(), 1e-9) << "the ball's centre, which does not roll";
    }
  }
  EXPECT_NEAR(lowest, -0.05, 1e-9);
}

TEST(RepresentationBuilder, TheNormalStaysWhereAThinPlateIsPressedPastItsMiddle) {
  SceneGeometry scene = test::cube_over_floor();
  scene.bodies[0].pieces = {make_box(Vector3(0.5, 0.005, 0.5))};
  scene.bodies[0].X_WB.p = Vector3(0.0, -0.005, 0.0);
  Chain chain(std::move(scene));
  for (double depth = -0.001; depth < 0.03; depth += 0.0005) {
    const auto& model = chain.build(cube_at(0.1 - depth), {0.002, 0.0, 0.0});
    ASSERT_EQ(model.plane_count, 1);
    EXPECT_GT(model.planes[0].n_W.y, 0.99) << depth;
  }
  // A search without memory finds the nearer side: what the published method cannot know.
  Chain fresh(chain.scene);
  EXPECT_GT(fresh.build(cube_at(-0.105), {0.002, 0.0, 0.0}).planes[0].distance, -0.11);
}

TEST(RepresentationBuilder, MovingBodiesCarryTheirCentreOfMassAndWidenTheReachByTheirSpeed) {
  SceneGeometry scene = test::cube_over_floor();
  scene.bodies[0].moving_index = 0;
  scene.bodies[0].p_BC = Vector3(0.0, 0.01, 0.0);
  scene.moving_count = 1;
  Chain chain(std::move(scene));
  BodyState body{{{0.0, -0.2, 0.0}, Quaternion::Identity()}, {}};
  const std::span<const BodyState> bodies(&body, 1);
  EXPECT_EQ(chain.build(cube_at(0.1), {0.002, 0.1, 0.0}, bodies).plane_count, 0);
  body.V_WB.linear.y() = 1.1;
  const auto& model = chain.build(cube_at(0.1), {0.002, 0.1, 0.0}, bodies);
  ASSERT_EQ(model.plane_count, 1);
  EXPECT_EQ(model.planes[0].moving_index, 0);
  EXPECT_NEAR(model.planes[0].p_WC.y, -0.19, 1e-15);
}

TEST(RepresentationBuilder, TheScenesFilterKeepsPiecesApart) {
  SceneGeometry scene = test::cube_over_floor();
  scene.tool.pieces[0].contact_type = 2;
  scene.tool.pieces[0].contact_affinity = 2;
  Chain chain(std::move(scene));
  EXPECT_EQ(chain.build(cube_at(0.09), {0.002, 0.0, 0.0}).plane_count, 0);
}

TEST(RepresentationBuilder, BeyondTheCapacityTheNearestStayAndTheRestIsCounted) {
  SceneGeometry scene = test::cube_over_floor();
  scene.bodies.clear();
  for (int i = 0; i < 100; ++i) {
    Body pillar;
    pillar.pieces = {make_box(Vector3(0.005, 0.1, 0.005))};
    const int row = i / 10;
    pillar.X_WB.p = Vector3(0.02 * (i % 10 - 4.5), -0.1 - 1e-5 * i, 0.02 * (row - 4.5));
    scene.bodies.push_back(pillar);
  }
  Chain chain(std::move(scene));
  const auto& model = chain.build(cube_at(0.101), {0.005, 0.0, 0.0});
  EXPECT_EQ(model.near_object_count, 100);
  EXPECT_EQ(model.plane_count, kMaxPlanes);
  EXPECT_EQ(model.dropped_planes, 100 - kMaxPlanes);
  for (const ContactPlane& plane : model.used_planes()) EXPECT_LT(plane.body, kMaxPlanes);
}

// Six balls of many stand-in vertices on one floor: each plane keeps a part of the capacity, and in it its lowest
// point.
TEST(RepresentationBuilder, NoPlaneIsLeftWithoutItsLowestPoint) {
  SceneGeometry scene = test::cube_over_floor();
  scene.tool.pieces.clear();
  for (int i = 0; i < 6; ++i) {
    scene.tool.pieces.push_back(make_sphere(0.02, {Vector3(0.05 * i, 0.0, 0.0), Quaternion::Identity()}));
  }
  Chain chain(std::move(scene));
  const auto& model = chain.build(cube_at(0.0195), {0.02, 0.0, 0.0});
  ASSERT_EQ(model.plane_count, 6);
  EXPECT_EQ(model.near_object_count, 1) << "one floor";
  EXPECT_GT(model.dropped_points, 0);
  for (const ContactPlane& plane : model.used_planes()) {
    double lowest = 1.0;
    for (const ContactPoint& point : model.points_of(plane)) lowest = std::min(lowest, point.p_T.y - point.radius);
    EXPECT_NEAR(lowest, -0.02, 1e-9);
  }
}

TEST(NearObjectSearch, ABodyOfNonFiniteVelocityIsStillFound) {
  SceneGeometry scene = test::cube_over_floor();
  scene.bodies[0].moving_index = 0;
  Chain chain(std::move(scene));
  BodyState body{{{0.0, -0.1, 0.0}, Quaternion::Identity()}, {}};
  body.V_WB.linear.x() = std::nan("");
  EXPECT_EQ(chain.build(cube_at(0.099), {0.002, 0.1, 0.0}, {&body, 1}).plane_count, 1);
}

TEST(NearObjectSearch, NonFiniteToolPoseFindsNothing) {
  Chain chain(test::cube_over_floor());
  EXPECT_EQ(chain.build({{0.0, std::nan(""), 0.0}, Quaternion::Identity()}, {0.002, 0.0, 0.0}).plane_count, 0);
}

}  // namespace
}  // namespace tegotae
