// SPDX-License-Identifier: Apache-2.0
// What the proxy method shows where it rubs.
#include <tegotae/lab/friction_tasks.hpp>
#include <tests/lab/performance.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

namespace tegotae {
namespace {

constexpr double kTaskMu = 0.5;

class FrictionTask : public testing::TestWithParam<const char*> {};

TEST_P(FrictionTask, KeepsToTheReference) {
  // N m: where no torque is due, it is held to parts of a millinewton at a centimetre.
  constexpr double kLeastTorque = 1e-5;
  const Performance done = perform(find_experiment(GetParam()));
  EXPECT_GT(done.metrics.force.peak, 0.5);
  expect_kept_to_reference(done, kLeastTorque);
}

INSTANTIATE_TEST_SUITE_P(All, FrictionTask,
                         testing::Values("slope", "drag-face", "drag-edge", "drag-vertex", "twist-square",
                                         "twist-disc"));

class Drag : public testing::TestWithParam<const char*> {};

TEST_P(Drag, IsTheCoefficientTimesTheNormalForce) {
  const Performance done = perform(find_experiment(GetParam()));
  size_t steady = 0;
  double unchanged = at_time(done, 0.5).wrench.force.z;
  for (size_t i = 0; i < done.records.size(); ++i) {
    const Vector3 f = done.records[i].wrench.force;
    if (done.records[i].time < 0.5 || !done.reference[i].defined || done.reference[i].wrench.force.x() == 0.0) continue;
    if (std::abs(done.reference[i].wrench.force.x()) < 0.999 * kTaskMu * done.reference[i].wrench.force.z()) continue;
    ASSERT_NEAR(f.head<2>().norm(), kTaskMu * f.z(), 0.01 * kTaskMu * f.z()) << done.records[i].time;
    if (GetParam() == std::string("drag-face")) {
      ASSERT_NEAR(f.z(), unchanged, 0.01 * unchanged);
    }
    ++steady;
  }
  EXPECT_GT(steady, 2000U);
}

INSTANTIATE_TEST_SUITE_P(All, Drag, testing::Values("drag-face", "drag-edge", "drag-vertex"));

TEST(Slope, SlipsWithinHalfADegreeOfTheAngleOfFriction) {
  const Performance done = perform(find_experiment("slope"));
  const double start = at_time(done, 0.5).X_WP.p.x;
  double slipped_at = 0.0;
  for (const TickRecord& record : done.records) {
    const double pull = -record.wrench.force.x, elastic = 1e-5 * pull / done.settings.stiffness;
    if (record.X_WP.p.x - start <= elastic + 5e-6) continue;
    slipped_at = std::atan2(record.X_WT.p.x - start, record.X_WP.p.z - record.X_WT.p.z) * 180.0 / std::numbers::pi;
    break;
  }
  EXPECT_NEAR(slipped_at, std::atan(kTaskMu) * 180.0 / std::numbers::pi, 0.5);
}

TEST(Twist, IsThatOfUniformPressure) {
  for (const auto& [name, mean_distance] : {std::pair("twist-square", mean_distance_in_square(0.06)),
                                            std::pair("twist-disc", mean_distance_in_disc(0.03))}) {
    const Performance done = perform(find_experiment(name));
    for (const double time : {1.8, 4.0}) {
      const TickRecord& record = at_time(done, time);
      const double expected = kTaskMu * record.wrench.force.z * mean_distance;
      EXPECT_NEAR(std::abs(record.wrench.torque.z), expected, 0.05 * expected) << name << " " << time;
    }
    EXPECT_LT(at_time(done, 1.8).wrench.torque.z, 0.0);
    EXPECT_GT(at_time(done, 4.0).wrench.torque.z, 0.0);
  }
}

TEST(MeanDistance, OfASquareAndADiscAsManyRandomPlacesHaveIt) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> place(-0.5, 0.5);
  double square = 0.0, disc = 0.0;
  int in_disc = 0;
  constexpr int kPlaces = 200000;
  for (int i = 0; i < kPlaces; ++i) {
    const double distance = std::hypot(place(random), place(random));
    square += distance / kPlaces;
    if (distance > 0.5) continue;
    disc += distance;
    ++in_disc;
  }
  EXPECT_NEAR(mean_distance_in_square(1.0), square, 2e-3);
  EXPECT_NEAR(mean_distance_in_disc(0.5), disc / in_disc, 2e-3);
}

}  // namespace
}  // namespace tegotae
