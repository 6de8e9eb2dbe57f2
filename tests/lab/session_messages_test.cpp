// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/experiment.hpp>
#include <tegotae/lab/numeric_setting.hpp>
#include <tegotae/lab/session_messages.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

namespace tegotae {
namespace {

ShownSetting setting(const SessionSettings& settings, const std::string& name) {
  for (const ShownSetting& shown : shown_settings(settings)) {
    if (shown.name == name) return shown;
  }
  ADD_FAILURE() << "no setting " << name;
  return {};
}

TEST(SessionMessages, ShowEverySettingInItsRange) {
  const std::vector<ShownSetting> shown = shown_settings(SessionSettings{});
  ASSERT_EQ(shown.size(), numeric_settings().size());
  for (const ShownSetting& one : shown) {
    if (!one.value) continue;
    EXPECT_TRUE((*one.value >= one.least && *one.value <= one.most) || (one.zero_too && *one.value == 0.0)) << one.name;
  }
}

TEST(SessionMessages, ShowTheValuesThatWereDecided) {
  SessionSettings settings;
  settings.stiffness = 2000.0;
  settings.damping = 3.0;
  settings.metric_length = 0.1;
  settings.tool_weight = true;
  EXPECT_EQ(setting(settings, "stiffness").value, 2000.0);
  EXPECT_EQ(setting(settings, "stiffness").unit, "N/m");
  EXPECT_EQ(setting(settings, "metric_length").label, "Metric length");
  EXPECT_DOUBLE_EQ(setting(settings, "rotational_stiffness").value.value(), 20.0);
  EXPECT_DOUBLE_EQ(setting(settings, "rotational_damping").value.value(), 0.03);
  EXPECT_EQ(setting(settings, "tool_weight").value, 1.0);
  EXPECT_TRUE(setting(settings, "tool_weight").is_switch);
  EXPECT_EQ(setting(settings, "friction").value, std::nullopt);
  settings.friction = 0.5;
  settings.rotational_damping = 0.25;
  EXPECT_EQ(setting(settings, "friction").value, 0.5);
  EXPECT_EQ(setting(settings, "rotational_damping").value, 0.25);
}

TEST(SessionMessages, WhatAMethodDoesNotHaveIsNotAvailable) {
  SessionSettings settings;
  EXPECT_TRUE(setting(settings, "friction").available);
  settings.method = "paper";
  EXPECT_FALSE(setting(settings, "friction").available);
  EXPECT_TRUE(setting(settings, "stiffness").available);
}

TEST(SessionMessages, NameWhatAPageMayChoose) {
  SessionSettings settings;
  settings.gravity = {0.0, -9.81, 0.0};
  const SceneNames names = session_names("table.xml", settings);
  EXPECT_EQ(names.name, "table.xml");
  EXPECT_EQ(names.program.rfind("tegotae ", 0), 0U);
  EXPECT_EQ(names.up, Vector3::UnitY());
  ASSERT_EQ(names.experiments.size(), experiments().size());
  EXPECT_EQ(names.experiments[0].name, experiments()[0].name);
  const auto is_proxy = [](const NamedChoice& choice) { return choice.name == "proxy" && !choice.summary.empty(); };
  EXPECT_TRUE(std::any_of(names.methods.begin(), names.methods.end(), is_proxy));
}

}  // namespace
}  // namespace tegotae
