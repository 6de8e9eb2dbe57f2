// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/near_pairs.hpp>

#include <tests/allocation_counter.hpp>
#include <tests/random_shapes.hpp>
#include <tests/sweep_size.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <memory>

namespace tegotae::test {
namespace {

// A tool of three pieces, a static body and two moving ones of five pieces each, all in a space of 0.2 m.
class NearPairsTest : public ::testing::Test {
 protected:
  void SetUp() override {
    for (int i = 0; i < 3; ++i) scene_.tool.pieces.push_back(piece());
    for (int b = 0; b < 3; ++b) {
      Body body;
      for (int p = 0; p < 5; ++p) body.pieces.push_back(piece());
      body.X_WB = random_pose(random_, 0.1);
      body.p_BC = random_vector(random_, 0.02);
      if (b > 0) body.moving_index = scene_.moving_count++;
      scene_.bodies.push_back(body);
    }
    pairs_ = std::make_unique<NearPairs>(scene_);
  }

  Shape piece() { return make_hull(random_hull_points(random_, 12, 0.01), random_pose(random_, 0.03)); }

  // Names about two thirds of all pairs, in random order.
  void name() {
    ++model_->sequence;
    model_->pair_count = 0;
    model_->body_count = 2;
    const bool turned = random_() % 2 == 0;
    for (int i = 0; i < 2; ++i) {
      const int b = turned ? 2 - i : 1 + i;
      const Body& body = scene_.bodies[static_cast<size_t>(b)];
      model_->bodies[static_cast<size_t>(i)] = {body.moving_index, body.X_WB, Twist{}, body.X_WB * body.p_BC};
      place_[b] = i;
    }
    for (int k = 0; k < 45; ++k) {
      if (random_() % 3 == 0) continue;
      NearPieces& pair = model_->pairs[static_cast<size_t>(model_->pair_count++)];
      pair = {k % 3, k / 15, (k / 3) % 5, k / 15 == 0 ? -1 : place_[k / 15], 0.0};
      if (random_() % 2 == 0) pair.n_B = random_unit(random_);
    }
    std::shuffle(model_->pairs.begin(), model_->pairs.begin() + model_->pair_count, random_);
  }

  void move() {
    const Vector3 p_WC = X_WT_.p;
    const Vector3 dr = random_vector(random_, 2e-4), dtheta = random_vector(random_, 2e-3);
    X_WT_ = displaced(X_WT_, p_WC, dr, dtheta);
    pairs_->travel(dr.norm() + 0.06 * dtheta.norm());
    for (int b = 1; b < 3; ++b) {
      Body& body = scene_.bodies[static_cast<size_t>(b)];
      body.X_WB = displaced(body.X_WB, body.X_WB.p, random_vector(random_, 2e-4), random_vector(random_, 2e-3));
      NearBody& near = model_->bodies[static_cast<size_t>(place_[b])];
      near.X_WB = body.X_WB;
      near.p_WC = body.X_WB * body.p_BC;
    }
  }

  double distance(const TrackedPair& pair) const {
    const Body& body = scene_.bodies[static_cast<size_t>(pair.body)];
    ClosestPointsCache cache;
    const ClosestPoints closest = closest_points({scene_.tool.pieces[static_cast<size_t>(pair.tool_piece)], X_WT_},
                                                 {body.pieces[static_cast<size_t>(pair.body_piece)], body.X_WB}, cache);
    return closest.separation == Separation::kSeparated ? closest.distance : 0.0;
  }

  std::mt19937_64 random_{17};
  SceneGeometry scene_;
  std::unique_ptr<IntermediateRepresentation> model_ = std::make_unique<IntermediateRepresentation>();
  std::unique_ptr<NearPairs> pairs_;
  std::map<int, int> place_;
  Pose X_WT_{{0.0, 0.0, 0.0}, Quaternion::Identity()};
};

TEST_F(NearPairsTest, RoomsStayLowerBoundsOverMotionsAndModels) {
  int positive = 0;
  for (int step = 0; step < sweep_size(400); ++step) {
    if (step % 7 == 0) name();
    EXPECT_EQ(pairs_->take(*model_, X_WT_), step % 7 == 0);
    ASSERT_EQ(pairs_->count(), model_->pair_count);
    // Some pairs become contacts and are given back with what is known of them.
    for (int i = 0; i < pairs_->count(); ++i) {
      const double room = pairs_->take_out(i, 0), true_distance = distance((*pairs_)[i]);
      ASSERT_LE(room, true_distance + 1e-9) << step << " " << i;
      positive += room > 0.0 ? 1 : 0;
      const bool measured = random_() % 4 == 0;
      pairs_->put_back(i, measured ? true_distance : room, random_unit(random_), {});
    }
    move();
  }
  EXPECT_GT(positive, 3 * sweep_size(400));
}

TEST_F(NearPairsTest, ThoseWithinALimitAreVisitedAndNoOthers) {
  name();
  for (int step = 0; step < sweep_size(300); ++step) {
    pairs_->take(*model_, X_WT_);
    const double limit = 1e-3 * static_cast<double>(random_() % 40) - 0.01;
    std::map<int, double> rooms;
    double least = NearPairs::kFar;
    for (int i = 0; i < pairs_->count(); ++i) {
      rooms[i] = pairs_->take_out(i, 0);
      least = std::min(least, rooms[i]);
    }
    for (const auto& [i, room] : rooms) pairs_->put_back(i, room, Vector3::UnitZ(), {});
    std::map<int, double> visited;
    // Twice: the second time the look may be spared.
    for (int time = 0; time < 2; ++time) {
      visited.clear();
      pairs_->visit_within(limit, [&](int i) { visited[i] = rooms[i]; });
      for (const auto& [i, room] : rooms) {
        EXPECT_EQ(visited.count(i) == 1, room <= limit) << step << " pair " << i << " room " << room;
      }
    }
    const int nearest = pairs_->nearest_below(NearPairs::kFar);
    ASSERT_GE(nearest, 0);
    EXPECT_EQ(rooms[nearest], least);
    EXPECT_EQ(pairs_->nearest_below(least - 1e-9), -1);
    move();
  }
}

TEST_F(NearPairsTest, FormerPairsAreFoundAgainAndNothingAllocates) {
  name();
  pairs_->take(*model_, X_WT_);
  for (int round = 0; round < 50; ++round) {
    std::vector<TrackedPair> before;
    for (int i = 0; i < pairs_->count(); ++i) before.push_back((*pairs_)[i]);
    name();
    const AllocationCounter counter;
    pairs_->take(*model_, X_WT_);
    EXPECT_EQ(counter.count(), 0u);
    for (int i = 0; i < static_cast<int>(before.size()); ++i) {
      const auto named = model_->used_pairs();
      const auto there = std::find_if(named.begin(), named.end(), [&](const NearPieces& pair) {
        const TrackedPair& former = before[static_cast<size_t>(i)];
        return pair.tool_piece == former.tool_piece && pair.body == former.body && pair.body_piece == former.body_piece;
      });
      EXPECT_EQ(pairs_->renamed(i), there == named.end() ? -1 : static_cast<int>(there - named.begin()));
    }
  }
}

}  // namespace
}  // namespace tegotae::test
