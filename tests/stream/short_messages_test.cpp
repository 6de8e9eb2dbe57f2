// SPDX-License-Identifier: Apache-2.0
#include <tegotae/stream/short_messages.hpp>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace tegotae {
namespace {

using Json = nlohmann::json;

TEST(ShortMessages, AreWhatTheProtocolHas) {
  EXPECT_EQ(Json::parse(encode_welcome(3)), Json::parse(R"({"type": "welcome", "viewer": 3})"));
  EXPECT_EQ(Json::parse(encode_end("Ctrl-C.")), Json::parse(R"({"type": "end", "text": "Ctrl-C."})"));
  const Json notice = Json::parse(encode_notice(NoticeLevel::kWarning, "the \"disk\" is full"));
  EXPECT_EQ(notice, (Json{{"type", "notice"}, {"level", "warning"}, {"text", "the \"disk\" is full"}}));
  EXPECT_EQ(Json::parse(encode_notice(NoticeLevel::kInfo, ""))["level"], "info");
  EXPECT_EQ(Json::parse(encode_notice(NoticeLevel::kError, ""))["level"], "error");
}

}  // namespace
}  // namespace tegotae
