// SPDX-License-Identifier: Apache-2.0
#include <tegotae/stream/viewer_command.hpp>

#include <tests/sweep_size.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace tegotae {
namespace {

using ::testing::HasSubstr;
namespace command = viewer_command;

const std::vector<std::string> kValid = {R"({"type": "hand", "pose": [0.1, -0.2, 3e-1, 1, 0, 0, 0]})",
                                         R"({"type": "release"})",
                                         R"({"type": "set", "name": "stiffness", "value": 1200.5})",
                                         R"({"type": "set", "name": "friction", "value": null})",
                                         R"({"type": "method", "name": "proxy"})",
                                         R"({"type": "pause"})",
                                         R"({"type": "resume"})",
                                         R"({"type": "step"})",
                                         R"({"type": "reset"})",
                                         R"({"type": "motion", "name": "press"})",
                                         R"({"type": "stop"})",
                                         R"({"type": "scene", "name": "table"})",
                                         R"({"type": "experiment", "name": "edge-to-face"})",
                                         R"({"type": "record", "on": true})",
                                         R"({"type": "seek", "t": 12.25})",
                                         R"({"type": "play", "speed": 0.5})"};

template <class Command>
Command parsed(const std::string& message) {
  const ParsedCommand result = parse_viewer_command(message);
  EXPECT_EQ(result.error, "") << message;
  if (!result.command || !std::holds_alternative<Command>(*result.command)) {
    ADD_FAILURE() << message;
    return Command{};
  }
  return std::get<Command>(*result.command);
}

std::string refusal(const std::string& message) {
  const ParsedCommand result = parse_viewer_command(message);
  EXPECT_FALSE(result.command.has_value()) << message;
  EXPECT_FALSE(result.error.empty()) << message;
  return result.error;
}

TEST(ViewerCommand, UnderstandsEachMessageOfTheProtocol) {
  EXPECT_EQ(parsed<command::Hand>(kValid[0]).X_WT.p, Vector3(0.1, -0.2, 0.3));
  parsed<command::Release>(kValid[1]);
  EXPECT_EQ(parsed<command::Set>(kValid[2]).name, "stiffness");
  EXPECT_EQ(parsed<command::Set>(kValid[2]).value, 1200.5);
  EXPECT_EQ(parsed<command::Set>(kValid[3]).value, std::nullopt);
  EXPECT_EQ(parsed<command::Method>(kValid[4]).name, "proxy");
  parsed<command::Pause>(kValid[5]);
  parsed<command::Resume>(kValid[6]);
  parsed<command::Step>(kValid[7]);
  parsed<command::Reset>(kValid[8]);
  EXPECT_EQ(parsed<command::Motion>(kValid[9]).name, "press");
  parsed<command::Stop>(kValid[10]);
  EXPECT_EQ(parsed<command::SceneChoice>(kValid[11]).name, "table");
  EXPECT_EQ(parsed<command::ExperimentChoice>(kValid[12]).name, "edge-to-face");
  EXPECT_TRUE(parsed<command::Record>(kValid[13]).on);
  EXPECT_EQ(parsed<command::Seek>(kValid[14]).time, 12.25);
  EXPECT_EQ(parsed<command::Play>(kValid[15]).speed, 0.5);
}

TEST(ViewerCommand, ThereAreAsManyMessagesAsCommands) {
  std::vector<bool> seen(std::variant_size_v<ViewerCommand>);
  for (const std::string& message : kValid) seen[parse_viewer_command(message).command.value().index()] = true;
  for (std::size_t i = 0; i < seen.size(); ++i) EXPECT_TRUE(seen[i]) << i;
}

TEST(ViewerCommand, MakesQuaternionsUnit) {
  const Pose X = parsed<command::Hand>(R"({"type": "hand", "pose": [0, 0, 0, 0.5, 0, 0, 0.5]})").X_WT;
  EXPECT_NEAR(X.q.norm(), 1.0, 1e-15);
  EXPECT_NEAR(X.q.w(), std::sqrt(0.5), 1e-15);
  EXPECT_THAT(refusal(R"({"type": "hand", "pose": [0, 0, 0, 0, 0, 0, 0]})"), HasSubstr("quaternion"));
  EXPECT_THAT(refusal(R"({"type": "hand", "pose": [0, 0, 0, 1e-4, 0, 0, 0]})"), HasSubstr("quaternion"));
  refusal(R"({"type": "hand", "pose": [0, 0, 0, 2000, 0, 0, 0]})");
}

TEST(ViewerCommand, RefusesNumbersOutOfRange) {
  EXPECT_THAT(refusal(R"({"type": "hand", "pose": [0, 100.1, 0, 1, 0, 0, 0]})"), HasSubstr("from -100 to 100"));
  EXPECT_THAT(refusal(R"({"type": "hand", "pose": [0, 0, 0, 1, 0, 0]})"), HasSubstr("seven numbers"));
  EXPECT_THAT(refusal(R"({"type": "hand", "pose": [0, 0, null, 1, 0, 0, 0]})"), HasSubstr("must be a number"));
  refusal(R"({"type": "hand", "pose": [0, 0, 1e999, 1, 0, 0, 0]})");
  refusal(R"({"type": "hand", "pose": [0, 0, NaN, 1, 0, 0, 0]})");
  refusal(R"({"type": "set", "name": "stiffness", "value": 1e301})");
  refusal(R"({"type": "set", "name": "stiffness", "value": "1"})");
  refusal(R"({"type": "set", "name": "stiffness", "value": true})");
  refusal(R"({"type": "play", "speed": 0})");
  refusal(R"({"type": "play", "speed": -1})");
  refusal(R"({"type": "seek", "t": 1e12})");
}

TEST(ViewerCommand, RefusesWhatIsMissingUnknownOrOfAnotherKind) {
  EXPECT_THAT(refusal(R"({"type": "set", "name": "stiffness"})"), HasSubstr("'value' is missing"));
  EXPECT_THAT(refusal(R"({"type": "pause", "now": 1})"), HasSubstr("no member 'now'"));
  EXPECT_THAT(refusal(R"({"type": "explode"})"), HasSubstr("no message of type 'explode'"));
  EXPECT_THAT(refusal(R"({"pose": []})"), HasSubstr("'type' is missing"));
  EXPECT_THAT(refusal(R"({"type": 3})"), HasSubstr("must be a name"));
  EXPECT_THAT(refusal(R"({"type": "record", "on": 1})"), HasSubstr("true or false"));
  EXPECT_THAT(refusal(R"({"type": "method", "name": ""})"), HasSubstr("must be a name"));
  EXPECT_THAT(refusal(R"({"type": "method", "name": "a\nb"})"), HasSubstr("control characters"));
  EXPECT_THAT(refusal(R"({"type": "method", "name": ")" + std::string(201, 'a') + "\"}"), HasSubstr("200 bytes"));
}

TEST(ViewerCommand, RefusesWhatIsNoObjectTooLongOrTooDeep) {
  for (const char* text : {"", "{", "[]", "null", "3", "{\"type\":\"pause\"} x", "{'type': 'pause'}", "\xff"}) {
    EXPECT_THAT(refusal(text), HasSubstr("one JSON object")) << text;
  }
  EXPECT_THAT(refusal(R"({"type": "pause"})" + std::string(65 * 1024, ' ')), HasSubstr("65536 bytes"));
  EXPECT_THAT(refusal(std::string(60000, '[')), HasSubstr("too deeply"));
  EXPECT_THAT(refusal(R"({"type": "hand", "pose": [[[[[1]]]]]})"), HasSubstr("too deeply"));
  parsed<command::Method>(R"({"type": "method", "name": "[[[[[[{{\"[[["})");
}

// What passes must be what the types promise, whatever the bytes were.
void expect_sound(const ViewerCommand& understood) {
  const auto is_name = [](const std::string& name) { return !name.empty() && name.size() <= 200; };
  if (const auto* hand = std::get_if<command::Hand>(&understood)) {
    EXPECT_TRUE(hand->X_WT.is_finite());
    EXPECT_NEAR(hand->X_WT.q.norm(), 1.0, 1e-12);
    EXPECT_LE(hand->X_WT.p.cwiseAbs().maxCoeff(), 100.0);
  }
  if (const auto* set = std::get_if<command::Set>(&understood)) {
    EXPECT_TRUE(is_name(set->name) && std::isfinite(set->value.value_or(0.0)));
  }
  if (const auto* seek = std::get_if<command::Seek>(&understood)) {
    EXPECT_TRUE(std::isfinite(seek->time));
  }
  if (const auto* play = std::get_if<command::Play>(&understood)) {
    EXPECT_TRUE(play->speed >= 0.01 && play->speed <= 100.0);
  }
  if (const auto* scene = std::get_if<command::SceneChoice>(&understood)) {
    EXPECT_TRUE(is_name(scene->name));
  }
}

class Mutator {
 public:
  std::string mutated(std::string text) {
    for (int i = below(6); i >= 0; --i) mutate(text);
    return text;
  }
  int below(std::size_t bound) { return static_cast<int>(random_() % bound); }

 private:
  void mutate(std::string& text) {
    static const std::vector<std::string> kPieces = {"null", "-",  "1e308", "1e999",   "{",    "}",    "[",       "]",
                                                     ",",    "\"", "\\",    "\\u0000", "\xff", "true", "\"a\":1", "0"};
    const auto at = static_cast<std::size_t>(below(text.size() + 1));
    switch (below(4)) {
      case 0:
        if (at < text.size()) text[at] = static_cast<char>(below(256));
        break;
      case 1:
        text.insert(at, kPieces[static_cast<std::size_t>(below(kPieces.size()))]);
        break;
      case 2:
        text.erase(at, static_cast<std::size_t>(below(8)));
        break;
      default: {
        const std::string& other = kValid[static_cast<std::size_t>(below(kValid.size()))];
        text.insert(at, other, static_cast<std::size_t>(below(other.size())), static_cast<std::size_t>(below(20)));
      }
    }
  }

  std::mt19937 random_{20261122};
};

TEST(ViewerCommand, WhateverTheBytesTheAnswerIsACommandOrASentence) {
  Mutator mutator;
  int understood = 0, refused = 0;
  for (int i = 0; i < test::sweep_size(200000); ++i) {
    const std::string message = mutator.mutated(kValid[static_cast<std::size_t>(mutator.below(kValid.size()))]);
    const ParsedCommand result = parse_viewer_command(message);
    ASSERT_NE(result.command.has_value(), !result.error.empty()) << message;
    if (result.command) expect_sound(*result.command);
    result.command ? ++understood : ++refused;
  }
  EXPECT_GT(understood, 0);
  EXPECT_GT(refused, understood);
}

TEST(ViewerCommand, RandomBytesAreRefused) {
  std::mt19937 random(7);
  for (int i = 0; i < test::sweep_size(20000); ++i) {
    std::string message(random() % 200, '\0');
    for (char& c : message) c = static_cast<char>(random() & 0xffU);
    EXPECT_FALSE(parse_viewer_command(message).command.has_value());
  }
}

}  // namespace
}  // namespace tegotae
