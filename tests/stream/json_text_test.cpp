// SPDX-License-Identifier: Apache-2.0
#include <tegotae/stream/json_text.hpp>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>

namespace tegotae {
namespace {

TEST(JsonText, PutsCommasBetweenValues) {
  JsonText json;
  json.open_object().key("a").open_array().number(1.0).number(-0.5).open_array().close_array().null().close_array();
  json.key("b").text("[,{").key("c").flag(true).key("d").open_object().close_object().close_object();
  EXPECT_EQ(json.take(), R"({"a":[1,-0.5,[],null],"b":"[,{","c":true,"d":{}})");
}

TEST(JsonText, WhatIsNotFiniteIsNull) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  JsonText json;
  json.open_array().number(kInfinity).number(std::nan("")).rounded(-kInfinity).rounded(std::nan("")).close_array();
  EXPECT_EQ(json.take(), "[null,null,null,null]");
}

TEST(JsonText, ZeroHasNoSign) {
  EXPECT_EQ(JsonText().open_array().number(-0.0).rounded(-0.0).close_array().take(), "[0,0]");
}

TEST(JsonText, RoundsToSevenDigitsAndKeepsAllOtherwise) {
  std::mt19937 random(1);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 2000; ++i) {
    const double value = normal(random) * std::pow(10.0, 4.0 * normal(random));
    const auto read = nlohmann::json::parse(JsonText().open_array().number(value).rounded(value).close_array().take());
    EXPECT_EQ(read[0].get<double>(), value);
    EXPECT_NEAR(read[1].get<double>(), value, std::max(0.51e-6 * std::abs(value), 1e-12));
  }
}

TEST(JsonText, WhatIsOnlyRoundingIsZero) {
  EXPECT_EQ(JsonText().open_array().rounded(0.9e-12).rounded(-2e-16).rounded(1e-12).close_array().take(),
            "[0,0,1e-12]");
}

TEST(JsonText, TextsAreEscapedAndAlwaysUtf8) {
  const std::string text = "a \"b\"\\\n\x01 \xc3\xa9";
  EXPECT_EQ(nlohmann::json::parse(JsonText().text(text).take()).get<std::string>(), text);
  EXPECT_EQ(nlohmann::json::parse(JsonText().text("a\xff").take()).get<std::string>(), "a\xef\xbf\xbd");
}

TEST(JsonText, PosesAndWrenchesAreArrays) {
  const Pose X{{1.0, 2.0, 3.0}, Quaternion(0.5, -0.5, 0.5, -0.5)};
  EXPECT_EQ(JsonText().pose(X).take(), "[1,2,3,0.5,-0.5,0.5,-0.5]");
  EXPECT_EQ(JsonText().wrench(Wrench{{1.0, 2.0, 3.0}, {4.0, 5.0, 6.5}}).take(), "[1,2,3,4,5,6.5]");
}

}  // namespace
}  // namespace tegotae
