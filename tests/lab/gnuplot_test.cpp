// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/gnuplot.hpp>
#include <tests/lab/svg_texts.hpp>
#include <tests/lab/temporary_folder.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace tegotae {
namespace {

using Lines = std::vector<std::string>;

TEST(GnuplotLines, AreBrokenAtSpaces) {
  EXPECT_EQ(lines_of("", 10), Lines{""});
  EXPECT_EQ(lines_of("ten letter", 10), Lines{"ten letter"});
  EXPECT_EQ(lines_of("eleven char", 10), (Lines{"eleven", "char"}));
  EXPECT_EQ(lines_of("one two three four", 7), (Lines{"one two", "three", "four"}));
  EXPECT_EQ(lines_of("one two (three four) five", 13), (Lines{"one two", "(three four)", "five"}))
      << "not in a bracket";
}

TEST(GnuplotLines, BreakAWordThatFillsNoLineButNoEscape) {
  EXPECT_EQ(lines_of("abcdefghij", 4), (Lines{"abcd", "efgh", "ij"}));
  EXPECT_EQ(lines_of(R"(abc\\_def)", 4), (Lines{"abc", R"(\\_d)", "ef"}));
  EXPECT_EQ(lines_of(R"(abc\\_def)", 5), (Lines{"abc", R"(\\_de)", "f"}));
}

TEST(GnuplotText, IsShownLetterByLetter) {
  const TemporaryFolder folder;
  const std::string text = R"(a_b^c {d} @e &f ~g "h" 'i' \j \n)";
  folder.write("text.gnuplot",
               gnuplot_script("text", "", "set title \"" + gnuplot_text(text) + "\"\nplot 0 notitle\n", 600, 300));
  run_gnuplot("text", folder.path());
  std::string titles;
  for (const SvgText& shown : svg_texts(contents_of(folder.path() / "text.svg"))) titles += shown.text + "|";
  EXPECT_THAT(titles, testing::HasSubstr(text));
}

}  // namespace
}  // namespace tegotae
