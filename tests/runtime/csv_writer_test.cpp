// SPDX-License-Identifier: Apache-2.0
#include <tegotae/runtime/csv_writer.hpp>

#include <tests/file_size_limit.hpp>
#include <tests/runtime/text_files.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <numbers>
#include <random>

namespace tegotae {
namespace {

using test::FileSizeLimit;
using test::TemporaryFolder;
using test::text_of;
using ::testing::EndsWith;
using ::testing::HasSubstr;
using ::testing::StartsWith;

CsvHead head_of_two() {
  CsvHead head;
  head.names = {"t", "status"};
  head.units = {"s", ""};
  return head;
}

std::string printed(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

TEST(CsvWriter, WritesHeadAndRows) {
  const TemporaryFolder folder;
  CsvHead head = head_of_two();
  head.comments = {"method: paper", "two\nlines"};
  CsvWriter writer(folder / "a.csv", head);
  writer.write_row(std::vector<double>{0.001, 0.0});
  writer.write_row(std::vector<double>{0.002, 3.0});
  writer.close();
  EXPECT_TRUE(writer.ok());
  EXPECT_EQ(writer.error(), "");
  EXPECT_EQ(writer.rows_written(), 2U);
  EXPECT_EQ(
      text_of(folder / "a.csv"),
      "# tegotae samples, format 1\n# method: paper\n# two\n# lines\n# units: t[s]\nt,status\n0.001,0\n0.002,3\n");
}

TEST(CsvWriter, NumbersAreShortAndReadBackToTheSameBits) {
  EXPECT_EQ(printed(0.1), "0.1");
  EXPECT_EQ(printed(100000.0), "100000");
  EXPECT_EQ(printed(-3.0), "-3");
  EXPECT_EQ(printed(-0.0), "-0");
  EXPECT_EQ(printed(1e300), "1e+300");
  EXPECT_EQ(printed(std::numeric_limits<double>::quiet_NaN()), "nan");
  EXPECT_EQ(printed(-std::numeric_limits<double>::infinity()), "-inf");
  std::mt19937_64 random(1);
  for (int i = 0; i < 100'000; ++i) {
    const auto value = i % 2 == 0 ? std::bit_cast<double>(random()) : std::ldexp(static_cast<double>(random()), -40);
    if (std::isnan(value)) continue;
    ASSERT_EQ(std::bit_cast<std::uint64_t>(std::strtod(printed(value).c_str(), nullptr)),
              std::bit_cast<std::uint64_t>(value))
        << printed(value);
  }
}

TEST(CsvWriter, EqualRowsAreEqualBytes) {
  const TemporaryFolder folder;
  for (const char* name : {"a.csv", "b.csv"}) {
    std::mt19937_64 random(2);
    CsvWriter writer(folder / name, head_of_two());
    for (int i = 0; i < 20'000; ++i) {
      writer.write_row(std::vector<double>{1e-3 * i, std::ldexp(static_cast<double>(random()), -64)});
    }
  }
  const std::string a = text_of(folder / "a.csv");
  EXPECT_GT(a.size(), 4U * 65536U) << "several blocks";
  EXPECT_EQ(a, text_of(folder / "b.csv"));
  EXPECT_THAT(a, EndsWith("\n"));
}

TEST(CsvWriter, PathThatCannotBeWrittenIsSaidAndRowsAreCounted) {
  const TemporaryFolder folder;
  CsvWriter(folder / "plain_file", head_of_two()).close();
  for (const std::string& path : {folder / "no_such_folder/a.csv", folder / "plain_file/a.csv", folder / "."}) {
    CsvWriter writer(path, head_of_two());
    EXPECT_FALSE(writer.ok());
    writer.write_row(std::vector<double>{1.0, 2.0});
    writer.close();
    EXPECT_EQ(writer.rows_written(), 0U);
    EXPECT_EQ(writer.rows_lost(), 1U);
    EXPECT_THAT(writer.error(), StartsWith("Cannot write '" + path + "': "));
  }
}

TEST(CsvWriter, FullDiskIsSaidAndTheLoopGoesOn) {
  CsvWriter writer("/dev/full", head_of_two());
  EXPECT_FALSE(writer.ok()) << "the head cannot be written";
  for (int i = 0; i < 10; ++i) writer.write_row(std::vector<double>{1.0, 2.0});
  writer.close();
  EXPECT_THAT(writer.error(), HasSubstr("/dev/full"));
  EXPECT_THAT(writer.error(), HasSubstr("No space left"));
  EXPECT_EQ(writer.rows_lost(), 10U);
}

TEST(CsvWriter, DiskThatFillsUpLeavesCompleteRowsOnly) {
  const TemporaryFolder folder;
  constexpr int kRows = 30'000;
  // In the head, at its end, within the first block, and in later ones.
  for (const rlim_t bytes : {5U, 51U, 1000U, 65536U, 100'001U, 200'003U}) {
    const std::string path = folder / "full.csv";
    std::uint64_t rows_written = 0;
    {
      const FileSizeLimit limit(bytes);
      CsvWriter writer(path, head_of_two());
      for (int i = 0; i < kRows; ++i) writer.write_row(std::vector<double>{1e-3 * i, std::numbers::pi * i});
      writer.close();
      EXPECT_FALSE(writer.ok());
      EXPECT_EQ(writer.rows_written() + writer.rows_lost(), static_cast<std::uint64_t>(kRows));
      rows_written = writer.rows_written();
    }
    const std::string text = text_of(path);
    EXPECT_LE(text.size(), bytes);
    std::string expected;
    if (bytes > 60) {
      expected = "# tegotae samples, format 1\n# units: t[s]\nt,status\n";
      for (int i = 0; i < static_cast<int>(rows_written); ++i) {
        expected += printed(1e-3 * i) + "," + printed(std::numbers::pi * i) + "\n";
      }
      EXPECT_EQ(text, expected) << "limit " << bytes;
      EXPECT_GT(text.size() + 60, bytes) << "nothing is lost that the disk could hold";
    } else {
      EXPECT_EQ(rows_written, 0U);
      EXPECT_TRUE(text.empty() || text.back() == '\n');
    }
  }
}

TEST(CsvWriter, RowsAfterCloseAreLostAndSaid) {
  const TemporaryFolder folder;
  CsvWriter writer(folder / "a.csv", head_of_two());
  writer.close();
  writer.write_row(std::vector<double>{1.0, 2.0});
  EXPECT_EQ(writer.rows_lost(), 1U);
  EXPECT_THAT(writer.error(), HasSubstr("closed"));
}

}  // namespace
}  // namespace tegotae
