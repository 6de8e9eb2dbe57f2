// SPDX-License-Identifier: Apache-2.0
#include <tegotae/stream/random_token.hpp>
#include <tegotae/stream/viewer_options.hpp>
#include <tegotae/stream/web_access.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

namespace tegotae {
namespace {

TEST(WebAccess, TakesTheHostFromAHeader) {
  EXPECT_EQ(host_of("LocalHost:8700"), "localhost");
  EXPECT_EQ(host_of("127.0.0.1"), "127.0.0.1");
  EXPECT_EQ(host_of("[::1]:80"), "[::1]");
  EXPECT_EQ(host_of("[FE80::1]"), "[fe80::1]");
  for (const char* none : {"", ":", ":80", "[]", "[::1", "[::1]x", "a:b", "a:123456", "a b", "a/b", "user@a", "a,b",
                           "?", "::1", "a\"", "[a b]"}) {
    EXPECT_EQ(host_of(none), "") << none;
  }
}

TEST(WebAccess, ServesItsNamesAlone) {
  const WebAccess loopback("127.0.0.1", "");
  EXPECT_TRUE(loopback.serves("localhost"));
  EXPECT_TRUE(loopback.serves("127.0.0.1:8700"));
  EXPECT_TRUE(loopback.serves("[::1]:8700"));
  EXPECT_FALSE(loopback.serves("localhost.evil.example"));
  EXPECT_FALSE(loopback.serves("127.0.0.1.evil.example"));
  EXPECT_FALSE(loopback.serves("192.168.1.5"));
  EXPECT_FALSE(loopback.serves(""));
  const WebAccess named("Bench.Lab.Example", "");
  EXPECT_TRUE(named.serves("bench.lab.example:8700"));
  EXPECT_FALSE(named.serves("lab.example"));
  const WebAccess address("fe80::1", "");
  EXPECT_TRUE(address.serves("[fe80::1]:8700"));
}

TEST(WebAccess, AWildcardServesAddressesInFigures) {
  for (const char* wildcard : {"0.0.0.0", "::", "[::]"}) {
    const WebAccess access(wildcard, "");
    EXPECT_TRUE(access.serves("192.168.1.5:8700")) << wildcard;
    EXPECT_TRUE(access.serves("[2001:db8::1]")) << wildcard;
    EXPECT_FALSE(access.serves("192.168.1.5.evil.example")) << wildcard;
    EXPECT_FALSE(access.serves("[2001:db8::1::2]")) << wildcard;
    EXPECT_FALSE(access.serves("300.1.1.1")) << wildcard;
  }
}

TEST(WebAccess, APageIsOfTheHostThatWasAskedFor) {
  EXPECT_TRUE(WebAccess::same_origin("http://localhost:8700", "localhost:8700"));
  EXPECT_TRUE(WebAccess::same_origin("https://LOCALHOST", "localhost"));
  EXPECT_FALSE(WebAccess::same_origin("http://localhost:8701", "localhost:8700"));
  EXPECT_FALSE(WebAccess::same_origin("http://localhost", "localhost:8700"));
  EXPECT_FALSE(WebAccess::same_origin("http://localhost:8700.evil.example", "localhost:8700"));
  EXPECT_FALSE(WebAccess::same_origin("localhost:8700", "localhost:8700"));
  EXPECT_FALSE(WebAccess::same_origin("null", "null"));
  EXPECT_FALSE(WebAccess::same_origin("file://localhost", "localhost"));
}

TEST(WebAccess, AsksForTheWholeToken) {
  const WebAccess access("127.0.0.1", "abc123");
  EXPECT_TRUE(access.shows_token("/?token=abc123"));
  EXPECT_TRUE(access.shows_token("/?x=1&token=abc123&y"));
  for (const char* wrong :
       {"/", "/?", "/?token", "/?token=", "/?token=abc12", "/?token=abc1234", "/?token=abc123abc123", "/?token=ABC123",
        "/?Token=abc123", "/?x=token=abc123", "/token=abc123", "/?token=x&token=abc123"}) {
    EXPECT_FALSE(access.shows_token(wrong)) << wrong;
  }
  EXPECT_TRUE(WebAccess("127.0.0.1", "").shows_token("/"));
  EXPECT_THROW(WebAccess("127.0.0.1", "a&b"), WebServerError);
}

TEST(WebAccess, GivesTheAddress) {
  EXPECT_EQ(WebAccess("127.0.0.1", "").address(8700), "http://127.0.0.1:8700/");
  EXPECT_EQ(WebAccess("::1", "abc").address(80), "http://[::1]:80/?token=abc");
  const WebAccess all("0.0.0.0", "");
  const std::string address = all.address(8700);
  EXPECT_THAT(address, ::testing::MatchesRegex("http://.+:8700/"));
  const std::string host = address.substr(7, address.size() - 8);
  EXPECT_TRUE(all.serves(host)) << host;
}

TEST(RandomToken, Has128BitsOfItsOwn) {
  std::set<std::string> tokens;
  for (int i = 0; i < 100; ++i) {
    const std::string token = random_token();
    EXPECT_EQ(token.size(), 32U);
    EXPECT_EQ(token.find_first_not_of("0123456789abcdef"), std::string::npos);
    tokens.insert(token);
  }
  EXPECT_EQ(tokens.size(), 100U);
}

}  // namespace
}  // namespace tegotae
