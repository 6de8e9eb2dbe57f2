// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/spidar_geometry.hpp>
#include <tegotae/device/spidar_presets.hpp>

#include <gtest/gtest.h>

namespace tegotae {
namespace {

TEST(SpidarGeometry, TurnsTheTablesLeftHandedFrameIntoOurs) {
  // Right stays right, up becomes z, away becomes y; and what was left-handed is right-handed.
  EXPECT_EQ(from_left_handed({1.0, 0.0, 0.0}), Vector3(1.0, 0.0, 0.0));
  EXPECT_EQ(from_left_handed({0.0, 1.0, 0.0}), Vector3(0.0, 0.0, 1.0));
  EXPECT_EQ(from_left_handed({0.0, 0.0, 1.0}), Vector3(0.0, 1.0, 0.0));
}

TEST(SpidarGeometry, VoltsAreOfTheTensions) {
  const SpidarGeometry& geometry = spidar_preset("x4r").geometry;
  const SpidarVector volts = spidar_volts(geometry, SpidarVector::Constant(5.0));
  EXPECT_DOUBLE_EQ(volts[0], 0.4);
  EXPECT_DOUBLE_EQ(volts[2], -0.4);
}

TEST(SpidarGeometry, AStringPullsTowardsItsMotor) {
  const SpidarGeometry& geometry = spidar_preset("x3r").geometry;
  const Pose X_SG{{1e-3, -2e-3, 3e-3}, Quaternion(Eigen::AngleAxisd(0.2, Vector3::UnitY()))};
  const SpidarStrings strings = spidar_strings(geometry, X_SG);
  for (int i = 0; i < kSpidarStrings; ++i) {
    const SpidarString& string = geometry.strings[static_cast<std::size_t>(i)];
    const Vector3 knot = X_SG * string.knot_G;
    EXPECT_LT((knot + strings.lengths[i] * strings.wrenches.col(i).head<3>() - string.motor_S).norm(), 1e-15);
    const Vector3 torque = (knot - X_SG.p).cross(strings.wrenches.col(i).head<3>());
    EXPECT_LT((torque - strings.wrenches.col(i).tail<3>()).norm(), 1e-15);
  }
}

}  // namespace
}  // namespace tegotae
