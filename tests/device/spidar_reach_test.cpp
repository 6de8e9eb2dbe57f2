// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/spidar_presets.hpp>
#include <tegotae/device/spidar_reach.hpp>
#include <tegotae/device/spidar_tensions.hpp>

#include <tests/device/spidar_poses.hpp>
#include <tests/sweep_size.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <stdexcept>
#include <string>

namespace tegotae {
namespace {

using test::SpidarPoses;

std::string refusal(const SpidarGeometry& geometry) {
  try {
    check_force_closure(geometry);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST(SpidarReach, IsTheLeastThatTheTensionsReachInAnyDirection) {
  SpidarPoses random(21);
  for (const char* name : {"x3r", "x4r"}) {
    const SpidarGeometry& geometry = spidar_preset(name).geometry;
    for (const Pose& X_SG : {Pose{}, Pose{{5e-3, 2e-3, -4e-3}, rotation_from_vector({0.1, -0.1, 0.05})}}) {
      const SpidarReach reach = spidar_reach(geometry, X_SG);
      const SpidarWrenchMatrix W = spidar_strings(geometry, X_SG).wrenches;
      double force = 1e9, torque = 1e9;
      const auto most = [&](const Wrench& wrench) {
        return spidar_tensions(W, knot_radius(geometry), min_tensions(geometry), max_tensions(geometry), wrench).scale;
      };
      for (int k = 0; k < test::sweep_size(20000); ++k) {
        const Vector3 direction = random.direction();
        force = std::min(force, 500.0 * most({500.0 * direction, Vector3::Zero()}));
        torque = std::min(torque, 50.0 * most({Vector3::Zero(), 50.0 * direction}));
      }
      EXPECT_GE(force, reach.force * (1.0 - 1e-9)) << name;
      EXPECT_GE(torque, reach.torque * (1.0 - 1e-9)) << name;
      const double near = test::kSweepDivisor > 1 ? 1.1 : 1.01;
      EXPECT_LT(force, near * reach.force) << name;
      EXPECT_LT(torque, near * reach.torque) << name;
    }
  }
}

TEST(SpidarReach, PresetsThatCloseAreTakenAtTheirCentre) {
  for (const char* name : {"x3r", "x3l", "x4r", "x4l"}) {
    EXPECT_EQ(refusal(spidar_preset(name).geometry), "") << name;
    EXPECT_GT(spidar_reach(spidar_preset(name).geometry, {}).force, 10.0) << name;
    EXPECT_GT(spidar_reach(spidar_preset(name).geometry, {}).torque, 0.3) << name;
  }
}

TEST(SpidarReach, APairingThatTurnsOneWayOnlyIsRefusedWithItsDirection) {
  // The knots in a ring, each drawn on in the same sense: as published for the X3F, and put into the X4's frame.
  SpidarGeometry ring_in_x4 = spidar_preset("x3f").geometry;
  ring_in_x4.name = "ring";
  for (SpidarString& string : ring_in_x4.strings) {
    string.motor_S = string.motor_S.cwiseProduct(Vector3(0.138 / 0.120, 0.138 / 0.120, 0.190 / 0.146));
    string.knot_G *= 0.0225 / 0.016;
  }
  for (const SpidarGeometry& geometry : {spidar_preset("x3f").geometry, ring_in_x4}) {
    // All strings turn the grip about the vertical in one sense.
    const SpidarWrenchMatrix W = spidar_strings(geometry, {}).wrenches;
    EXPECT_TRUE((W.row(5).array() > 0.0).all() || (W.row(5).array() < 0.0).all());
    const std::string sentence = refusal(geometry);
    EXPECT_NE(sentence.find("'" + geometry.name + "'"), std::string::npos) << sentence;
    EXPECT_NE(sentence.find("push along"), std::string::npos) << sentence;
    EXPECT_NE(sentence.find("which motor holds which knot"), std::string::npos) << sentence;
    const SpidarReach reach = spidar_reach(geometry, {});
    EXPECT_EQ(reach.force, 0.0);
    EXPECT_EQ(reach.torque, 0.0);
    // What it names is such a direction: nothing pushes along it.
    SpidarWrenchMatrix at_knots = W;
    at_knots.bottomRows<3>() /= knot_radius(geometry);
    EXPECT_LT((at_knots.transpose() * reach.weakest).maxCoeff(), 1e-9);
  }
}

TEST(SpidarReach, StringsWithoutArmAreRefused) {
  SpidarGeometry geometry = spidar_preset("x3r").geometry;
  for (SpidarString& string : geometry.strings) string.knot_G = {0.0, 0.0, 0.02};
  EXPECT_NE(refusal(geometry).find("all six components"), std::string::npos) << refusal(geometry);
}

TEST(SpidarReach, TensionsThatCannotBalanceAreRefused) {
  SpidarGeometry geometry = spidar_preset("x3r").geometry;
  geometry.strings[0].min_tension = 15.0;
  for (std::size_t i = 1; i < 8; ++i) geometry.strings[i].max_tension = 0.31;
  EXPECT_NE(refusal(geometry).find("push along"), std::string::npos);
}

TEST(SpidarReach, NumbersThatCannotBeAreRefusedByString) {
  const auto with = [](const auto& spoil) {
    SpidarGeometry geometry = spidar_preset("x3r").geometry;
    spoil(geometry.strings[4]);
    return refusal(geometry);
  };
  EXPECT_NE(with([](SpidarString& s) { s.motor_S.x() = 1.0 / 0.0; }).find("string 4"), std::string::npos);
  EXPECT_NE(with([](SpidarString& s) { s.motor_S = s.knot_G; }).find("shorter than 1 mm"), std::string::npos);
  EXPECT_NE(with([](SpidarString& s) { s.metres_per_pulse = 0.0; }).find("metres a pulse"), std::string::npos);
  EXPECT_NE(with([](SpidarString& s) { s.volts_per_newton = 0.0; }).find("volts"), std::string::npos);
  EXPECT_NE(with([](SpidarString& s) { s.min_tension = 0.0; }).find("0 < least"), std::string::npos);
  EXPECT_NE(with([](SpidarString& s) { s.max_tension = s.min_tension; }).find("0 < least"), std::string::npos);
  SpidarGeometry geometry = spidar_preset("x3r").geometry;
  geometry.axial_stiffness = -1.0;
  EXPECT_NE(refusal(geometry).find("axial stiffness"), std::string::npos);
}

}  // namespace
}  // namespace tegotae
