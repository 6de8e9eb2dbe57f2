// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/spidar_presets.hpp>
#include <tegotae/device/spidar_reach.hpp>
#include <tegotae/lab/experiment.hpp>
#include <tegotae/lab/input_error.hpp>
#include <tegotae/lab/scene_file.hpp>
#include <tegotae/lab/spidar_place.hpp>
#include <tegotae/math/rotation.hpp>
#include <tegotae/world/mujoco_world.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <stdexcept>

namespace tegotae {
namespace {

const SpidarGeometry& x3r() { return spidar_preset("x3r").geometry; }

Pose grip(const SpidarPlace& place, const Pose& X_WT) {
  return place.X_WS.inverse() * X_WT * Pose{Vector3::Zero(), place.q_GT.conjugate()};
}

TEST(SpidarPlace, TheMiddleOfTheMotionIsTheMiddleOfTheFrame) {
  const Vector3 middle(0.4, -0.1, 1.0), way(0.01, 0.002, 0.015);
  const Quaternion q_middle = rotation_from_vector({1.2, 0.4, -0.7});
  const Quaternion half_turn = rotation_from_vector({0.0, 0.2, 0.0});
  const Trajectory motion({{0.0, {middle - way, half_turn * q_middle}},
                           {1.0, {middle + way, q_middle}},
                           {2.0, {middle, half_turn.conjugate() * q_middle}}});
  const SpidarPlace place = place_spidar(x3r(), motion, Vector3::UnitZ());
  EXPECT_LT((place.X_WS.p - middle).norm(), 1e-12);
  EXPECT_LT((place.X_WS.q * Vector3::UnitZ() - Vector3::UnitZ()).norm(), 1e-12) << "it stands upright";
  EXPECT_LT(rotation_vector(grip(place, {middle, q_middle}).q).norm(), 5e-3) << "1/200 of the way";
  EXPECT_LT((grip(place, {middle + way, q_middle}).p.cwiseAbs() - way).cwiseAbs().minCoeff(), 1e-12);
}

TEST(SpidarPlace, TellsTheLeastReachAlongTheMotion) {
  const Trajectory motion(
      {{0.0, {{0.0, 0.0, -0.02}, Quaternion::Identity()}}, {1.0, {{0.0, 0.0, 0.02}, Quaternion::Identity()}}});
  const SpidarPlace place = place_spidar(x3r(), motion, Vector3::UnitZ());
  double force = 1e9, torque = 1e9;
  for (const auto& sample : motion.samples()) {
    const SpidarReach reach = spidar_reach(x3r(), grip(place, sample.X_WT));
    force = std::min(force, reach.force);
    torque = std::min(torque, reach.torque);
  }
  EXPECT_NEAR(place.force, force, 1e-9);
  EXPECT_NEAR(place.torque, torque, 1e-9);
  EXPECT_LT(place.force, spidar_reach(x3r(), {}).force);
}

TEST(SpidarPlace, StandsAlongTheWorldsUp) {
  const Trajectory motion({{0.0, Pose{}}});
  for (const Vector3& up : {Vector3(Vector3::UnitX()), Vector3(Vector3::UnitY()), Vector3(-Vector3::UnitZ())}) {
    const SpidarPlace place = place_spidar(x3r(), motion, up);
    EXPECT_LT((place.X_WS.q * Vector3::UnitZ() - up).norm(), 1e-12);
    EXPECT_NEAR(place.X_WS.q.norm(), 1.0, 1e-12);
  }
}

// Half a turn of 22.5 degrees and 36 mm: one side's strings lose it, another's do not.
TEST(SpidarPlace, ThePapersCubeFitsFromASideThatIsFound) {
  const Experiment& experiment = find_experiment("paper-cube");
  const auto world = load_mujoco_world(find_scene(experiment.scene), experiment.tool);
  const Trajectory motion = experiment.motion(world->geometry().tool);
  for (const char* name : {"x3r", "x3l", "x4r", "x4l"}) {
    const SpidarPlace place = place_spidar(spidar_preset(name).geometry, motion, Vector3::UnitY());
    EXPECT_GT(place.force, 7.0) << name;
    EXPECT_GT(place.torque, 0.1) << name;
  }
}

TEST(SpidarPlace, AMotionThatLeavesTheWorkspaceIsRefusedWithItsTime) {
  const Trajectory wide(
      {{0.0, {{-0.04, 0.0, 0.0}, Quaternion::Identity()}}, {3.0, {{0.04, 0.0, 0.0}, Quaternion::Identity()}}});
  EXPECT_THAT([&] { place_spidar(x3r(), wide, Vector3::UnitZ()); },
              testing::ThrowsMessage<InputError>(testing::AllOf(
                  testing::HasSubstr("leaves the workspace"), testing::HasSubstr("40 mm"), testing::HasSubstr(" s"))));
  const Trajectory turned({{0.0, {Vector3::Zero(), rotation_from_vector({0.0, 0.0, -1.5})}},
                           {1.0, {Vector3::Zero(), Quaternion::Identity()}},
                           {2.0, {Vector3::Zero(), rotation_from_vector({0.0, 0.0, 1.5})}}});
  EXPECT_THAT([&] { place_spidar(x3r(), turned, Vector3::UnitZ()); },
              testing::ThrowsMessage<InputError>(testing::HasSubstr("86 degrees")));
  EXPECT_THROW(place_spidar(spidar_preset("x3f").geometry, turned, Vector3::UnitZ()), std::invalid_argument);
}

}  // namespace
}  // namespace tegotae
