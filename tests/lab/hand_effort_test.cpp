// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/simulated_presets.hpp>
#include <tegotae/lab/hand_effort.hpp>
#include <tegotae/math/rotation.hpp>

#include <gtest/gtest.h>

#include <stdexcept>
#include <vector>

namespace tegotae {
namespace {

constexpr EffortLimits kStrong{1e3, 1e3};

const HandImpedance& hand() { return simulated_hand("moderate"); }

std::vector<TickRecord> pressed(int count, const Pose& X_WT, const Wrench& about_centre_of_mass) {
  std::vector<TickRecord> records(static_cast<size_t>(count));
  for (size_t i = 0; i < records.size(); ++i) {
    records[i].time = 1e-3 * static_cast<double>(i);
    records[i].X_WT = X_WT;
    records[i].wrench = about_centre_of_mass;
  }
  return records;
}

TEST(HandEffort, TheHandsSpringsCarryTheWrenchAboutTheGrip) {
  Tool tool;
  tool.mass.centre_of_mass = {0.0, 0.1, 0.0};
  const Pose X_WT{{0.1, 0.2, 0.3}, rotation_from_vector({0.0, 0.0, 1.0})};
  const Wrench wrench{{1.0, -3.0, 0.5}, {0.1, 0.0, -0.2}};
  const Trajectory meant = with_effort(pressed(50, X_WT, wrench), 5.0, tool, hand(), kStrong);
  EXPECT_EQ(meant.start(), 5.0);
  const Vector3 torque = wrench.torque + (X_WT.q * Vector3(0.0, 0.1, 0.0)).cross(wrench.force);
  for (const Trajectory::Sample& sample : meant.samples()) {
    ASSERT_LT((hand().stiffness * (sample.X_WT.p - X_WT.p) + wrench.force).norm(), 1e-9);
    const Vector3 turn = rotation_vector(sample.X_WT.q * X_WT.q.conjugate());
    ASSERT_LT((hand().rotational_stiffness * turn + torque).norm(), 1e-9);
  }
}

TEST(HandEffort, PressesByNoLeaps) {
  std::vector<TickRecord> records = pressed(400, {}, {});
  for (size_t i = 200; i < records.size(); ++i) records[i].wrench = Wrench{{0.0, 0.0, 7.0}, Vector3::Zero()};
  const std::vector<Trajectory::Sample> meant = with_effort(records, 0.0, Tool{}, hand(), kStrong).samples();
  for (size_t i = 1; i < meant.size(); ++i) {
    ASSERT_LE((meant[i].X_WT.p - meant[i - 1].X_WT.p).norm(), 7.0 / 100.0 / hand().stiffness);
  }
  EXPECT_EQ(meant[100].X_WT.p.z(), 0.0);
  EXPECT_NEAR(meant[200].X_WT.p.z(), -0.5 * 7.0 / hand().stiffness, 1e-4) << "half the leap at its middle";
  EXPECT_NEAR(meant[300].X_WT.p.z(), -7.0 / hand().stiffness, 1e-12);
}

TEST(HandEffort, PressesWithNoMoreThanTheInterfaceCarries) {
  const Wrench wrench{{0.0, 0.0, 50.0}, {2.0, 0.0, 0.0}};
  const Trajectory meant = with_effort(pressed(10, {}, wrench), 0.0, Tool{}, hand(), {7.0, 0.1});
  EXPECT_NEAR(meant.samples()[5].X_WT.p.z(), -7.0 / hand().stiffness, 1e-12);
  EXPECT_NEAR(rotation_vector(meant.samples()[5].X_WT.q).x(), -0.1 / hand().rotational_stiffness, 1e-12);
}

TEST(HandEffort, NeedsRecords) { EXPECT_THROW(with_effort({}, 0.0, Tool{}, hand(), kStrong), std::invalid_argument); }

}  // namespace
}  // namespace tegotae
