// SPDX-License-Identifier: Apache-2.0
#include <tegotae/runtime/recorder.hpp>

#include <tests/allocation_counter.hpp>
#include <tests/runtime/text_files.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <memory>
#include <thread>

namespace tegotae {
namespace {

using ::testing::HasSubstr;
using testing::TemporaryFolder;
using testing::text_of;

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

TEST(RecordThread, WritesAllThatWasPushedInOrder) {
  const TemporaryFolder folder;
  constexpr int kSamples = 20'000;
  CsvRecorder<Sample> recorder(folder / "a.csv", columns(), {"made for a test"});
  RecordThread<Sample> thread(recorder, kSamples);
  std::thread real_time([&] {
    for (int i = 0; i < kSamples; ++i) thread.push(sample_of(i));
  });
  real_time.join();
  thread.stop();
  recorder.close();
  EXPECT_EQ(thread.dropped(), 0U);
  EXPECT_EQ(text_of(folder / "a.csv"), expected_text(kSamples)) << "the same bytes as written at once";
}

TEST(RecordThread, FullRingDropsAndCountsInsteadOfWaiting) {
  const TemporaryFolder folder;
  std::atomic<bool> disk_stalls{true};
  auto stalling = columns();
  stalling[0].value = [&](const Sample& sample) {
    while (disk_stalls.load()) std::this_thread::yield();
    return sample.time;
  };
  CsvRecorder<Sample> recorder(folder / "a.csv", stalling);
  RecordThread<Sample> thread(recorder, 64);
  constexpr std::uint64_t kSamples = 1000;
  for (std::uint64_t i = 0; i < kSamples; ++i) thread.push(sample_of(static_cast<int>(i)));
  EXPECT_GE(thread.dropped(), kSamples - 65) << "the ring and the one record that the writer holds";
  disk_stalls.store(false);
  thread.stop();
  recorder.close();
  EXPECT_EQ(recorder.writer().rows_written() + thread.dropped(), kSamples);
}

TEST(RecordThread, UnwritableFileDoesNotDisturbTheRealTimeThread) {
  CsvRecorder<Sample> recorder("/dev/full", columns());
  RecordThread<Sample> thread(recorder);
  std::uint64_t dropped = 0;
  for (int i = 0; i < 1000; ++i) dropped += thread.push(sample_of(i)) ? 0 : 1;
  thread.stop();
  EXPECT_EQ(dropped, 0U);
  EXPECT_EQ(recorder.writer().rows_lost(), 1000U);
  EXPECT_THAT(recorder.writer().error(), HasSubstr("/dev/full"));
}

TEST(RecordThread, PushAllocatesNothing) {
  const TemporaryFolder folder;
  CsvRecorder<Sample> recorder(folder / "a.csv", columns());
  RecordThread<Sample> thread(recorder, 16);
  const testing::AllocationCounter counter;
  for (int i = 0; i < 1000; ++i) thread.push(sample_of(i));
  EXPECT_EQ(counter.count(), 0U);
}

TEST(RecordThread, StopsTwiceAndOnDestruction) {
  const TemporaryFolder folder;
  CsvRecorder<Sample> recorder(folder / "a.csv", columns(), {"made for a test"});
  {
    RecordThread<Sample> thread(recorder);
    thread.push(sample_of(0));
    thread.stop();
    thread.stop();
  }
  {
    RecordThread<Sample> thread(recorder);
    thread.push(sample_of(1));
  }
  recorder.close();
  EXPECT_EQ(text_of(folder / "a.csv"), expected_text(2));
}

}  // namespace
}  // namespace tegotae
