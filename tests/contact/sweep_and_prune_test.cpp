// SPDX-License-Identifier: Apache-2.0
#include <tegotae/contact/sweep_and_prune.hpp>

#include <tests/random_shapes.hpp>
#include <tests/sweep_size.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace tegotae {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

BoundingBox box_at(const Vector3& centre, const Vector3& half) { return {centre - half, centre + half}; }

std::vector<int> by_brute_force(const std::vector<BoundingBox>& boxes, const BoundingBox& query) {
  std::vector<int> result;
  for (size_t i = 0; i < boxes.size(); ++i) {
    if (boxes[i].overlaps(query)) result.push_back(static_cast<int>(i));
  }
  return result;
}

std::vector<int> to_vector(std::span<const int> handles) { return {handles.begin(), handles.end()}; }

// Static and moving boxes with mixed handles, some unbounded or empty; a tool that wanders and now and then leaps.
class Scene {
 public:
  Scene(std::uint64_t seed, int static_count, int moving_count) : random_(seed) {
    for (int i = 0; i < static_count; ++i) add(random_box(), false);
    for (int i = 0; i < moving_count; ++i) add(random_box(), true);
    const BoundingBox below{{-kInfinity, -kInfinity, -kInfinity}, {kInfinity, kInfinity, -4.0}};
    const BoundingBox everywhere{Vector3::Constant(-kInfinity), Vector3::Constant(kInfinity)};
    add(below, false);
    add(everywhere, true);
    add({}, false);
    add({}, true);
    for (int i = 0; i < static_count; ++i) add(random_box(), false);
  }

  void step() {
    std::normal_distribution<double> normal;
    for (const int handle : moving_) {
      BoundingBox& box = boxes[static_cast<size_t>(handle)];
      const Vector3 move = 0.02 * Vector3(normal(random_), normal(random_), normal(random_));
      box.lower += move;
      box.upper += move;
      if (random_() % 200 == 0) box = random_box();
      pruner.update(handle, box);
    }
    tool += 0.05 * Vector3(normal(random_), normal(random_), normal(random_));
    if (random_() % 100 == 0) tool = test::random_vector(random_, 6.0);
  }

  BoundingBox query() { return box_at(tool, Vector3::Constant(0.8)); }

  std::vector<BoundingBox> boxes;
  SweepAndPrune pruner;
  Vector3 tool = Vector3::Zero();

 private:
  BoundingBox random_box() {
    std::uniform_real_distribution<double> half(0.01, 0.5);
    const double x = half(random_), y = half(random_), z = half(random_);
    return box_at(test::random_vector(random_, 5.0), {x, y, z});
  }
  void add(const BoundingBox& box, bool moving) {
    const int handle = moving ? pruner.add_moving(box) : pruner.add_static(box);
    EXPECT_EQ(handle, static_cast<int>(boxes.size()));
    boxes.push_back(box);
    if (moving) moving_.push_back(handle);
  }

  std::mt19937_64 random_;
  std::vector<int> moving_;
};

TEST(SweepAndPrune, TwoThousandCoherentStepsAgreeWithBruteForce) {
  Scene scene(60, 300, 100);
  size_t found = 0;
  for (int i = 0; i < test::sweep_size(2000); ++i) {
    scene.step();
    const auto expected = by_brute_force(scene.boxes, scene.query());
    ASSERT_EQ(to_vector(scene.pruner.candidates(scene.query())), expected) << "step " << i;
    found += expected.size();
  }
  EXPECT_GT(found, static_cast<size_t>(test::sweep_size(2000)));
}

TEST(SweepAndPrune, AgreesInAFullScene) {
  Scene scene(61, 5000, 100);
  for (int i = 0; i < 30; ++i) {
    for (int k = 0; k < 5; ++k) scene.step();
    ASSERT_EQ(to_vector(scene.pruner.candidates(scene.query())), by_brute_force(scene.boxes, scene.query()));
  }
}

TEST(SweepAndPrune, BoxesMayBeAddedBetweenQueries) {
  SweepAndPrune pruner;
  const BoundingBox query = box_at({0, 0, 0}, {1, 1, 1});
  EXPECT_THAT(pruner.candidates(query), IsEmpty());
  pruner.add_moving(box_at({0.5, 0, 0}, {1, 1, 1}));
  EXPECT_THAT(pruner.candidates(query), ElementsAre(0));
  pruner.add_static(box_at({0, 0.5, 0}, {1, 1, 1}));
  pruner.add_static(box_at({9, 0.5, 0}, {1, 1, 1}));
  pruner.add_moving(box_at({0, 0.5, 1}, {1, 1, 1}));
  EXPECT_THAT(pruner.candidates(query), ElementsAre(0, 1, 3));
  // Before the first query after an addition the lists are not sorted yet.
  pruner.add_moving(box_at({9, 0, 0}, {1, 1, 1}));
  pruner.update(4, box_at({0, 0, 0}, {1, 1, 1}));
  pruner.update(0, box_at({5, 0, 0}, {1, 1, 1}));
  EXPECT_THAT(pruner.candidates(query), ElementsAre(1, 3, 4));
}

TEST(SweepAndPrune, TouchingBoxesOverlap) {
  SweepAndPrune pruner;
  pruner.add_static(box_at({2, 0, 0}, {1, 1, 1}));
  pruner.add_moving(box_at({-2, 0, 0}, {1, 1, 1}));
  EXPECT_THAT(pruner.candidates(box_at({0, 0, 0}, {1, 1, 1})), ElementsAre(0, 1));
  EXPECT_THAT(pruner.candidates(box_at({1e-12, 0, 0}, {1, 1, 1})), ElementsAre(0));
}

TEST(SweepAndPrune, WhatIsNotANumberOverlapsNothing) {
  SweepAndPrune pruner;
  const BoundingBox good = box_at({0, 0, 0}, {1, 1, 1});
  BoundingBox bad = good;
  bad.lower.y() = std::nan("");
  pruner.add_static(bad);
  pruner.add_moving(good);
  EXPECT_THAT(pruner.candidates(bad), IsEmpty());
  EXPECT_THAT(pruner.candidates(good), ElementsAre(1));
  pruner.update(1, bad);
  EXPECT_THAT(pruner.candidates(good), IsEmpty());
  pruner.update(1, good);
  EXPECT_THAT(pruner.candidates(bad), IsEmpty());
  EXPECT_THAT(pruner.candidates(good), ElementsAre(1));
}

TEST(SweepAndPrune, MovesOnlyWhatMayMove) {
  SweepAndPrune pruner;
  const BoundingBox box = box_at({0, 0, 0}, {1, 1, 1});
  pruner.add_static(box);
  EXPECT_THROW(pruner.update(0, box), std::invalid_argument);
  EXPECT_THROW(pruner.update(1, box), std::invalid_argument);
  EXPECT_THROW(pruner.update(-1, box), std::invalid_argument);
}

}  // namespace
}  // namespace tegotae
