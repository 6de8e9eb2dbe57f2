// SPDX-License-Identifier: Apache-2.0
#include <tegotae/contact/box_tree.hpp>

#include <tests/allocation_counter.hpp>
#include <tests/random_shapes.hpp>
#include <tests/sweep_size.hpp>

#include <gtest/gtest.h>

#include <limits>
#include <set>

namespace tegotae::test {
namespace {

BoundingBox random_box(std::mt19937_64& random, double size) {
  const Vector3 centre = random_vector(random, 1.0), half = random_vector(random, size).cwiseAbs();
  return {centre - half, centre + half};
}

TEST(BoxTree, FindsWhatOneLookAtEachBoxFinds) {
  std::mt19937_64 random(41);
  size_t found = 0;
  for (const int count : {1, 2, 3, 7, 64, 200, 333}) {
    std::vector<BoundingBox> boxes;
    for (int i = 0; i < count; ++i) boxes.push_back(random_box(random, 0.1));
    if (count > 7) {
      boxes[3] = boxes[5];
      boxes[6].upper.x() = std::numeric_limits<double>::infinity();
      boxes[7] = {Vector3::Constant(-HUGE_VAL), Vector3::Constant(HUGE_VAL)};
    }
    const BoxTree tree(boxes);
    for (int k = 0; k < sweep_size(300); ++k) {
      const BoundingBox query = random_box(random, 0.4);
      std::set<int> expected, visited;
      for (int i = 0; i < count; ++i) {
        if (boxes[static_cast<size_t>(i)].overlaps(query)) expected.insert(i);
      }
      tree.visit_overlapping(query, [&](int i) { EXPECT_TRUE(visited.insert(i).second) << i << " twice"; });
      EXPECT_EQ(visited, expected) << count << " boxes";
      found += visited.size();
    }
  }
  EXPECT_GT(found, static_cast<size_t>(3 * sweep_size(300)));
}

TEST(BoxTree, LooksAtFewNodesWhereFewAreNear) {
  std::vector<BoundingBox> boxes;
  for (int i = 0; i < 1024; ++i) {
    const int column = i % 32, row = i / 32;
    const Vector3 p(column, row, 0.0);
    boxes.push_back({p, p + Vector3::Constant(0.5)});
  }
  const BoxTree tree(boxes);
  int visited = 0;
  const AllocationCounter counter;
  tree.visit_overlapping({{10.1, 10.1, 0.1}, {10.2, 10.2, 0.2}}, [&](int) { ++visited; });
  tree.visit_overlapping({{0.0, 0.0, 2.0}, {32.0, 32.0, 3.0}}, [&](int) { ++visited; });
  EXPECT_EQ(counter.count(), 0U);
  EXPECT_EQ(visited, 1);
}

TEST(BoxTree, WithoutBoxesNothingIsFound) {
  const BoxTree tree({});
  tree.visit_overlapping({Vector3::Constant(-1.0), Vector3::Constant(1.0)}, [](int) { FAIL(); });
  EXPECT_FALSE(tree.bounds().overlaps({Vector3::Constant(-1.0), Vector3::Constant(1.0)}));
}

TEST(BoxTree, ATurnedBoxHoldsTheCornersTightly) {
  std::mt19937_64 random(43);
  for (int k = 0; k < 200; ++k) {
    const BoundingBox box = random_box(random, 0.3);
    const Pose X_AB = random_pose(random, 1.0);
    BoundingBox expected;
    for (int i = 0; i < 8; ++i) {
      const Vector3 p =
          X_AB * Vector3((i & 1) != 0 ? box.upper.x() : box.lower.x(), (i & 2) != 0 ? box.upper.y() : box.lower.y(),
                         (i & 4) != 0 ? box.upper.z() : box.lower.z());
      expected = expected.united({p, p});
    }
    const BoundingBox turned = turned_box(box, X_AB);
    EXPECT_LT((turned.lower - expected.lower).norm() + (turned.upper - expected.upper).norm(), 1e-12);
  }
  const BoundingBox endless{Vector3(0.0, 0.0, -HUGE_VAL), Vector3::Ones()};
  EXPECT_TRUE(turned_box(endless, random_pose(random, 1.0)).overlaps({Vector3::Constant(9.0), Vector3::Constant(9.0)}));
}

}  // namespace
}  // namespace tegotae::test
