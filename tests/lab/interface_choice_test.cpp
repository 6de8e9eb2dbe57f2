// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/simulated_presets.hpp>
#include <tegotae/lab/input_error.hpp>
#include <tegotae/lab/interface_choice.hpp>
#include <tests/lab/temporary_folder.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>

namespace tegotae {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::ThrowsMessage;

SimulatedChoice found(const std::string& name) { return find_simulated(parse_interface_name(name)); }

TEST(InterfaceChoice, ASimulatedInterfaceIsToldFromADriver) {
  for (const char* name : {"simulated:page", "simulated", "spidar-g6:x3r,simulated", "spidar-g6:a,b,simulated"}) {
    EXPECT_TRUE(is_simulated(parse_interface_name(name))) << name;
  }
  for (const char* name : {"spidar-g6:x3r", "spidar-g6", "spidar-g6:simulated", "force-dimension", "page", ""}) {
    EXPECT_FALSE(is_simulated(parse_interface_name(name))) << name;
  }
}

TEST(InterfaceChoice, EverySimulatedDeviceHasItsName) {
  for (const auto& preset : simulated_devices()) {
    const SimulatedChoice choice = found("simulated:" + std::string(preset.name));
    EXPECT_EQ(std::get<SimulatedDevice>(choice.model).capability.name, preset.name);
    EXPECT_THAT(simulated_interface_names(), HasSubstr(choice.name));
  }
}

TEST(InterfaceChoice, ASpidarIsAPresetOrAFile) {
  EXPECT_EQ(std::get<SpidarGeometry>(found("spidar-g6:x4l,simulated").model).name, "x4l");
  const TemporaryFolder folder;
  const std::string file =
      folder.write("ours, and old.txt",
                   "name ours\nmetres_per_pulse 2e-5\nvolts_per_newton 0.1\ntension 0.4 15\n"
                   "string -0.06  0.06 -0.076  -0.0225 0 0\nstring  0.06  0.06 -0.076   0.0225 0 0\n"
                   "string  0.06 -0.06 -0.076   0 0 -0.0225\nstring -0.06 -0.06 -0.076   0 0 -0.0225\n"
                   "string -0.06  0.06  0.076  -0.0225 0 0\nstring  0.06  0.06  0.076   0.0225 0 0\n"
                   "string  0.06 -0.06  0.076   0 0 0.0225\nstring -0.06 -0.06  0.076   0 0 0.0225\n");
  const SimulatedChoice choice = found("spidar-g6:" + file + ",simulated");
  EXPECT_EQ(std::get<SpidarGeometry>(choice.model).name, "ours");
  const auto interface =
      make_simulated(choice, simulated_hand("firm"), std::make_unique<IntendedTrajectory>(Trajectory({{0.0, Pose{}}})));
  EXPECT_EQ(interface->capability().name, "spidar-g6:ours");
  EXPECT_EQ(file_name_of(choice), "spidar-g6-ours--and-old.txt-simulated");
}

TEST(InterfaceChoice, ItsNameInAFileName) {
  EXPECT_EQ(file_name_of(found("simulated:parallel")), "simulated-parallel");
  EXPECT_EQ(file_name_of(found("spidar-g6:x3r,simulated")), "spidar-g6-x3r-simulated");
  EXPECT_EQ(file_name_of({"spidar-g6:../a b/..,simulated", SimulatedDevice{}}), "spidar-g6-..-simulated");
}

TEST(InterfaceChoice, WhatIsNotThereIsAnsweredWithASentence) {
  const auto refusal = [](const char* name) { return [name] { found(name); }; };
  EXPECT_THAT(refusal("simulated:falcon"),
              ThrowsMessage<InputError>(AllOf(HasSubstr("'simulated:falcon'"), HasSubstr("simulated:parallel"),
                                              HasSubstr("spidar-g6:PRESET,simulated"), HasSubstr("x4r"))));
  EXPECT_THAT(refusal("falcon"), ThrowsMessage<InputError>(HasSubstr("no simulated interface 'falcon'")));
  EXPECT_THAT(refusal("spidar-g6:x3r"), ThrowsMessage<InputError>(AllOf(HasSubstr("'spidar-g6:x3r' is not simulated"),
                                                                        HasSubstr("give spidar-g6:x3r,simulated."))));
  EXPECT_THAT(refusal("spidar-g6:x9,simulated"),
              ThrowsMessage<InputError>(AllOf(HasSubstr("'x9' is neither"), HasSubstr("x3r"), Not(HasSubstr("x3f")))));
  EXPECT_THAT(refusal("spidar-g6:x3f,simulated"), ThrowsMessage<InputError>(HasSubstr("x3f")));
  const TemporaryFolder folder;
  const std::string name = "spidar-g6:" + folder.write("bad.txt", "name bad\nstring 1 2\n") + ",simulated";
  EXPECT_THAT(refusal(name.c_str()), ThrowsMessage<InputError>(HasSubstr("bad.txt")));
}

// b/(T/2 + t_d), b of grip and hand, is where such a loop begins to ring by itself (stability_test.cpp).
TEST(InterfaceChoice, IsRatedBelowTheBoundOfItsHand) {
  const HandImpedance& hand = simulated_hand("moderate");
  const InterfaceCapability spidar = capability_in_hand(found("spidar-g6:x3r,simulated"), hand, 1e-3);
  EXPECT_NEAR(spidar.max_stiffness, 0.9 * (0.5 + hand.damping) / 0.5e-3, 1e-6);
  EXPECT_NEAR(spidar.max_rotational_stiffness, 0.9 * (1e-3 + hand.rotational_damping) / 0.5e-3, 1e-9);
  EXPECT_GT(spidar.max_force, 20.0);
  const InterfaceCapability parallel = capability_in_hand(found("simulated:parallel"), hand, 1e-3);
  EXPECT_NEAR(parallel.max_stiffness, 0.9 * (1.0 + hand.damping) / 1.5e-3, 1e-6) << "its delay counts";
  EXPECT_EQ(capability_in_hand(found("simulated:page"), hand, 1e-3).max_stiffness, 4000.0) << "its own rating is less";
}

}  // namespace
}  // namespace tegotae
