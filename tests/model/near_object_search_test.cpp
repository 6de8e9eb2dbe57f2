// SPDX-License-Identifier: Apache-2.0
// Bodies of many pieces: what is near, against a look at every pair.
#include <tegotae/model/near_object_search.hpp>

#include <tests/random_shapes.hpp>
#include <tests/sweep_size.hpp>
#include <tests/torus_pieces.hpp>

#include <gtest/gtest.h>

#include <array>
#include <map>

namespace tegotae::test {
namespace {

using Distances = std::map<std::array<int, 3>, double>;

// A comb, a torus that moves, one that stands, and a moving body of few pieces.
SceneGeometry combs_and_tori() {
  SceneGeometry scene;
  scene.tool.pieces = comb_pieces(10);
  for (int b = 0; b < 3; ++b) {
    Body body;
    body.pieces = b < 2 ? torus_pieces(25, 8) : comb_pieces(4);
    body.p_BC = Vector3(0.01, 0.0, 0.0);
    if (b != 1) body.moving_index = scene.moving_count++;
    body.X_WB = {Vector3(0.15 * b, 0.0, 0.0), Quaternion::Identity()};
    scene.bodies.push_back(body);
  }
  return scene;
}

// Certified distances of all pairs, negative or zero where they overlap.
Distances all_distances(const SceneGeometry& scene, const Pose& X_WT, const std::vector<BodyState>& states) {
  Distances distances;
  for (int t = 0; t < 10; ++t) {
    const PlacedShape tool(scene.tool.pieces[static_cast<size_t>(t)], X_WT);
    for (int b = 0; b < 3; ++b) {
      const Body& body = scene.bodies[static_cast<size_t>(b)];
      const Pose X_WB = body.moving_index < 0 ? body.X_WB : states[static_cast<size_t>(body.moving_index)].X_WB;
      for (int p = 0; p < static_cast<int>(body.pieces.size()); ++p) {
        ClosestPointsCache cache;
        const ClosestPoints closest =
            closest_points(tool, PlacedShape(body.pieces[static_cast<size_t>(p)], X_WB), cache);
        distances[{t, b, p}] = closest.separation == Separation::kSeparated ? closest.distance : 0.0;
      }
    }
  }
  return distances;
}

// Greatest speed of a point of the body's piece, m/s.
double speed_of(const SceneGeometry& scene, const std::array<int, 3>& pieces, const std::vector<BodyState>& states) {
  const Body& body = scene.bodies[static_cast<size_t>(pieces[1])];
  if (body.moving_index < 0) return 0.0;
  const Twist& V_WB = states[static_cast<size_t>(body.moving_index)].V_WB;
  const Shape& piece = body.pieces[static_cast<size_t>(pieces[2])];
  return V_WB.linear.norm() + V_WB.angular.norm() * ((piece.X_BS.p - body.p_BC).norm() + piece.polytope->radius);
}

TEST(NearObjectSearch, OfBodiesOfManyPiecesThePairsAreThoseOfALookAtAll) {
  const SceneGeometry scene = combs_and_tori();
  NearObjectSearch search(scene);
  std::mt19937_64 random(61);
  std::vector<BodyState> states(2);
  size_t near = 0;
  for (int step = 0; step < sweep_size(60); ++step) {
    const Pose X_WT = random_pose(random, 0.12);
    for (BodyState& state : states) {
      state.X_WB = random_pose(random, 0.12);
      state.V_WB.linear = random_vector(random, 0.2);
      state.V_WB.angular = random_vector(random, 2.0);
    }
    const Reach reach{0.003, 0.01, 0.3};
    std::map<std::array<int, 3>, NearPair> found;
    double last = -1e300;
    for (const NearPair& pair : search.find(X_WT, states, reach)) {
      EXPECT_TRUE(found.emplace(std::array<int, 3>{pair.tool_piece, pair.body, pair.body_piece}, pair).second);
      EXPECT_GE(pair.distance, last);
      last = pair.distance;
    }
    near += found.size();
    for (const auto& [pieces, distance] : all_distances(scene, X_WT, states)) {
      const auto pair = found.find(pieces);
      if (pair != found.end()) {
        EXPECT_NEAR(std::max(pair->second.distance, 0.0), distance, 1e-9);
        EXPECT_LT(distance, pair->second.reach);
      } else {
        EXPECT_GE(distance, reach.at(speed_of(scene, pieces, states)) - 1e-12)
            << step << ": " << pieces[0] << " " << pieces[1] << " " << pieces[2];
      }
    }
  }
  EXPECT_GT(near, static_cast<size_t>(8 * sweep_size(60)));
}

}  // namespace
}  // namespace tegotae::test
