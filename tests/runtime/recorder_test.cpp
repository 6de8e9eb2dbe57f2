// SPDX-License-Identifier: Apache-2.0
#include <tegotae/runtime/recorder.hpp>

#include <tests/runtime/text_files.hpp>

#include <gtest/gtest.h>

#include <cstdint>
#include <string>
#include <vector>

namespace tegotae {
namespace {

using test::TemporaryFolder;
using test::text_of;

struct Sample {
  double time = 0.0;
  std::int32_t points = 0;
};

std::vector<CsvColumn<Sample>> columns() {
  return {{"t", "s", [](const Sample& sample) { return sample.time; }},
          {"points", "", [](const Sample& sample) { return static_cast<double>(sample.points); }}};
}

Sample sample_of(int i) { return {1e-3 * i, i}; }

std::string expected_text(int count) {
  std::string text = "# tegotae samples, format 1\n# made for a test\n# units: t[s]\nt,points\n";
  for (int i = 0; i < count; ++i) {
    append_number(text, 1e-3 * i);
    text += ',';
    append_number(text, i);
    text += '\n';
  }
  return text;
}

TEST(CsvRecorder, WritesOneRowARecord) {
  const TemporaryFolder folder;
  CsvRecorder<Sample> recorder(folder / "a.csv", columns(), {"made for a test"});
  for (int i = 0; i < 100; ++i) recorder.record(sample_of(i));
  recorder.close();
  EXPECT_TRUE(recorder.writer().ok());
  EXPECT_EQ(text_of(folder / "a.csv"), expected_text(100));
}

TEST(CsvRecorder, CountsTheRowsThatTheDiskDidNotTake) {
  CsvRecorder<Sample> recorder("/dev/full", columns());
  for (int i = 0; i < 1000; ++i) recorder.record(sample_of(i));
  recorder.close();
  EXPECT_EQ(recorder.writer().rows_lost(), 1000U);
  EXPECT_NE(recorder.writer().error().find("/dev/full"), std::string::npos);
}

}  // namespace
}  // namespace tegotae
