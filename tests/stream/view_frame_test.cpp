// SPDX-License-Identifier: Apache-2.0
#include <tegotae/runtime/safety.hpp>
#include <tegotae/stream/view_frame.hpp>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace tegotae {
namespace {

using Json = nlohmann::json;

ViewFrame full_frame() {
  ViewFrame frame;
  frame.n = 7;
  frame.time = 3600.0010004;
  frame.made_ms = 1700000000123.456;
  frame.X_WT.p = Vector3(0.1, 0.2, 0.3);
  frame.X_WP.p = Vector3(0.1, 0.2, 0.35);
  frame.target = Pose{{-1.0, 0.0, 0.0}, Quaternion(0.0, 1.0, 0.0, 0.0)};
  frame.displayed = Wrench{{1.0, 2.0, 3.0}, {4.0, 5.0, 6.0}};
  frame.bodies.resize(2);
  frame.contacts.add(ViewedPlane{Vector3(1, 2, 3), Vector3(0, 0, 1), -0.25, 0, 1, 2});
  frame.contacts.add(ViewedPoint{Vector3(4, 5, 6), 1e-6, 2.5});
  frame.contacts.add(ViewedPoint{Vector3(7, 8, 9), 0.5, 0.0});
  frame.contacts.add(ViewedAnchor{Vector3(1, 1, 1), Vector3(0, 1e-5, 0), 3.0, 1});
  frame.samples.push_back({3599.999, Wrench{{0.5, 0.0, 0.0}, {0.0, 0.0, -1.5}}});
  frame.samples.push_back({3600.0, Wrench{}});
  frame.numbers.tick_median_us = 12.5;
  frame.numbers.ticks = 3600001;
  frame.numbers.status = RenderStatus::kInfeasible;
  frame.numbers.safety_events = 1U << 1U | 1U << 4U;
  frame.histogram = ViewedHistogram{{0.0, 10.0, 20.0}, {3, 4}};
  frame.paused = true;
  frame.recording = ViewedRecording{"out/\"a\".mcap", 12};
  frame.motion = "press";
  frame.hand = 3;
  frame.viewers = 2;
  return frame;
}

TEST(ViewFrame, SaysWhatTheProtocolHasOfAState) {
  const Json state = Json::parse(encode(full_frame()));
  EXPECT_EQ(state["type"], "state");
  EXPECT_EQ(state["n"], 7);
  EXPECT_EQ(state["t"], 3600.001);
  EXPECT_EQ(state["made"], 1700000000123.5);
  EXPECT_EQ(state["tool"], Json::parse("[0.1,0.2,0.3,1,0,0,0]"));
  EXPECT_EQ(state["proxy"], Json::parse("[0.1,0.2,0.35,1,0,0,0]"));
  EXPECT_EQ(state["target"], Json::parse("[-1,0,0,0,1,0,0]"));
  EXPECT_EQ(state["wrench"], Json::parse("[1,2,3,4,5,6]"));
  EXPECT_EQ(state["bodies"], Json::parse("[[0,0,0,1,0,0,0],[0,0,0,1,0,0,0]]"));
  EXPECT_EQ(state["planes"], Json::parse("[[1,2,3,0,0,1,-0.25]]"));
  EXPECT_EQ(state["points"], Json::parse("[[4,5,6,1e-06,2.5],[7,8,9,0.5,0]]"));
  EXPECT_EQ(state["anchors"], Json::parse("[[1,1,1,0,1e-05,0,1]]"));
  EXPECT_EQ(state["samples"], Json::parse("[[3599.999,0.5,0,0,0,0,-1.5],[3600,0,0,0,0,0,0]]"));
  EXPECT_EQ(state["histogram"], Json::parse(R"({"edges_us": [0, 10, 20], "counts": [3, 4]})"));
  EXPECT_EQ(state["paused"], true);
  EXPECT_EQ(state["recording"], true);
  EXPECT_EQ(state["recording_file"], "out/\"a\".mcap");
  EXPECT_EQ(state["recording_ticks"], 12);
  EXPECT_EQ(state["motion"], "press");
  EXPECT_EQ(state["hand"], 3);
  EXPECT_EQ(state["viewers"], 2);
}

TEST(ViewFrame, SaysEveryNumberOfTheProtocol) {
  const Json numbers = Json::parse(encode(full_frame()))["numbers"];
  for (const char* name : {"tick_median_us", "tick_p99_us", "tick_p999_us", "tick_max_us", "ticks", "haptic_rate",
                           "physics_rate", "physics_step_ms", "staleness_ms", "missed", "near_objects", "contacts",
                           "active", "constraints", "dropped", "iterations", "depth", "energy"}) {
    EXPECT_TRUE(numbers[name].is_number()) << name;
  }
  EXPECT_EQ(numbers["tick_median_us"], 12.5);
  EXPECT_EQ(numbers["ticks"], 3600001);
  EXPECT_EQ(numbers["status"], "infeasible");
  EXPECT_EQ(numbers["safety"], Json::parse(R"(["ramping", "torque_saturated"])"));
  EXPECT_EQ(numbers.size(), 20U);
}

TEST(ViewFrame, WhatIsNotThereIsNullOrAbsent) {
  const Json state = Json::parse(encode(ViewFrame{}));
  for (const char* name : {"target", "motion", "hand"}) EXPECT_TRUE(state.at(name).is_null()) << name;
  for (const char* name : {"histogram", "recording_file", "recording_ticks"})
    EXPECT_FALSE(state.contains(name)) << name;
  for (const char* name : {"bodies", "planes", "points", "anchors", "samples"}) {
    EXPECT_EQ(state.at(name), Json::array()) << name;
  }
  EXPECT_EQ(state["recording"], false);
}

TEST(ViewFrame, NumbersThatAreNotFiniteAreNull) {
  ViewFrame frame = full_frame();
  frame.X_WT.p = Vector3(std::nan(""), 0.0, std::numeric_limits<double>::infinity());
  frame.time = frame.made_ms = std::nan("");
  frame.samples[0].time = std::nan("");
  frame.numbers.energy = std::nan("");
  frame.histogram->edges_us[2] = std::numeric_limits<double>::infinity();
  const Json state = Json::parse(encode(frame));
  EXPECT_EQ(state["tool"], Json::parse("[null,0,null,1,0,0,0]"));
  EXPECT_TRUE(state["t"].is_null());
  EXPECT_TRUE(state["made"].is_null());
  EXPECT_TRUE(state["samples"][0][0].is_null());
  EXPECT_TRUE(state["numbers"]["energy"].is_null());
  EXPECT_TRUE(state["histogram"]["edges_us"][2].is_null());
}

TEST(ViewFrame, EverySafetyEventHasANameOfItsOwn) {
  ViewFrame frame;
  frame.numbers.safety_events = (1U << kSafetyEvents) - 1U;
  const Json names = Json::parse(encode(frame))["numbers"]["safety"];
  ASSERT_EQ(names.size(), kSafetyEvents);
  for (std::size_t i = 0; i < names.size(); ++i) {
    EXPECT_NE(names[i], "unknown");
    for (std::size_t j = 0; j < i; ++j) EXPECT_NE(names[i], names[j]);
  }
}

}  // namespace
}  // namespace tegotae
