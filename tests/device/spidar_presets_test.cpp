// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/spidar_presets.hpp>
#include <tegotae/device/spidar_reach.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>

namespace tegotae {
namespace {

TEST(SpidarPresets, HaveTheirFramesAndKnots) {
  const auto box = [](const SpidarGeometry& geometry) {
    Vector3 size = Vector3::Zero();
    for (const SpidarString& string : geometry.strings) size = size.cwiseMax(string.motor_S.cwiseAbs());
    return Vector3(2.0 * size);
  };
  // Turned by 45 degrees the X3's motors stand before, behind, and to the sides: a square's diagonal wide.
  const double diagonal = 0.120 * std::sqrt(2.0);
  for (const char* name : {"x3r", "x3l"}) {
    EXPECT_LT((box(spidar_preset(name).geometry) - Vector3(diagonal, diagonal, 0.152)).norm(), 1e-12) << name;
  }
  EXPECT_LT((box(spidar_preset("x3f").geometry) - Vector3(0.120, 0.120, 0.146)).norm(), 1e-12);
  EXPECT_LT((box(spidar_preset("x4r").geometry) - Vector3(0.138, 0.138, 0.190)).norm(), 1e-12);
  for (const SpidarPreset& preset : spidar_presets()) {
    const double radius = preset.name == "x3f" ? 0.016 : 0.0225;
    for (const SpidarString& string : preset.geometry.strings) EXPECT_NEAR(string.knot_G.norm(), radius, 1e-12);
    EXPECT_NEAR(knot_radius(preset.geometry), radius, 1e-12);
    EXPECT_EQ(preset.geometry.name, preset.name);
    EXPECT_FALSE(preset.remark.empty());
  }
}

TEST(SpidarPresets, SayWhichOfThemAreRefused) {
  for (const SpidarPreset& preset : spidar_presets()) {
    bool is_refused = false;
    try {
      check_force_closure(preset.geometry);
    } catch (const std::invalid_argument&) {
      is_refused = true;
    }
    EXPECT_EQ(preset.is_refused, is_refused) << preset.name;
    EXPECT_EQ(preset.remark.find("refused: ") == 0, is_refused) << preset.remark;
  }
}

TEST(SpidarPresets, FirstStringOfTheX3RLeadsFromTheLeftMotorToTheKnotAtTheLeft) {
  // (-, -, +) of the table turned by -45 degrees about its vertical: to the left, low; its knot to the left and near.
  const SpidarString& string = spidar_preset("x3r").geometry.strings[0];
  EXPECT_LT((string.motor_S - Vector3(-0.06 * std::sqrt(2.0), 0.0, -0.076)).norm(), 1e-12);
  EXPECT_LT((string.knot_G - 0.0225 * std::sqrt(0.5) * Vector3(-1.0, -1.0, 0.0)).norm(), 1e-12);
}

TEST(SpidarPresets, SignsOfCountsAndVoltsAreThoseOfTheTables) {
  for (std::size_t i = 0; i < 8; ++i) {
    const bool is_middle = i >= 2 && i <= 5;
    const SpidarString& x3 = spidar_preset("x3r").geometry.strings[i];
    EXPECT_DOUBLE_EQ(x3.metres_per_pulse, is_middle ? -1.66555e-5 : 1.66555e-5);
    EXPECT_NEAR(x3.volts_per_newton, 0.3653, 5e-5);
    EXPECT_EQ(x3.min_tension, 0.3);
    const SpidarString& x4 = spidar_preset("x4l").geometry.strings[i];
    EXPECT_DOUBLE_EQ(x4.metres_per_pulse, is_middle ? 3.485e-5 : -3.485e-5);
    EXPECT_DOUBLE_EQ(x4.volts_per_newton, is_middle ? -0.08 : 0.08);
    EXPECT_EQ(x4.min_tension, 0.2);
  }
}

TEST(SpidarPresets, EachCornerOfTheX4HoldsTheKnotThatItHoldsInTheX3RBeforeItsTurn) {
  const Eigen::AngleAxisd back(-std::acos(std::sqrt(0.5)), Vector3::UnitZ());
  int found = 0;
  for (const SpidarString& x4 : spidar_preset("x4r").geometry.strings) {
    for (const SpidarString& x3 : spidar_preset("x3r").geometry.strings) {
      const Vector3 corner = back * x3.motor_S, knot = back * x3.knot_G;
      if ((corner.array() * x4.motor_S.array()).minCoeff() <= 0.0) continue;
      ++found;
      EXPECT_LT((knot - x4.knot_G).norm(), 1e-12) << corner.transpose();
    }
  }
  EXPECT_EQ(found, 8);
}

TEST(SpidarPresets, AnUnknownNameIsRefusedWithTheNames) {
  try {
    spidar_preset("x5");
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_NE(std::string(error.what()).find("x3r, x3l, x3f, x4r, x4l"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace tegotae
