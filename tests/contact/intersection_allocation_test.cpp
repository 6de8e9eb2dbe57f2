// SPDX-License-Identifier: Apache-2.0
#include <tegotae/contact/dual_hull.hpp>
#include <tegotae/contact/interior_point.hpp>
#include <tegotae/contact/intersection.hpp>
#include <tegotae/contact/sweep_and_prune.hpp>

#include <tests/allocation_counter.hpp>
#include <tests/contact/intersection_cases.hpp>

#include <gtest/gtest.h>

#include <cstdio>

namespace tegotae {
namespace {

TEST(IntersectionAllocation, TheClipFormAndTheInteriorPointDoNotAllocate) {
  std::mt19937_64 random(70);
  ClipWorkspace workspace(64, 128);
  std::vector<IntersectionVertex> vertices(1024);
  for (int i = 0; i < 300; ++i) {
    const auto pair = test::random_case(random);
    const PlacedShape tool = pair.placed_tool(), object = pair.placed_object();
    const test::AllocationCounter counter;
    const int count = intersection_by_clipping(tool, object, pair.dilation, workspace, vertices);
    const InteriorPoint inner = interior_point(tool, object, pair.dilation);
    EXPECT_EQ(counter.count(), 0u) << "pair " << i << ": " << count << " vertices, " << inner.slack << " m of slack";
  }
  const test::AllocationCounter counter;
  const std::vector<int> memory(100);
  EXPECT_EQ(counter.count(), 1u) << "the counter itself: " << memory.size();
}

TEST(IntersectionAllocation, AWarmSweepAndPruneDoesNotAllocate) {
  std::mt19937_64 random(71);
  SweepAndPrune pruner;
  const auto box = [&] {
    const Vector3 centre = test::random_vector(random, 2.0);
    return BoundingBox{centre.array() - 0.3, centre.array() + 0.3};
  };
  for (int i = 0; i < 500; ++i) pruner.add_static(box());
  for (int i = 0; i < 100; ++i) pruner.add_moving(box());
  size_t found = pruner.candidates(box()).size();
  const test::AllocationCounter counter;
  for (int i = 0; i < 200; ++i) {
    pruner.update(500 + i % 100, box());
    found += pruner.candidates(box()).size();
  }
  EXPECT_EQ(counter.count(), 0u);
  EXPECT_GT(found, 200u);
}

// Qhull keeps its messages to itself and frees what it took, also when it fails: the dual form refuses before that,
// so points that span no volume are given to it directly.
TEST(IntersectionAllocation, QhullFailsInSilence) {
  ::testing::internal::CaptureStderr();
  ::testing::internal::CaptureStdout();
  const std::vector<Vector3> flat{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}, {0.5, 0.2, 0}};
  int answered = 0;
  for (int i = 0; i < 100; ++i) {
    answered += hull_facets(flat) || hull_facets({flat.data(), 2}) || hull_facets({}) ? 1 : 0;
  }
  std::fflush(stderr);
  std::fflush(stdout);
  EXPECT_EQ(::testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(::testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(answered, 0);
}

}  // namespace
}  // namespace tegotae
