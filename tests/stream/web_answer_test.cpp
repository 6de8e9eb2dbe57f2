// SPDX-License-Identifier: Apache-2.0
#include <tegotae/stream/web_answer.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

namespace tegotae {
namespace {

using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Pair;

const std::vector<WebAsset> kAssets = {{"/", "text/html; charset=utf-8", "page"},
                                       {"/app.js", "text/javascript", "script"}};

WebQuestion question(std::string_view method, std::string_view target) {
  WebQuestion asked;
  asked.method = method;
  asked.target = target;
  asked.host = "localhost:8700";
  asked.from_loopback = true;
  return asked;
}

WebQuestion upgrade(std::string_view target, std::string_view origin) {
  WebQuestion asked = question("GET", target);
  asked.is_upgrade = true;
  asked.origin = origin;
  asked.has_origin = true;
  return asked;
}

TEST(WebAnswer, AFileComesWithItsTypeAndThePolicy) {
  const WebAccess access("127.0.0.1", "");
  const WebAnswer answer = answer_of(question("GET", "/?a=b"), access, kAssets);
  EXPECT_EQ(answer.status, 200U);
  EXPECT_EQ(answer.content_type, "text/html; charset=utf-8");
  EXPECT_EQ(answer.bytes, "page");
  EXPECT_THAT(answer.headers, Contains(Pair("Cache-Control", "no-store")));
  EXPECT_THAT(answer.headers, Contains(Pair("X-Content-Type-Options", "nosniff")));
  EXPECT_THAT(answer.headers, Contains(Pair("Referrer-Policy", "no-referrer")));
  EXPECT_THAT(answer.headers,
              Contains(Pair("Content-Security-Policy",
                            ::testing::AllOf(HasSubstr("default-src 'none'"), HasSubstr("script-src 'self';"),
                                             HasSubstr("connect-src 'self' ws://localhost:8700;")))));
}

TEST(WebAnswer, RefusalsNameTheirReason) {
  const WebAccess access("127.0.0.1", "");
  EXPECT_EQ(answer_of(question("GET", "/none"), access, kAssets).status, 404U);
  EXPECT_EQ(answer_of(question("GET", ""), access, kAssets).status, 404U);
  const WebAnswer wrong_method = answer_of(question("DELETE", "/app.js"), access, kAssets);
  EXPECT_EQ(wrong_method.status, 405U);
  EXPECT_THAT(wrong_method.headers, Contains(Pair("Allow", "GET, HEAD")));
  EXPECT_EQ(answer_of(question("GET", "/live"), access, kAssets).status, 426U);
  WebQuestion foreign = question("GET", "/");
  foreign.host = "evil.example";
  const WebAnswer refused = answer_of(foreign, access, kAssets);
  EXPECT_EQ(refused.status, 403U);
  EXPECT_THAT(std::string(refused.bytes), HasSubstr("another name"));
}

TEST(WebAnswer, PagesAndSocketsAskForTheToken) {
  const WebAccess access("127.0.0.1", "abc");
  EXPECT_EQ(answer_of(question("GET", "/?token=abc"), access, kAssets).status, 200U);
  EXPECT_EQ(answer_of(question("HEAD", "/"), access, kAssets).status, 401U);
  EXPECT_EQ(answer_of(question("GET", "/app.js"), access, kAssets).status, 200U);
  EXPECT_EQ(answer_of(upgrade("/live?token=abc", "http://localhost:8700"), access, kAssets).status, 101U);
  EXPECT_EQ(answer_of(upgrade("/live", "http://localhost:8700"), access, kAssets).status, 401U);
  EXPECT_EQ(answer_of(upgrade("/live?token=abc", "http://evil.example"), access, kAssets).status, 403U);
}

TEST(WebAnswer, AProgramComesFromThisMachineOrWithTheToken) {
  const WebAccess open("0.0.0.0", ""), closed("0.0.0.0", "abc");
  WebQuestion program = upgrade("/live?token=abc", "");
  program.has_origin = false;
  EXPECT_EQ(answer_of(program, open, kAssets).status, 101U);
  program.from_loopback = false;
  EXPECT_EQ(answer_of(program, open, kAssets).status, 403U);
  EXPECT_EQ(answer_of(program, closed, kAssets).status, 101U);
}

}  // namespace
}  // namespace tegotae
