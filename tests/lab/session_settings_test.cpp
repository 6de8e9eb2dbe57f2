// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/input_error.hpp>
#include <tegotae/lab/numeric_setting.hpp>
#include <tegotae/lab/session_settings.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>
#include <string_view>

namespace tegotae {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

Tool cube() {
  Tool tool;
  tool.pieces = {make_box({0.1, 0.1, 0.1})};
  tool.mass = mass_properties(tool.pieces[0], 1000.0);
  return tool;
}

TEST(SessionSettings, AreTheDefaultsWhereNothingIsAsked) {
  const SessionSettings settings = decide_settings({}, cube());
  EXPECT_EQ(settings.method, "proxy");
  EXPECT_EQ(settings.metric_length, cube().mass.gyration_length());
  EXPECT_FALSE(settings.friction.has_value());
  EXPECT_EQ(settings.physics_rate, 500.0);
  EXPECT_EQ(settings.haptic_rate, 1000.0);
  EXPECT_EQ(settings.constraint_set, ConstraintSet::kPenetratingPoints);
}

TEST(SessionSettings, FirstRequestWinsAndTheNextFillsTheGaps) {
  SettingsRequest line, scene;
  line.stiffness = 2000.0;
  scene.stiffness = 9000.0;
  scene.damping = 3.0;
  scene.margin = 0.01;
  line.constraint_set = ConstraintSet::kNearPoints;
  const SessionSettings settings = decide_settings(line.or_else(scene), cube());
  EXPECT_EQ(settings.stiffness, 2000.0);
  EXPECT_EQ(settings.damping, 3.0);
  EXPECT_EQ(settings.margin, 0.01);
  EXPECT_EQ(settings.constraint_set, ConstraintSet::kNearPoints);
}

TEST(SessionSettings, ZeroMetricLengthIsTheGyrationLength) {
  SettingsRequest request;
  request.metric_length = 0.0;
  EXPECT_NEAR(decide_settings(request, cube()).metric_length, 0.2 / std::sqrt(6.0), 1e-15);
}

TEST(SessionSettings, LowHapticRateTakesTheDefaultPhysicsRateWithIt) {
  SettingsRequest request;
  request.haptic_rate = 50.0;
  EXPECT_EQ(decide_settings(request, cube()).physics_rate, 50.0);
}

TEST(SessionSettings, RefusesValuesOutOfRangeAndNamesTheRange) {
  const auto error_with = [](auto member, double value, const char* what) {
    SettingsRequest request;
    request.*member = value;
    EXPECT_THAT([&] { decide_settings(request, cube()); },
                ThrowsMessage<InputError>(testing::AllOf(HasSubstr(what), HasSubstr("permitted are"))));
  };
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  for (const double bad : {-1.0, 0.0, 1e7, nan, infinity}) error_with(&SettingsRequest::stiffness, bad, "stiffness");
  for (const double bad : {-0.1, 1e5, nan}) error_with(&SettingsRequest::damping, bad, "damping");
  for (const double bad : {-1.0, 1e-9, 1e4, nan}) error_with(&SettingsRequest::metric_length, bad, "metric length");
  for (const double bad : {0.0, -20.0, 5000.0, nan}) error_with(&SettingsRequest::physics_rate, bad, "physics rate");
  for (const double bad : {0.0, 1.0, 1e6, nan}) error_with(&SettingsRequest::haptic_rate, bad, "haptic rate");
  for (const double bad : {0.0, -0.001, 100.0, nan}) error_with(&SettingsRequest::margin, bad, "margin");
}

TEST(SessionSettings, RefusesPhysicsFasterThanHaptics) {
  SettingsRequest request;
  request.physics_rate = 500.0;
  request.haptic_rate = 100.0;
  EXPECT_THAT([&] { decide_settings(request, cube()); }, ThrowsMessage<InputError>(HasSubstr("500 Hz")));
}

TEST(SessionSettings, RefusesAnUnknownMethodAndNamesThoseThereAre) {
  SettingsRequest request;
  request.method = "magic";
  EXPECT_THAT([&] { check_ranges(request); },
              ThrowsMessage<InputError>(testing::AllOf(HasSubstr("'magic'"), HasSubstr("paper"))));
}

TEST(SessionSettings, RefusesAConstraintSetToMethodsThatHaveNone) {
  SettingsRequest request;
  request.constraint_set = ConstraintSet::kNearPoints;
  request.method = "paper";
  EXPECT_NO_THROW(check_fits_method(request));
  request.method = "adachi";
  EXPECT_THAT([&] { check_fits_method(request); }, ThrowsMessage<InputError>(HasSubstr("'adachi' has no choice")));
  request.constraint_set.reset();
  EXPECT_THAT(decide_settings(request, cube()).lines(), testing::Not(testing::Contains(HasSubstr("constraint set"))));
}

TEST(SessionSettings, LinesNameEverySettingWithItsUnit) {
  SettingsRequest request;
  request.stiffness = 4321.5;
  const std::vector<std::string> lines = decide_settings(request, cube()).lines();
  EXPECT_THAT(lines, testing::Contains("stiffness: 4321.5 N/m"));
  EXPECT_THAT(lines, testing::Contains("friction: the scene's"));
  request.method = "paper";
  const std::vector<std::string> of_paper = decide_settings(request, cube()).lines();
  EXPECT_THAT(of_paper, testing::Contains("metric length: 1 m"));
  EXPECT_THAT(of_paper, testing::Contains("constraint set: penetrating"));
  EXPECT_THAT(of_paper, testing::Not(testing::Contains(HasSubstr("friction"))));
}

TEST(SessionSettings, RefusesFrictionToMethodsThatHaveNone) {
  SettingsRequest request;
  request.friction = 0.5;
  EXPECT_NO_THROW(check_fits_method(request));
  request.method = "ortega";
  EXPECT_THAT([&] { check_fits_method(request); }, ThrowsMessage<InputError>(HasSubstr("'ortega' has no friction")));
}

TEST(SessionSettings, RotationalStiffnessIsAnotherNameOfTheMetricLength) {
  SettingsRequest line, scene;
  line.stiffness = 1000.0;
  line.rotational_stiffness = 2.5;
  scene.metric_length = 0.3;
  EXPECT_NEAR(decide_settings(line.or_else(scene), cube()).metric_length, 0.05, 1e-15);
  EXPECT_EQ(decide_settings(scene.or_else(line), cube()).metric_length, 0.3);
  line.metric_length = 0.1;
  EXPECT_THAT([&] { check_fits_method(line); }, ThrowsMessage<InputError>(HasSubstr("not both")));
}

TEST(SessionSettings, EveryNumberReachesTheMethod) {
  SettingsRequest request;
  for (const NumericSetting& setting : numeric_settings()) request.*setting.field = setting.least;
  request.metric_length.reset();
  request.physics_rate = 10.0;
  request.dead_man_button = 1.0;
  request.tool_weight = request.tool_inertia = 1.0;
  const SessionSettings settings = decide_settings(request, cube());
  EXPECT_EQ(settings.friction, 0.0);
  EXPECT_EQ(settings.kinetic_friction, 0.0);
  EXPECT_EQ(settings.viscous_friction, 0.0);
  EXPECT_EQ(settings.rotational_damping, 0.0);
  EXPECT_EQ(settings.contact_margin, 1e-5);
  EXPECT_TRUE(settings.tool_weight);
  EXPECT_TRUE(settings.tool_inertia);
}

TEST(SessionSettings, WhoHoldsTheInterfaceDecidesScalesButtonsAndTheBound) {
  const SessionSettings defaults = decide_settings({}, cube());
  EXPECT_EQ(defaults.workspace.translation_scale, 1.0);
  EXPECT_EQ(defaults.workspace.clutch_button, -1);
  EXPECT_EQ(defaults.dead_man_button, -1);
  EXPECT_TRUE(defaults.energy_bound);
  EXPECT_FALSE(defaults.beyond_rating);
  SettingsRequest request;
  request.translation_scale = 3.0;
  request.rotation_scale = 2.0;
  request.force_scale = 0.5;
  request.clutch_button = 1.0;
  request.dead_man_button = 0.0;
  request.energy_bound = 0.0;
  request.beyond_rating = 1.0;
  const SessionSettings settings = decide_settings(request, cube());
  EXPECT_EQ(settings.workspace.power_scale(), 0.5 / 3.0);
  EXPECT_EQ(settings.workspace.clutch_button, 1);
  EXPECT_EQ(settings.dead_man_button, 0);
  EXPECT_FALSE(settings.energy_bound);
  EXPECT_TRUE(settings.beyond_rating);
  EXPECT_THAT(settings.lines(), ::testing::IsSupersetOf({"translation scale: 3", "rotation scale: 2",
                                                         "force scale: 0.5", "clutch button: 1", "dead-man button: 0",
                                                         "energy bound: off", "interface's ratings: not applied"}));
  request.clutch_button = 0.5;
  EXPECT_THAT([&] { check_ranges(request); }, ThrowsMessage<InputError>(HasSubstr("a whole number")));
}

TEST(NumericSettings, AreNamedOnceAndRefuseWhatIsOutOfRange) {
  std::set<std::string_view> names;
  for (const NumericSetting& setting : numeric_settings()) {
    EXPECT_TRUE(names.insert(setting.name).second) << setting.name;
    EXPECT_FALSE(setting.summary.empty()) << setting.name;
    EXPECT_NO_THROW(check_range(setting, setting.least));
    EXPECT_NO_THROW(check_range(setting, setting.most));
    const char* const sentence = setting.is_switch ? "is 1 (on) or 0 (off), not" : "permitted are";
    for (const double bad : {-1.0, 2.0 * setting.most, std::nan("")}) {
      EXPECT_THAT([&] { check_range(setting, bad); }, ThrowsMessage<InputError>(HasSubstr(sentence))) << setting.name;
    }
    if (setting.is_switch) {
      EXPECT_THROW(check_range(setting, 0.5), InputError) << setting.name;
    }
  }
}

TEST(SessionSettings, AButtonThatBothClutchesAndPermitsIsRefused) {
  SettingsRequest request;
  request.clutch_button = request.dead_man_button = 2.0;
  EXPECT_THROW(decide_settings(request, cube()), InputError);
}

}  // namespace
}  // namespace tegotae
