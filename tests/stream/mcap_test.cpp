// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/child_process.hpp>
#include <tegotae/stream/mcap_reader.hpp>
#include <tegotae/stream/mcap_writer.hpp>

#include <tests/lab/temporary_folder.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace tegotae {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

struct Message {
  std::string topic, schema, data;
  std::uint64_t time;
  bool operator==(const Message&) const = default;
};

struct Recorded {
  std::vector<Message> messages;
  McapEnd end;
};

Recorded read(const std::filesystem::path& file) {
  Recorded recorded;
  recorded.end = read_mcap(file, [&](const McapMessage& message) {
    EXPECT_EQ(message.encoding, "json");
    recorded.messages.push_back(
        {std::string(message.topic), std::string(message.schema_name), std::string(message.data), message.time});
  });
  return recorded;
}

std::string contents(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file, std::ios::binary).rdbuf();
  return text.str();
}

void write_some(const std::filesystem::path& file, int messages) {
  McapWriter writer(file.string(), "test");
  const int tick = writer.add_channel("/tick", "Tick", R"({"type":"object"})");
  const int note = writer.add_channel("/note", "Note", "{}");
  for (int i = 0; i < messages; ++i) {
    writer.write(i % 3 == 2 ? note : tick, 1000000u * static_cast<unsigned>(i), "{\"i\":" + std::to_string(i) + "}");
  }
  writer.close();
  ASSERT_EQ(writer.error(), "");
}

TEST(Mcap, WhatWasWrittenIsRead) {
  const TemporaryFolder folder;
  write_some(folder.path() / "a.mcap", 7);
  const Recorded recorded = read(folder.path() / "a.mcap");
  EXPECT_TRUE(recorded.end.complete);
  EXPECT_EQ(recorded.end.messages, 7U);
  ASSERT_EQ(recorded.messages.size(), 7U);
  EXPECT_EQ(recorded.messages[1], (Message{"/tick", "Tick", "{\"i\":1}", 1000000U}));
  EXPECT_EQ(recorded.messages[5], (Message{"/note", "Note", "{\"i\":5}", 5000000U}));
}

// What the format's own library says of the file.
TEST(Mcap, IsReadByTheReferenceLibrary) {
  const TemporaryFolder folder;
  write_some(folder.path() / "a.mcap", 7);
  const std::string script = std::string(TEGOTAE_TESTS) + "/stream/read_with_mcap_core.js";
  const ChildResult result = run_child({"node", script, TEGOTAE_NPM_PACKAGES, (folder.path() / "a.mcap").string(),
                                        (folder.path() / "read.json").string()},
                                       folder.path());
  ASSERT_FALSE(result.not_found);
  ASSERT_EQ(result.exit_code, 0);
  const auto read = nlohmann::json::parse(contents(folder.path() / "read.json"));
  EXPECT_TRUE(read["complete"]);
  EXPECT_EQ(read["statistics"], 7);
  ASSERT_EQ(read["messages"].size(), 7U);
  const auto& fifth = read["messages"][5];
  EXPECT_EQ(fifth["topic"], "/note");
  EXPECT_EQ(fifth["schema"], "Note");
  EXPECT_EQ(fifth["encoding"], "json");
  EXPECT_EQ(fifth["time"], 5000000);
  EXPECT_EQ(fifth["data"]["i"], 5);
}

TEST(Mcap, CutAtAnyByteEveryCompleteRecordIsRead) {
  const TemporaryFolder folder;
  write_some(folder.path() / "whole.mcap", 6);
  const std::string whole = contents(folder.path() / "whole.mcap");
  const Recorded all = read(folder.path() / "whole.mcap");
  const auto cut = folder.path() / "cut.mcap";
  std::size_t most = 0;
  for (std::size_t length = 8; length < whole.size(); ++length) {
    std::ofstream(cut, std::ios::binary).write(whole.data(), static_cast<std::streamsize>(length));
    const Recorded recorded = read(cut);
    ASSERT_GE(recorded.messages.size(), most) << length;
    most = recorded.messages.size();
    ASSERT_TRUE(std::equal(recorded.messages.begin(), recorded.messages.end(), all.messages.begin())) << length;
    // All messages whose last byte stands before the cut.
    const std::string last = most < 6 ? "{\"i\":" + std::to_string(most) + "}" : std::string();
    if (!last.empty()) {
      EXPECT_LT(length, whole.find(last) + last.size()) << length;
    }
  }
  EXPECT_EQ(most, 6U);
}

TEST(Mcap, WhatIsNoRecordingIsRefusedWithASentence) {
  const TemporaryFolder folder;
  const auto refusal = [](const std::filesystem::path& file) {
    return [file] { read_mcap(file, [](const McapMessage&) {}); };
  };
  EXPECT_THAT(refusal(folder.path() / "none.mcap"), ThrowsMessage<RecordingError>(HasSubstr("No such file")));
  EXPECT_THAT(refusal(folder.path()), ThrowsMessage<RecordingError>(HasSubstr("directory")));
  EXPECT_THAT(refusal(folder.write("text.mcap", "t,x,y\n")), ThrowsMessage<RecordingError>(HasSubstr("no MCAP")));
  std::string damaged(mcap::kMagic);
  damaged += std::string(1, '\x05') + std::string(8, '\xff');
  EXPECT_THAT(refusal(folder.write("damaged.mcap", damaged)), ThrowsMessage<RecordingError>(HasSubstr("damaged")));
}

TEST(Mcap, AFullDiskIsSaidAndWritingGoesOn) {
  McapWriter writer("/dev/full", "test");
  const int channel = writer.add_channel("/tick", "Tick", "{}");
  for (int i = 0; i < 10; ++i) writer.write(channel, 0, "{}");
  writer.close();
  EXPECT_FALSE(writer.ok());
  EXPECT_THAT(writer.error(), testing::AllOf(HasSubstr("/dev/full"), HasSubstr("No space left")));
}

}  // namespace
}  // namespace tegotae
