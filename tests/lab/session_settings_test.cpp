// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/input_error.hpp>
#include <tegotae/lab/session_settings.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

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
  EXPECT_EQ(settings.method, "paper");
  EXPECT_EQ(settings.metric_length, 1.0);
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
  EXPECT_NO_THROW(check_ranges(request));
  request.method = "adachi";
  EXPECT_THAT([&] { check_ranges(request); }, ThrowsMessage<InputError>(HasSubstr("'adachi' has no choice")));
  request.constraint_set.reset();
  EXPECT_THAT(decide_settings(request, cube()).lines(), testing::Not(testing::Contains(HasSubstr("constraint set"))));
}

TEST(SessionSettings, LinesNameEverySettingWithItsUnit) {
  SettingsRequest request;
  request.stiffness = 4321.5;
  const std::vector<std::string> lines = decide_settings(request, cube()).lines();
  EXPECT_THAT(lines, testing::Contains("stiffness: 4321.5 N/m"));
  EXPECT_THAT(lines, testing::Contains("metric length: 1 m"));
  EXPECT_THAT(lines, testing::Contains("constraint set: penetrating"));
}

}  // namespace
}  // namespace tegotae
