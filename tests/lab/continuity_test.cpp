// SPDX-License-Identifier: Apache-2.0
#include <tests/lab/cube_session.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace tegotae {
namespace {

// The cube, its centre 0.3 mm too low for a flat face, swept from -0.5 to 0.5 degrees in steps of 0.00025 degrees, one
// a tick. Returns the greatest step of the force from tick to tick, N.
double greatest_force_step(ConstraintSet constraint_set) {
  constexpr double kDuration = 4.0;
  SettingsRequest request = with_metric_length(0.0);
  request.constraint_set = constraint_set;
  const auto records = play_cube(cube_motion(
                                     kDuration, [](double) { return kHalfEdge - 0.3e-3; },
                                     [](double t) { return (t / kDuration - 0.5) * kDegree; }),
                                 request);
  EXPECT_EQ(records.size(), 4001U);
  EXPECT_NEAR(angle_of(records[1]) - angle_of(records[0]), 0.00025 * kDegree, 1e-12);
  double greatest = 0.0;
  for (size_t i = 1; i < records.size(); ++i) {
    EXPECT_GT(records[i].wrench.force.y, 0.0);
    const Vector3 step = records[i].wrench.force.vector() - records[i - 1].wrench.force.vector();
    greatest = std::max(greatest, step.norm());
  }
  return greatest;
}

TEST(Continuity, PenetratingPointsAloneLetTheForceJump) {
  EXPECT_NEAR(greatest_force_step(ConstraintSet::kPenetratingPoints), 0.54, 0.01);
}

TEST(Continuity, AllNearPointsKeepTheForceContinuous) {
  EXPECT_LT(greatest_force_step(ConstraintSet::kNearPoints), 0.002);
}

}  // namespace
}  // namespace tegotae
