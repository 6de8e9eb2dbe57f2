// SPDX-License-Identifier: Apache-2.0
#include <tegotae/world/engine_guard.hpp>
#include <tegotae/world/limits.hpp>

#include <gtest/gtest.h>
#include <mujoco/mujoco.h>

#include <thread>

namespace tegotae {
namespace {

TEST(EngineGuard, CollectsWarningsAndGoesOn) {
  EngineMessages messages;
  bool reached_end = false;
  EXPECT_TRUE(run_guarded(messages, [&] {
    mju_warning("first");
    mju_warning("second");
    reached_end = true;
  }));
  EXPECT_TRUE(reached_end);
  EXPECT_EQ(messages.warnings, (std::vector<std::string>{"first", "second"}));
  EXPECT_TRUE(messages.error.empty());
}

TEST(EngineGuard, KeepsNoMoreWarningsThanItHasRoomFor) {
  EngineMessages messages;
  run_guarded(messages, [] {
    for (int i = 0; i < 1000; ++i) mju_warning("again");
  });
  EXPECT_EQ(messages.warnings.size(), static_cast<size_t>(world_limits::kMaxKeptWarnings));
}

TEST(EngineGuard, EndsTheCallAtAnError) {
  EngineMessages messages;
  bool went_on = false;
  EXPECT_FALSE(run_guarded(messages, [&] {
    mju_error("broken");
    went_on = true;
  }));
  EXPECT_FALSE(went_on);
  EXPECT_EQ(messages.error, "broken");
}

TEST(EngineGuard, Nests) {
  EngineMessages outer, inner;
  EXPECT_TRUE(run_guarded(outer, [&] {
    EXPECT_FALSE(run_guarded(inner, [] { mju_error("inside"); }));
    mju_warning("outside");
  }));
  EXPECT_EQ(inner.error, "inside");
  EXPECT_EQ(outer.warnings, (std::vector<std::string>{"outside"}));
  EXPECT_TRUE(outer.error.empty());
}

TEST(EngineGuard, EachThreadHasItsOwn) {
  EngineMessages here, there;
  run_guarded(here, [&] {
    std::thread other([&] { run_guarded(there, [] { mju_warning("there"); }); });
    other.join();
    mju_warning("here");
  });
  EXPECT_EQ(here.warnings, (std::vector<std::string>{"here"}));
  EXPECT_EQ(there.warnings, (std::vector<std::string>{"there"}));
}

}  // namespace
}  // namespace tegotae
