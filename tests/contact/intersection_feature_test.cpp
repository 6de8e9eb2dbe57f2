// SPDX-License-Identifier: Apache-2.0
#include <tegotae/contact/interior_point.hpp>
#include <tegotae/contact/intersection.hpp>

#include <tests/contact/half_space_oracle.hpp>
#include <tests/contact/intersection_cases.hpp>
#include <tests/sweep_size.hpp>

#include <gtest/gtest.h>

#include <map>

namespace tegotae {
namespace {

using Kind = IntersectionVertexKind;
using test::IntersectionCase;

TEST(IntersectionFeature, PacksAndUnpacks) {
  const int last = IntersectionFeature::kIndexLimit - 1;
  for (const Kind kind : {Kind::kToolVertex, Kind::kObjectVertex, Kind::kObjectCorner, Kind::kToolEdgeObjectFace,
                          Kind::kObjectEdgeToolFace}) {
    for (const int index : {0, 1, last}) {
      const IntersectionFeature feature{kind, index, last - index, index};
      EXPECT_NE(feature.packed(), 0u);
      const auto back = IntersectionFeature::unpacked(feature.packed());
      EXPECT_EQ(back.kind, kind);
      EXPECT_EQ(back.a, index);
      EXPECT_EQ(back.b, last - index);
      EXPECT_EQ(back.c, index);
    }
  }
}

double distance_to_face(const PlacedShape& placed, int face, const Vector3& dilation_W, const Vector3& p_W) {
  const auto& f = placed.shape->polytope->faces[static_cast<size_t>(face)];
  return (placed.R_WS * f.normal).dot(p_W - placed.p_WS) - f.offset -
         std::max(0.0, (placed.R_WS * f.normal).dot(dilation_W));
}

double distance_to_edge(const PlacedShape& placed, int edge, const Vector3& p_W) {
  const Polytope& polytope = *placed.shape->polytope;
  const auto& e = polytope.edges[static_cast<size_t>(edge)];
  const Vector3 u = polytope.vertices[static_cast<size_t>(e.vertex[0])];
  const Vector3 along = (polytope.vertices[static_cast<size_t>(e.vertex[1])] - u).normalized();
  return (placed.to_shape(p_W) - u).cross(along).norm();
}

// The distance of a vertex from the features that its name tells of, m.
double distance_to_features(const IntersectionCase& pair, const IntersectionVertex& vertex) {
  const PlacedShape tool = pair.placed_tool(), object = pair.placed_object();
  const Vector3 none = Vector3::Zero();
  const auto f = IntersectionFeature::unpacked(vertex.feature);
  const auto from_object = [&](int face) {
    return std::abs(distance_to_face(object, face, pair.dilation, vertex.p_W));
  };
  switch (f.kind) {
    case Kind::kToolVertex:
      return (tool.to_world(tool.shape->polytope->vertices[static_cast<size_t>(f.a)]) - vertex.p_W).norm();
    case Kind::kObjectVertex: {
      double greatest = 0.0;
      for (size_t k = 0; k < object.shape->polytope->faces.size(); ++k) {
        const auto loop = object.shape->polytope->vertices_of(object.shape->polytope->faces[k]);
        const bool touches = std::find(loop.begin(), loop.end(), f.a) != loop.end();
        if (touches) greatest = std::max(greatest, from_object(static_cast<int>(k)));
      }
      return greatest;
    }
    case Kind::kObjectCorner:
      return std::max({from_object(f.a), from_object(f.b), from_object(f.c)});
    case Kind::kToolEdgeObjectFace:
      return std::max(distance_to_edge(tool, f.a, vertex.p_W), from_object(f.b));
    case Kind::kObjectEdgeToolFace:
      return std::max({from_object(f.a), from_object(f.b), std::abs(distance_to_face(tool, f.c, none, vertex.p_W))});
    case Kind::kUnknown:
      break;
  }
  return 1e300;
}

TEST(IntersectionFeature, NamesTheFeaturesThatMeetInTheVertex) {
  std::mt19937_64 random(50);
  ClipWorkspace workspace(256, 512);
  std::map<Kind, int> seen;
  for (int i = 0; i < test::sweep_size(1000); ++i) {
    const IntersectionCase pair = test::random_case(random);
    if (!pair.object.is_bounded()) continue;
    for (const auto& vertex : test::clip(pair, workspace)) {
      ++seen[IntersectionFeature::unpacked(vertex.feature).kind];
      ASSERT_LT(distance_to_features(pair, vertex), 1e-9) << "pair " << i;
    }
  }
  EXPECT_EQ(seen.size(), 5u) << "every kind occurs";
}

std::map<std::uint64_t, Vector3> by_feature(const std::vector<IntersectionVertex>& vertices) {
  std::map<std::uint64_t, Vector3> result;
  for (const auto& vertex : vertices) result[vertex.feature] = vertex.p_W;
  return result;
}

// Between two steps of 1e-7 m and 1e-7 rad hardly ever a vertex comes or goes; all others keep their names.
TEST(IntersectionFeature, StaysWithItsVertexUnderSmallMotions) {
  std::mt19937_64 random(51);
  ClipWorkspace workspace(256, 512);
  int kept = 0, changed = 0;
  for (int i = 0; i < test::sweep_size(400); ++i) {
    IntersectionCase pair = test::random_case(random);
    auto before = by_feature(test::clip(pair, workspace));
    for (int step = 0; step < 5; ++step) {
      const Vector3 dr = 1e-7 * test::random_unit(random), dtheta = 1e-7 * test::random_unit(random);
      pair.X_WT = displaced(pair.X_WT, pair.X_WT.p, dr, dtheta);
      const auto after = by_feature(test::clip(pair, workspace));
      for (const auto& [feature, p] : after) {
        const auto partner = before.find(feature);
        if (partner == before.end()) {
          ++changed;
          continue;
        }
        EXPECT_LT((partner->second - p).norm(), 1e-4) << "pair " << i;
        ++kept;
      }
      before = after;
    }
  }
  EXPECT_GT(kept, test::sweep_size(10000));
  EXPECT_LT(changed, kept / 10000 + 1);
}

// Coincident features: a cube that stands on another one, jittered by rounding, keeps its names.
TEST(IntersectionFeature, IsTheSameForCoincidentFeaturesInEveryPlace) {
  std::mt19937_64 random(52);
  ClipWorkspace workspace(64, 64);
  const Shape cube = make_box({0.5, 0.5, 0.5}), brick = make_box({0.5, 0.3, 0.2});
  for (const Shape& tool : {cube, brick}) {
    const IntersectionCase start{tool, cube, {{0.0, 0.2, 0.45}, Quaternion::Identity()}, {}, Vector3::Zero()};
    const auto expected = by_feature(test::clip(start, workspace));
    for (int i = 0; i < 100; ++i) {
      IntersectionCase pair = start;
      const Pose X = test::random_pose(random, 2.0);
      pair.X_WT = X * pair.X_WT;
      pair.X_WO = X * pair.X_WO;
      const auto moved = by_feature(test::clip(pair, workspace));
      ASSERT_EQ(moved.size(), expected.size());
      for (const auto& [feature, p] : moved) {
        ASSERT_TRUE(expected.contains(feature)) << "motion " << i;
        EXPECT_LT((X * expected.at(feature) - p).norm(), 1e-9);
      }
    }
  }
}

}  // namespace
}  // namespace tegotae
