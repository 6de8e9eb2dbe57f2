// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/experiment_run.hpp>
#include <tests/lab/cube_session.hpp>
#include <tests/lab/temporary_folder.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace tegotae {
namespace {

const std::vector<TickRecord>& swept(size_t variant) {
  static const ExperimentResult result = [] {
    const TemporaryFolder folder;
    ExperimentRequest request;
    request.folder = folder.path();
    request.settings.method = "paper";
    return run_experiment(find_experiment("tilt-sweep"), request, [](double) {});
  }();
  return result.variants.at(variant).records;
}

constexpr size_t kPenetrating = 0, kNear = 1;

double greatest_force_step(const std::vector<TickRecord>& records) {
  double greatest = 0.0;
  for (size_t i = 1; i < records.size(); ++i) {
    const Vector3 step = records[i].wrench.force.vector() - records[i - 1].wrench.force.vector();
    greatest = std::max(greatest, step.norm());
  }
  return greatest;
}

TEST(TiltSweep, TurnsByAQuarterOfAThousandthOfADegreeATickAtConstantHeight) {
  const std::vector<TickRecord>& records = swept(kPenetrating);
  ASSERT_EQ(records.size(), 4001U);
  EXPECT_NEAR(angle_of(records.front()), -0.5 * kDegree, 1e-12);
  EXPECT_NEAR(angle_of(records.back()), 0.5 * kDegree, 1e-12);
  for (size_t i = 1; i < records.size(); ++i) {
    ASSERT_NEAR(angle_of(records[i]) - angle_of(records[i - 1]), 0.00025 * kDegree, 1e-12);
    ASSERT_NEAR(records[i].X_WT.p.y, kHalfEdge - 0.3e-3, 1e-15);
    ASSERT_GT(records[i].wrench.force.y, 0.0);
  }
}

TEST(TiltSweep, PenetratingPointsAloneLetTheForceJump) {
  EXPECT_NEAR(greatest_force_step(swept(kPenetrating)), 0.54, 0.01);
}

TEST(TiltSweep, AllNearPointsKeepTheForceContinuous) { EXPECT_LT(greatest_force_step(swept(kNear)), 0.002); }

// Far from the flat pose one edge carries alone, whichever set is taken; at the flat pose both agree too.
TEST(TiltSweep, BothSetsAgreeWhereTheSameContactsCarry) {
  const auto force_at = [](size_t variant, size_t tick) { return swept(variant)[tick].wrench.force.y; };
  EXPECT_NEAR(force_at(kPenetrating, 0), force_at(kNear, 0), 1e-9);
  EXPECT_NEAR(force_at(kPenetrating, 2000), kStiffness * 0.3e-3, 1e-3);
  EXPECT_NEAR(force_at(kNear, 2000), kStiffness * 0.3e-3, 1e-3);
}

}  // namespace
}  // namespace tegotae
