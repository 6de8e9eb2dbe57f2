// SPDX-License-Identifier: Apache-2.0
#include <tegotae/contact/overlay.hpp>
#include <tegotae/contact/penetration.hpp>
#include <tegotae/math/rotation.hpp>

#include <tests/allocation_counter.hpp>
#include <tests/contact/line_cast.hpp>
#include <tests/random_shapes.hpp>
#include <tests/sweep_size.hpp>

#include <gtest/gtest.h>

#include <numbers>
#include <set>

namespace tegotae::test {
namespace {

struct Overlaid {
  OverlayQuery query;
  std::vector<OverlayPoint> points;
};

Overlaid overlaid(const PlacedShape& tool, const PlacedShape& object, double margin) {
  ClosestPointsCache cache;
  Overlaid result;
  result.query.tool = &tool;
  result.query.object = &object;
  result.query.margin = margin;
  const ClosestPoints closest = closest_points(tool, object, cache);
  if (closest.separation == Separation::kSeparated) {
    result.query.p_WA = closest.p_WA;
    result.query.p_WB = closest.p_WB;
    result.query.n_W = closest.n_W;
    result.query.distance = closest.distance;
  } else {
    const Penetration depth = penetration(tool, object, cache);
    EXPECT_TRUE(depth.valid);
    result.query.p_WA = depth.p_WA;
    result.query.p_WB = depth.p_WB;
    result.query.n_W = depth.n_W;
    result.query.distance = -depth.depth;
  }
  OverlayWorkspace workspace(600);
  result.points.resize(1024);
  result.points.resize(static_cast<size_t>(overlay(result.query, workspace, result.points)));
  return result;
}

// All places of `expected` (m, to 1e-9), in any order, and no others.
void expect_places(const std::vector<OverlayPoint>& points, const std::vector<Vector3>& expected) {
  EXPECT_EQ(points.size(), expected.size());
  for (const Vector3& place : expected) {
    const auto near = [&](const OverlayPoint& point) { return (point.p_WA - place).norm() < 1e-9; };
    EXPECT_EQ(std::count_if(points.begin(), points.end(), near), 1) << place.transpose();
  }
}

TEST(Overlay, PlateOnAPillarIsHeldByThePillarsCorners) {
  const Shape plate = make_box({0.1, 0.1, 0.005}), pillar = make_box({0.02, 0.03, 0.05});
  const Pose X_WT{{0.04, 0.01, 0.055 + 2e-6}, Quaternion::Identity()};
  const Pose turned{X_WT.p, rotation_from_vector({0.0, 0.0, 0.3})};
  for (const double margin : {0.2e-3, 2e-3, 20e-3}) {
    for (const Pose& X : {X_WT, turned}) {
      const PlacedShape tool(plate, X), object(pillar, {});
      const Overlaid result = overlaid(tool, object, margin);
      const double z = 0.05 + 2e-6;
      expect_places(result.points, {{0.02, 0.03, z}, {-0.02, 0.03, z}, {0.02, -0.03, z}, {-0.02, -0.03, z}});
      for (const OverlayPoint& point : result.points) EXPECT_NEAR(point.gap, 2e-6, 1e-13);
    }
  }
}

TEST(Overlay, EqualFacesMeetInTheirFourCorners) {
  const Shape box = make_box({0.1, 0.1, 0.1});
  const PlacedShape tool(box, {{0.0, 0.0, 0.2 + 1e-5}, Quaternion::Identity()}), object(box, {});
  const double z = 0.1 + 1e-5;
  expect_places(overlaid(tool, object, 1e-3).points, {{0.1, 0.1, z}, {-0.1, 0.1, z}, {0.1, -0.1, z}, {-0.1, -0.1, z}});
}

TEST(Overlay, CrossedFacesMeetInCornersAndCrossings) {
  const Shape bar = make_box({0.2, 0.01, 0.01}), beam = make_box({0.01, 0.2, 0.01});
  const PlacedShape tool(bar, {{0.0, 0.0, 0.021}, Quaternion::Identity()}), object(beam, {});
  const double z = 0.011;
  expect_places(overlaid(tool, object, 1e-3).points,
                {{0.01, 0.01, z}, {-0.01, 0.01, z}, {0.01, -0.01, z}, {-0.01, -0.01, z}});
}

TEST(Overlay, EdgeOnEdgeAndFaceOnCornerAreOnePoint) {
  const Shape cube = make_box({0.1, 0.1, 0.1});
  const double quarter = std::numbers::pi / 4.0, height = 0.2 * std::sqrt(2.0) + 1e-5;
  const PlacedShape across(cube, {{0.0, 0.0, height}, rotation_from_vector({quarter, 0.0, 0.0})});
  const PlacedShape along(cube, {Vector3::Zero(), rotation_from_vector({0.0, quarter, 0.0})});
  const Overlaid edges = overlaid(across, along, 1e-3);
  expect_places(edges.points, {{0.0, 0.0, 0.1 * std::sqrt(2.0) + 1e-5}});
  EXPECT_NEAR(edges.points[0].gap, 1e-5, 1e-13);

  // Standing on a corner.
  const Quaternion tilt = Quaternion::FromTwoVectors(Vector3(1.0, 1.0, 1.0), Vector3::UnitZ());
  const PlacedShape corner(cube, {{0.0, 0.0, -0.1 * std::sqrt(3.0) - 1e-5}, tilt});
  const PlacedShape face(cube, {{0.03, 0.02, 0.1}, Quaternion::Identity()});
  expect_places(overlaid(face, corner, 1e-3).points, {{0.0, 0.0, 0.0}});
}

TEST(Overlay, GapsAreFromSurfaceToSurfaceNotToThePlane) {
  // A flat tool over a roof: away from the ridge the roof falls off.
  const double quarter = std::numbers::pi / 4.0;
  const Shape cube = make_box({0.1, 0.1, 0.1}), plate = make_box({0.05, 0.05, 0.01});
  const PlacedShape roof(cube, {Vector3::Zero(), rotation_from_vector({quarter, 0.0, 0.0})});
  const PlacedShape tool(plate, {{0.0, 0.0, 0.1 * std::sqrt(2.0) + 0.011}, Quaternion::Identity()});
  const Overlaid near = overlaid(tool, roof, 1e-3), far = overlaid(tool, roof, 0.06);
  const double z = 0.1 * std::sqrt(2.0) + 0.001;
  expect_places(near.points, {{0.05, 0.0, z}, {-0.05, 0.0, z}});
  EXPECT_EQ(far.points.size(), 6u);
  for (const OverlayPoint& point : far.points) EXPECT_NEAR(point.gap, 0.001 + std::abs(point.p_WA.y()), 1e-12);
}

TEST(Overlay, HalfSpaceTakesEveryLowVertex) {
  const Shape cube = make_box({0.1, 0.1, 0.1}), floor = make_plane();
  const PlacedShape tool(cube, {{0.0, 0.0, 0.1001}, rotation_from_vector({1e-3, 0.0, 0.0})}), object(floor, {});
  EXPECT_EQ(overlaid(tool, object, 0.1e-3).points.size(), 2u);
  EXPECT_EQ(overlaid(tool, object, 1e-3).points.size(), 4u);
  for (const OverlayPoint& point : overlaid(tool, object, 1e-3).points) {
    EXPECT_NEAR(point.gap, point.p_WA.z(), 1e-15);
  }
}

TEST(Overlay, CurvedShapesGiveTheLinesAndCapsTheyRestOn) {
  const Shape floor = make_plane(), table = make_box({0.02, 0.02, 0.02});
  const PlacedShape ground(floor, {}), top(table, {{0.0, 0.0, -0.02}, Quaternion::Identity()});
  const Quaternion lying = rotation_from_vector({0.0, std::numbers::pi / 2.0, 0.0});
  const Shape capsule = make_capsule(0.01, 0.05), cylinder = make_cylinder(0.01, 0.05), sphere = make_sphere(0.01);
  const double gap = 1e-5;
  for (const Shape* shape : {&capsule, &cylinder}) {
    const PlacedShape tool(*shape, {{0.0, 0.0, 0.01 + gap}, lying});
    expect_places(overlaid(tool, ground, 1e-3).points, {{0.05, 0.0, gap}, {-0.05, 0.0, gap}});
    // Over a table narrower than it is long: where its line leaves the table.
    expect_places(overlaid(tool, top, 1e-3).points, {{0.02, 0.0, gap}, {-0.02, 0.0, gap}});
  }
  const PlacedShape ball(sphere, {{0.001, 0.002, 0.01 + gap}, Quaternion::Identity()});
  expect_places(overlaid(ball, top, 1e-3).points, {{0.001, 0.002, gap}});

  const PlacedShape standing(cylinder, {{0.0, 0.0, 0.05 + gap}, Quaternion::Identity()});
  const Overlaid cap = overlaid(standing, ground, 1e-3);
  EXPECT_EQ(cap.points.size(), static_cast<size_t>(FacingSurface::kCapCorners));
  for (const OverlayPoint& point : cap.points) {
    EXPECT_NEAR(point.p_WA.head<2>().norm(), 0.01, 1e-12);
    EXPECT_NEAR(point.gap, gap, 1e-12);
  }
  // Tilted, its nearest rim point is exact.
  const PlacedShape tilted(cylinder, {{0.0, 0.0, 0.0507}, rotation_from_vector({0.01, 0.02, 0.3})});
  const Overlaid rim = overlaid(tilted, ground, 1e-3);
  double least = 1.0;
  for (const OverlayPoint& point : rim.points) least = std::min(least, point.gap);
  EXPECT_NEAR(least, rim.query.distance, 1e-12);
}

// Side by side there is no area: the ends of the common line are what carries.
TEST(Overlay, LinesSideBySideGiveTheEndsOfWhatTheyShare) {
  const Quaternion lying = rotation_from_vector({0.0, std::numbers::pi / 2.0, 0.0});
  const Shape capsule = make_capsule(0.01, 0.05), cylinder = make_cylinder(0.01, 0.05);
  const double gap = 1e-5, height = 0.02 + gap;
  for (const Shape* upper : {&capsule, &cylinder}) {
    for (const Shape* lower : {&capsule, &cylinder}) {
      const PlacedShape object(*lower, {Vector3::Zero(), lying});
      for (const double shift : {0.0, 0.03}) {
        const PlacedShape tool(*upper, {{shift, 0.0, height}, lying});
        expect_places(overlaid(tool, object, 1e-4).points, {{0.05, 0.0, 0.01 + gap}, {shift - 0.05, 0.0, 0.01 + gap}});
      }
    }
  }
  // Along the edge of a roof, and longer than it.
  const Shape roof = make_box({0.02, 0.03, 0.03});
  const PlacedShape ridge(
      roof, {{0.0, 0.0, -0.03 * std::numbers::sqrt2}, rotation_from_vector({std::numbers::pi / 4.0, 0.0, 0.0})});
  const PlacedShape along(capsule, {{0.0, 0.0, 0.01 + gap}, lying});
  expect_places(overlaid(along, ridge, 1e-4).points, {{0.02, 0.0, gap}, {-0.02, 0.0, gap}});
}

TEST(Overlay, LinesThatNearlyCrossHaveTheGapsOfTheirBalls) {
  const Quaternion lying = rotation_from_vector({0.0, std::numbers::pi / 2.0, 0.0});
  const Shape capsule = make_capsule(0.01, 0.05);
  const double gap = 1e-5, turn = 0.02;
  const PlacedShape object(capsule, {Vector3::Zero(), lying});
  const PlacedShape tool(capsule, {{0.0, 0.0, 0.02 + gap}, Quaternion(rotation_from_vector({0.0, 0.0, turn}) * lying)});
  const Overlaid result = overlaid(tool, object, 1e-3);
  EXPECT_EQ(result.points.size(), 5u);  // where they cross, and the four ends, each over the other line
  for (const OverlayPoint& point : result.points) {
    const double beside = point.p_WA.head<2>().norm() * std::sin(turn);
    EXPECT_NEAR(point.gap, std::hypot(0.02 + gap, beside) - 0.02, 1e-8);
  }
}

struct RandomPair {
  Shape tool, object;
  Pose X_WT, X_WB;
};

RandomPair random_pair(std::mt19937_64& random, int i) {
  std::uniform_real_distribution<double> half(0.2, 1.0);
  const auto shape = [&](bool box) {
    return box ? make_box({half(random), half(random), half(random)})
               : make_hull(random_hull_points(random, 12 + i % 40, 1.0));
  };
  RandomPair pair{shape(i % 3 == 0), shape(i % 2 == 0), {}, random_pose(random, 0.3)};
  // Some face each other exactly.
  pair.X_WT.q = i % 5 == 0 ? pair.X_WB.q : random_rotation(random);
  pair.X_WT.p = pair.X_WB.p + 1.6 * random_unit(random);
  return pair;
}

// Each point's gap is that of the two surfaces over its place.
void expect_true_gaps(const Overlaid& result, int i) {
  std::set<std::uint64_t> features;
  const Vector3 middle = (result.points.front().p_WA + result.points.back().p_WA) / 2.0;
  for (const OverlayPoint& point : result.points) {
    EXPECT_TRUE(features.insert(point.feature).second);
    EXPECT_LT(point.gap, result.query.distance + result.query.margin);
    // A hair inside the outlines, where both lines exist; steep faces make up to a few thousand hairs of it.
    const Vector3 place = point.p_WA + 1e-9 * (middle - point.p_WA);
    const auto gap = gap_over(*result.query.tool, *result.query.object, place, result.query.n_W);
    if (gap) {
      EXPECT_NEAR(*gap, point.gap, 2e-6) << i;
    }
  }
}

// Over no place is the gap, tilted at random, less than over the points: they are the corners of the gap function.
void expect_no_lower_place(const Overlaid& result, std::mt19937_64& random, int i) {
  std::uniform_real_distribution<double> share(0.0, 1.0);
  const Vector3& n = result.query.n_W;
  Vector3 tilt = 0.1 * result.query.margin * random_unit(random);
  tilt -= n.dot(tilt) * n;
  double least = 1e300;
  for (const OverlayPoint& point : result.points) least = std::min(least, point.gap + tilt.dot(point.p_WA));
  for (int k = 0; k < 60; ++k) {
    const auto pick = [&] { return result.points[static_cast<size_t>(random() % result.points.size())].p_WA; };
    const Vector3 a = pick(), b = pick();
    const Vector3 place = a + share(random) * (b - a) + 0.1 * result.query.margin * random_vector(random, 1.0);
    const auto gap = gap_over(*result.query.tool, *result.query.object, place, n);
    if (!gap || *gap > result.query.distance + 0.5 * result.query.margin) continue;
    ASSERT_GE(*gap + tilt.dot(place), least - 1e-9) << i;
  }
}

TEST(Overlay, RandomPairsAgreeWithLinesCastThroughBoth) {
  std::mt19937_64 random(20);
  int apart = 0, overlapping = 0;
  for (int i = 0; i < sweep_size(3000); ++i) {
    const RandomPair pair = random_pair(random, i);
    const PlacedShape tool(pair.tool, pair.X_WT), object(pair.object, pair.X_WB);
    const Overlaid result = overlaid(tool, object, i % 4 == 0 ? 0.02 : 0.3);
    ++(result.query.distance > 0.0 ? apart : overlapping);
    ASSERT_FALSE(result.points.empty());
    expect_true_gaps(result, i);
    expect_no_lower_place(result, random, i);
  }
  EXPECT_GT(apart, sweep_size(200));
  EXPECT_GT(overlapping, sweep_size(200));
}

TEST(Overlay, AllocatesNothingAndSaysWhatDoesNotFit) {
  const Shape cube = make_box({0.1, 0.1, 0.1}), floor = make_plane();
  const PlacedShape tool(cube, {{0.0, 0.0, 0.1001}, Quaternion::Identity()}), object(floor, {});
  OverlayWorkspace workspace(8);
  std::array<OverlayPoint, 3> points;
  const OverlayQuery query{&tool, &object, {0.1, 0.1, 1e-4}, {0.1, 0.1, 0.0}, Vector3::UnitZ(), 1e-4, 1e-3};
  const AllocationCounter counter;
  EXPECT_EQ(overlay(query, workspace, points), 4);
  EXPECT_EQ(counter.count(), 0u);
  OverlayQuery bad = query;
  bad.p_WA.x() = std::nan("");
  EXPECT_EQ(overlay(bad, workspace, points), 0);
}

}  // namespace
}  // namespace tegotae::test
