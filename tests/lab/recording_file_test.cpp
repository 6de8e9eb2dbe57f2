// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/recording_file.hpp>
#include <tegotae/lab/samples_file.hpp>
#include <tegotae/lab/trajectory_file.hpp>
#include <tegotae/stream/mcap_reader.hpp>

#include <tests/lab/program_run.hpp>
#include <tests/lab/samples_table.hpp>
#include <tests/lab/temporary_folder.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>
#include <string>
#include <vector>

namespace tegotae {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

TickRecord tick(int i) {
  TickRecord record;
  record.time = 1e-3 * i;
  record.X_WT.p = Vector3(0.1 * i, 1.0 / 3.0, -1e-17);
  record.wrench.force = Vector3(1.0 * i, 2.0 * i, 3.0 * i);
  record.tick_us = 0.5;
  return record;
}

void record_some(const std::filesystem::path& file, int ticks) {
  RecordingFile recording(file, {"method: proxy", "a \"quoted\" note"}, 5.0);
  for (int i = 0; i < ticks; ++i) recording.write(tick(i));
  recording.close();
  ASSERT_EQ(recording.error(), "");
}

TEST(RecordingFile, IsExportedAsTheSamplesThatTheRunWouldHaveWritten) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "a.mcap";
  record_some(file, 20);
  std::ostringstream csv;
  const RecordingExport done = export_csv(file, csv);
  EXPECT_EQ(done.ticks, 20U);
  EXPECT_TRUE(done.complete);
  EXPECT_THAT(csv.str(), HasSubstr("# a \"quoted\" note\n"));
  const SamplesTable table = read_samples(folder.write("a.csv", csv.str()));
  ASSERT_EQ(table.rows.size(), 20U);
  const std::vector<CsvColumn<TickRecord>> columns = sample_columns(5.0);
  for (int i = 0; i < 20; ++i) {
    for (const auto& column : columns) {
      EXPECT_EQ(table.at(static_cast<size_t>(i), column.name), column.value(tick(i))) << column.name;
    }
  }
}

TEST(RecordingFile, IsATrajectory) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "a.mcap";
  record_some(file, 20);
  EXPECT_TRUE(is_recording(file));
  const Trajectory motion = read_trajectory(file);
  EXPECT_EQ(motion.start(), 5.0);
  EXPECT_EQ(motion.end(), 5.019);
  EXPECT_EQ(motion.at(5.003).p, tick(3).X_WT.p.vector());
}

TEST(RecordingFile, CutOffItKeepsEveryTickBeforeTheCut) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "a.mcap";
  record_some(file, 20);
  std::filesystem::resize_file(file, std::filesystem::file_size(file) * 2 / 3);
  std::ostringstream csv;
  const RecordingExport done = export_csv(file, csv);
  EXPECT_FALSE(done.complete);
  EXPECT_GT(done.ticks, 5U);
  EXPECT_LT(done.ticks, 20U);
  EXPECT_EQ(read_trajectory(file).start(), 5.0);
}

TEST(RecordingFile, WithoutTicksIsRefused) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "a.mcap";
  record_some(file, 0);
  std::ostringstream csv;
  EXPECT_THAT([&] { export_csv(file, csv); }, ThrowsMessage<RecordingError>(HasSubstr("holds no ticks")));
}

TEST(RecordingFile, KeepsWhatThePagesWereToldAsItWas) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "a.mcap";
  RecordingFile recording(file, {}, 5.0);
  recording.write_scene(5.0, R"({"type":"scene"})");
  recording.write_settings(5.0, R"({"type":"settings"})");
  recording.write(tick(0));
  recording.write_state(5.25, R"({"type":"state","n":1})");
  EXPECT_EQ(recording.ticks(), 1U);
  recording.close();
  ASSERT_EQ(recording.error(), "");
  std::vector<std::string> read;
  EXPECT_TRUE(read_mcap(file, [&](const McapMessage& message) {
                if (message.topic == kTickTopic.topic || message.topic == kSessionTopic.topic) return;
                read.push_back(std::string(message.topic) + " " + std::string(message.schema_name) + " " +
                               std::to_string(message.time) + " " + std::string(message.data));
              }).complete);
  EXPECT_EQ(read, (std::vector<std::string>{R"(/tegotae/scene tegotae.Scene.v1 5000000000 {"type":"scene"})",
                                            R"(/tegotae/settings tegotae.Settings.v1 5000000000 {"type":"settings"})",
                                            R"(/tegotae/state tegotae.State.v1 5250000000 {"type":"state","n":1})"}));
}

TEST(RecordingFile, AFullDiskEndsItWithASentence) {
  RecordingFile recording("/dev/full", {}, 0.0);
  recording.write_scene(0.0, "{}");
  for (int i = 0; i < 200; ++i) {
    recording.write(tick(i));
    recording.write_state(1e-3 * i, "{}");
  }
  recording.close();
  EXPECT_FALSE(recording.ok());
  EXPECT_EQ(recording.ticks(), 200U);
  EXPECT_THAT(recording.error(),
              testing::AllOf(HasSubstr("/dev/full"), HasSubstr("No space left"), HasSubstr("Free space")));
}

// A recording rendered again gives the forces of the run that made it.
TEST(ProgramExport, ARecordedRunIsRenderedAgainTheSame) {
  const TemporaryFolder folder;
  const auto at = [&](const char* name) { return (folder.path() / name).string(); };
  const std::string motion =
      folder.write("motion.csv", "t,x,y,z,qw,qx,qy,qz\n0,0,0.101,0,1,0,0,0\n0.5,0,0.0995,0,1,0,0,0\n");
  const std::string scene = std::string(TEGOTAE_SCENES) + "/paper-cube.xml";
  const auto render = [&](const std::string& trajectory, const std::string& out, const std::string& recording) {
    std::vector<std::string> command = {"render",       "--scene",  scene,   "--tool", "tool",
                                        "--trajectory", trajectory, "--out", out};
    if (!recording.empty()) command.insert(command.end(), {"--record", recording});
    const ProgramResult result = run_program(command);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    EXPECT_EQ(result.err, "");
  };
  render(motion, at("first.csv"), at("first.mcap"));
  render(at("first.mcap"), at("again.csv"), "");
  ASSERT_EQ(run_program({"export", at("first.mcap"), "--csv", at("exported.csv")}).exit_code, 0);
  const SamplesTable first = read_samples(at("first.csv")), again = read_samples(at("again.csv")),
                     exported = read_samples(at("exported.csv"));
  ASSERT_EQ(first.rows.size(), 501U);
  ASSERT_EQ(again.rows.size(), 501U);
  EXPECT_EQ(exported.names, first.names);
  EXPECT_EQ(exported.rows, first.rows);
  for (size_t i = 0; i < 501; ++i) EXPECT_EQ(again.at(i, "fy"), first.at(i, "fy")) << i;
}

TEST(ProgramExport, BadInputIsAnsweredWithASentence) {
  const TemporaryFolder folder;
  const std::string text = folder.write("a.csv", "t,x\n");
  const ProgramResult result = run_program({"export", text, "--csv", (folder.path() / "b.csv").string()});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("no recording that can be read"));
  EXPECT_EQ(run_program({"export", text}).exit_code, 2);
}

}  // namespace
}  // namespace tegotae
