// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/recorded_states.hpp>
#include <tegotae/lab/recording_file.hpp>
#include <tegotae/stream/mcap_reader.hpp>

#include <tests/lab/temporary_folder.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

namespace tegotae {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

std::string state(int i) { return R"({"type":"state","t":)" + std::to_string(i) + "}"; }

// Seconds 10, 11, ... 14, the scene and the settings changing before 12.
std::filesystem::path a_recording(const TemporaryFolder& folder, const std::vector<int>& times = {10, 11, 12, 13, 14}) {
  auto file = folder.path() / "a.mcap";
  RecordingFile recording(file, {}, 0.0);
  recording.write_scene(10.0, "{\"scene\":0}");
  recording.write_settings(10.0, "{\"settings\":0}");
  for (const int time : times) {
    if (time == 12) {
      recording.write_scene(12.0, "{\"scene\":1}");
      recording.write_settings(12.0, "{\"settings\":1}");
    }
    recording.write_state(time, state(time));
    recording.write(TickRecord());
  }
  recording.close();
  EXPECT_EQ(recording.error(), "");
  return file;
}

TEST(RecordedStates, AreFoundByTime) {
  const TemporaryFolder folder;
  RecordedStates states(a_recording(folder));
  EXPECT_TRUE(states.is_complete());
  ASSERT_EQ(states.count(), 5U);
  EXPECT_EQ(states.start(), 10.0);
  EXPECT_EQ(states.end(), 14.0);
  EXPECT_EQ(states.at(-1e9), 0U);
  EXPECT_EQ(states.at(10.0), 0U);
  EXPECT_EQ(states.at(11.999), 1U);
  EXPECT_EQ(states.at(12.0), 2U);
  EXPECT_EQ(states.at(1e9), 4U);
  for (const std::size_t i : {4U, 0U, 2U}) EXPECT_EQ(states.message(i), state(10 + static_cast<int>(i)));
}

TEST(RecordedStates, KnowWhichSceneAndSettingsHold) {
  const TemporaryFolder folder;
  RecordedStates states(a_recording(folder));
  EXPECT_EQ(states.scene_at(0), 0);
  EXPECT_EQ(states.scene_at(1), 0);
  EXPECT_EQ(states.scene_at(2), 1);
  EXPECT_EQ(states.settings_at(4), 1);
  EXPECT_EQ(states.scene(1), "{\"scene\":1}");
  EXPECT_EQ(states.settings(0), "{\"settings\":0}");
}

TEST(RecordedStates, TimeGoesOnWhereARunWasBegunAgain) {
  const TemporaryFolder folder;
  RecordedStates states(a_recording(folder, {10, 13, 10, 11, 10, 14}));
  const std::vector<double> expected = {10.0, 13.0, 13.0, 14.0, 14.0, 18.0};
  ASSERT_EQ(states.count(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(states.time_of(i), expected[i]) << i;
  EXPECT_EQ(states.at(13.5), 2U);
  EXPECT_EQ(states.message(2), state(10));
}

TEST(RecordedStates, OfACutFileAreThoseBeforeTheCut) {
  const TemporaryFolder folder;
  const auto file = a_recording(folder);
  std::uint64_t end_of_third = 0;
  int count = 0;
  read_mcap(file, [&](const McapMessage& message) {
    if (message.topic == kStateTopic.topic && ++count == 3) end_of_third = message.offset + message.data.size();
  });
  std::filesystem::resize_file(file, end_of_third + 5);
  RecordedStates states(file);
  EXPECT_FALSE(states.is_complete());
  EXPECT_EQ(states.count(), 3U);
  EXPECT_EQ(states.end(), 12.0);
  EXPECT_EQ(states.message(2), state(12));
}

TEST(RecordedStates, WithoutAnyTheRecordingIsRefusedWithTheMend) {
  const TemporaryFolder folder;
  const auto file = a_recording(folder, {});
  EXPECT_THAT([&] { RecordedStates states(file); },
              ThrowsMessage<RecordingError>(AllOf(HasSubstr(file.string()), HasSubstr("/tegotae/state"),
                                                  HasSubstr("tegotae render --trajectory"))));
}

TEST(RecordedStates, AFileThatShrinksMeanwhileIsSaid) {
  const TemporaryFolder folder;
  const auto file = a_recording(folder);
  RecordedStates states(file);
  std::filesystem::resize_file(file, 100);
  EXPECT_THAT([&] { states.message(4); }, ThrowsMessage<RecordingError>(HasSubstr("can no longer be read")));
}

}  // namespace
}  // namespace tegotae
