// SPDX-License-Identifier: Apache-2.0
#include <tegotae/stream/web_page.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

namespace tegotae {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string bytes_of(std::string_view path) {
  for (const WebAsset& asset : web_page()) {
    if (asset.path == path) return std::string(asset.bytes);
  }
  ADD_FAILURE() << "the page has no " << path;
  return {};
}

TEST(WebPage, HasItsFilesAndTheirTypes) {
  ASSERT_EQ(web_page().size(), 4U);
  EXPECT_EQ(web_page()[0].path, "/");
  EXPECT_EQ(web_page()[0].content_type, "text/html; charset=utf-8");
  EXPECT_THAT(bytes_of("/"), testing::StartsWith("<!doctype html>"));
  EXPECT_THAT(bytes_of("/"), testing::EndsWith("</html>\n"));
  EXPECT_GT(bytes_of("/app.js").size(), 100000U) << "three.js and uPlot are inside";
  EXPECT_THAT(bytes_of("/app.css"), HasSubstr(".uplot")) << "uPlot's style is inside";
}

TEST(WebPage, CarriesTheLicencesOfWhatItContains) {
  const std::string licences = bytes_of("/licenses.txt");
  EXPECT_THAT(licences, HasSubstr("three 0."));
  EXPECT_THAT(licences, HasSubstr("uplot 1."));
  EXPECT_THAT(licences, HasSubstr("Permission is hereby granted"));
}

// What the page loads stands in the program: paths of its own assets, and data inside the page.
TEST(WebPage, LoadsNothingFromElsewhere) {
  const std::string html = bytes_of("/");
  for (const char* attribute : {"src=\"", "href=\""}) {
    for (std::size_t at = html.find(attribute); at != std::string::npos; at = html.find(attribute, at + 1)) {
      const std::size_t first = at + std::string_view(attribute).size();
      const std::string target = html.substr(first, html.find('"', first) - first);
      if (target.starts_with("data:")) continue;
      EXPECT_FALSE(bytes_of(target).empty()) << target;
    }
  }
  EXPECT_THAT(bytes_of("/app.css"), Not(HasSubstr("url(http")));
  EXPECT_THAT(bytes_of("/app.css"), Not(HasSubstr("@import")));
}

}  // namespace
}  // namespace tegotae
