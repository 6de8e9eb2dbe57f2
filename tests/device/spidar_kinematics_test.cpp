// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/spidar_kinematics.hpp>
#include <tegotae/device/spidar_presets.hpp>
#include <tegotae/math/rotation.hpp>

#include <tests/allocation_counter.hpp>
#include <tests/device/spidar_poses.hpp>
#include <tests/sweep_size.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

namespace tegotae {
namespace {

using test::SpidarPoses;

constexpr double kDegree = 3.14159265358979323846 / 180.0;
constexpr double kWay = 0.02, kTurn = 30.0 * kDegree;

/// Lengths as the counts of encoders tell them that were reset at the centre.
SpidarVector quantised(const SpidarGeometry& geometry, const SpidarVector& lengths) {
  const SpidarVector at_centre = spidar_strings(geometry, {}).lengths;
  SpidarVector result;
  for (int i = 0; i < kSpidarStrings; ++i) {
    const double pulse = geometry.strings[static_cast<std::size_t>(i)].metres_per_pulse;
    result[i] = at_centre[i] + pulse * std::round((lengths[i] - at_centre[i]) / pulse);
  }
  return result;
}

double turn_left(const Pose& a, const Pose& b) { return rotation_vector(a.q * b.q.conjugate()).norm(); }

TEST(SpidarKinematics, JacobianIsTheNegativeTransposeOfTheWrenchMatrix) {
  constexpr double kStep = 1e-6;  // m, rad: central differences are then right to 1e-9
  SpidarPoses random(1);
  for (const SpidarPreset& preset : spidar_presets()) {
    const Pose X_SG = random.pose(kWay, kTurn);
    const SpidarStrings strings = spidar_strings(preset.geometry, X_SG);
    for (int k = 0; k < 6; ++k) {
      Vector6 step = Vector6::Zero();
      step[k] = kStep;
      const auto lengths_at = [&](double sign) {
        const Pose moved = displaced(X_SG, X_SG.p, sign * step.head<3>(), sign * step.tail<3>());
        return spidar_strings(preset.geometry, moved).lengths;
      };
      const SpidarVector slope = (lengths_at(1.0) - lengths_at(-1.0)) / (2.0 * kStep);
      EXPECT_LT((slope + strings.wrenches.row(k).transpose()).cwiseAbs().maxCoeff(), 1e-8) << preset.name << k;
    }
  }
}

TEST(SpidarKinematics, ExactLengthsGiveThePoseFromTheCentre) {
  SpidarPoses random(2);
  int most_steps = 0;
  for (const SpidarPreset& preset : spidar_presets()) {
    for (int k = 0; k < test::sweep_size(3000); ++k) {
      const Pose X_SG = random.pose(kWay, kTurn);
      const SpidarPose found = spidar_pose(preset.geometry, spidar_strings(preset.geometry, X_SG).lengths, {});
      ASSERT_EQ(found.fit, SpidarFit::kConverged) << preset.name << k;
      ASSERT_LT((found.X_SG.p - X_SG.p).norm(), 1e-12);
      ASSERT_LT(turn_left(found.X_SG, X_SG), 1e-10);
      ASSERT_LT(found.misfit, 1e-14);
      most_steps = std::max(most_steps, found.steps);
    }
  }
  EXPECT_LE(most_steps, 8);
  RecordProperty("most_steps_from_the_centre", most_steps);
}

TEST(SpidarKinematics, QuantisedPosesAreAsGoodAsRoundingAllows) {
  for (const SpidarPreset& preset : spidar_presets()) {
    SpidarPoses random(3);
    const int poses = test::sweep_size(30000);
    double p_error = 0.0, p_bound = 0.0, p_worst = 0.0, r_error = 0.0, r_bound = 0.0, r_worst = 0.0;
    for (int k = 0; k < poses; ++k) {
      const Pose X_SG = random.pose(kWay, kTurn);
      const SpidarVector lengths = quantised(preset.geometry, spidar_strings(preset.geometry, X_SG).lengths);
      const SpidarPose found = spidar_pose(preset.geometry, lengths, {});
      ASSERT_EQ(found.fit, SpidarFit::kConverged) << preset.name << k;
      const Matrix6 covariance = spidar_quantisation(preset.geometry, X_SG);
      const double p = (found.X_SG.p - X_SG.p).norm(), r = turn_left(found.X_SG, X_SG);
      p_error += p * p;
      r_error += r * r;
      p_bound += covariance.topLeftCorner<3, 3>().trace();
      r_bound += covariance.bottomRightCorner<3, 3>().trace();
      p_worst = std::max(p_worst, p);
      r_worst = std::max(r_worst, r);
    }
    // Few poses of a sanitizer's run scatter more.
    const double tolerance = poses < 10000 ? 0.15 : 0.05;
    EXPECT_NEAR(std::sqrt(p_error / p_bound), 1.0, tolerance) << preset.name;
    EXPECT_NEAR(std::sqrt(r_error / r_bound), 1.0, tolerance) << preset.name;
    const bool is_x3 = preset.name.substr(0, 2) == "x3";
    EXPECT_LT(p_worst, is_x3 ? 17e-6 : 36e-6) << preset.name;
    EXPECT_LT(r_worst, (is_x3 ? 0.10 : 0.16) * kDegree) << preset.name;
    std::printf(
        "%s: position RMS %.2f um, unavoidable %.2f, worst %.1f; rotation RMS %.4f deg, unavoidable %.4f, "
        "worst %.3f\n",
        std::string(preset.name).c_str(), 1e6 * std::sqrt(p_error / poses), 1e6 * std::sqrt(p_bound / poses),
        1e6 * p_worst, std::sqrt(r_error / poses) / kDegree, std::sqrt(r_bound / poses) / kDegree, r_worst / kDegree);
  }
}

TEST(SpidarKinematics, FollowsTheGripThroughWholeTurns) {
  // Where the strings lose a motion on the way the lengths tell nothing: such poses may be refused, not answered wrong.
  const SpidarGeometry& geometry = spidar_preset("x3r").geometry;
  for (const Vector3& axis : {Vector3(Vector3::UnitX()), Vector3(Vector3::UnitY()), Vector3(Vector3::UnitZ()),
                              Vector3(Vector3(1.0, 2.0, -0.5).normalized())}) {
    Pose guess;
    int answered = 0;
    for (int degree = 0; degree <= 360; ++degree) {
      const Pose X_SG{0.003 * axis, rotation_from_vector(degree * kDegree * axis)};
      const SpidarPose found = spidar_pose(geometry, spidar_strings(geometry, X_SG).lengths, guess);
      guess = X_SG;
      if (found.fit != SpidarFit::kConverged) continue;
      ++answered;
      EXPECT_LT((found.X_SG.p - X_SG.p).norm(), 1e-9) << axis.transpose() << " at " << degree;
      EXPECT_LT(turn_left(found.X_SG, X_SG), 1e-7) << axis.transpose() << " at " << degree;
    }
    EXPECT_GE(answered, 355) << axis.transpose();
  }
}

TEST(SpidarKinematics, MisfitShowsACounterThatSlipped) {
  const SpidarGeometry& geometry = spidar_preset("x3r").geometry;
  SpidarVector lengths = spidar_strings(geometry, {}).lengths;
  lengths[3] += 0.02;
  const SpidarPose found = spidar_pose(geometry, lengths, {});
  EXPECT_EQ(found.fit, SpidarFit::kConverged);
  EXPECT_GT(found.misfit, 1e-3);
}

TEST(SpidarKinematics, RefusesWhatIsNoNumberAndKeepsTheGuess) {
  const SpidarGeometry& geometry = spidar_preset("x3r").geometry;
  const Pose guess{{1e-3, 2e-3, 3e-3}, rotation_from_vector({0.1, 0.0, 0.0})};
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    SpidarVector lengths = spidar_strings(geometry, guess).lengths;
    lengths[5] = bad;
    const SpidarPose found = spidar_pose(geometry, lengths, guess);
    EXPECT_EQ(found.fit, SpidarFit::kNotFinite);
    EXPECT_EQ(found.X_SG.p, guess.p);
  }
}

TEST(SpidarKinematics, SaysWhereTheStringsLoseAMotion) {
  // All knots at one place: nothing tells how the grip is turned about it.
  SpidarGeometry geometry = spidar_preset("x3r").geometry;
  for (SpidarString& string : geometry.strings) string.knot_G = {0.0, 0.0, 0.02};
  SpidarVector lengths = spidar_strings(geometry, {{1e-3, 0.0, 0.0}, Quaternion::Identity()}).lengths;
  EXPECT_EQ(spidar_pose(geometry, lengths, {}).fit, SpidarFit::kSingular);
  EXPECT_TRUE(std::isnan(spidar_quantisation(geometry, {})(0, 0)));
}

TEST(SpidarKinematics, EndsWhateverTheLengthsSay) {
  SpidarPoses random(4);
  for (int k = 0; k < test::sweep_size(2000); ++k) {
    SpidarVector lengths;
    for (int i = 0; i < kSpidarStrings; ++i) lengths[i] = random.direction().x() * 10.0;
    const SpidarPose found = spidar_pose(spidar_preset("x4r").geometry, lengths, random.pose(1.0, 3.0));
    EXPECT_LE(found.steps, 40);
    EXPECT_TRUE(found.X_SG.is_finite());
  }
}

TEST(SpidarKinematics, AllocatesNothing) {
  const SpidarGeometry& geometry = spidar_preset("x3r").geometry;
  const SpidarVector lengths = spidar_strings(geometry, {{1e-3, 0.0, 0.0}, Quaternion::Identity()}).lengths;
  const test::AllocationCounter counter;
  EXPECT_EQ(spidar_pose(geometry, lengths, {}).fit, SpidarFit::kConverged);
  EXPECT_GT(spidar_quantisation(geometry, {})(0, 0), 0.0);
  EXPECT_EQ(counter.count(), 0U);
}

}  // namespace
}  // namespace tegotae
