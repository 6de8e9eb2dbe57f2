// SPDX-License-Identifier: Apache-2.0
#include <tests/lab/program_run.hpp>
#include <tests/lab/samples_table.hpp>
#include <tests/lab/svg_texts.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace tegotae {
namespace {

using testing::HasSubstr;

void expect_refusal(const std::vector<std::string>& arguments, int exit_code, const std::string& what) {
  const ProgramResult result = run_program(arguments);
  EXPECT_EQ(result.exit_code, exit_code) << result.err;
  EXPECT_THAT(result.err, HasSubstr(what));
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
}

TEST(ProgramInterface, AnExperimentRunsOnASimulatedSpidarAndRepeats) {
  const TemporaryFolder folder;
  for (const char* name : {"first", "second"}) {
    const ProgramResult result =
        run_program({"experiment", "paper-cube", "--method", "paper", "--interface", "spidar-g6:x3r,simulated",
                     "--hand", "relaxed", "--out", (folder.path() / name).string()});
    ASSERT_EQ(result.exit_code, 0) << result.err;
    // Of 1 m the interface bears sqrt(k_r / k): 0.9 (1e-3 + 0.065) N m s/rad / 0.5 ms, over 9000 N/m.
    EXPECT_THAT(result.out, HasSubstr("metric length 1 m, the paper's equations literally; held to 0.115 m"));
    EXPECT_THAT(result.out, HasSubstr("displayed less commanded"));
    EXPECT_THAT(result.out, HasSubstr("of 6001 ticks"));
    EXPECT_THAT(result.err, HasSubstr("warning: one-metre: spidar-g6:x3r,simulated in a relaxed hand is rated for"));
  }
  for (const char* samples : {"samples.csv", "samples-gyration.csv"}) {
    EXPECT_EQ(without_last_column(folder.path() / "first" / samples),
              without_last_column(folder.path() / "second" / samples));
  }
  for (const char* name : {"displayed-force", "displayed-torque-gyration", "hand-and-tool", "figure-5"}) {
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "first" / "figures" / (name + std::string(".svg")))) << name;
  }
  const auto figures = folder.path() / "first" / "figures";
  for (const auto& entry : std::filesystem::directory_iterator(figures)) {
    if (entry.path().extension() != ".svg") continue;
    EXPECT_THAT(texts_outside(contents_of(entry.path())), testing::IsEmpty()) << entry.path();
  }
  const std::string face = contents_of(figures / "face-contact.svg");
  EXPECT_TRUE(shows_text(face, "l = 0.115 m"));
  EXPECT_TRUE(shows_text(face, "l = gyration length"));
  EXPECT_FALSE(shows_text(face, "l = 1 m"));
  EXPECT_THAT(contents_of(figures / "figure-5.svg"), HasSubstr("Height and force, l = 0.115 m"));
  // A later run without an interface leaves none of it.
  ASSERT_EQ(run_program({"experiment", "paper-cube", "--out", (folder.path() / "first").string()}).exit_code, 0);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "first" / "figures" / "displayed-force.svg"));
  const SamplesTable table = read_samples(folder.path() / "first" / "samples.csv");
  EXPECT_EQ(std::count(table.names.begin(), table.names.end(), "ifx"), 0);
  const auto summary = nlohmann::json::parse(contents_of(folder.path() / "first" / "summary.json"));
  EXPECT_FALSE(summary.contains("interface"));
  EXPECT_FALSE(summary["variants"][0].contains("display"));
}

TEST(ProgramInterface, RatingAndEnergyBoundCanBeTurnedOffByName) {
  const TemporaryFolder folder;
  const ProgramResult result =
      run_program({"experiment", "paper-cube", "--interface", "spidar-g6:x3r,simulated", "--beyond-rating", "on",
                   "--energy-bound", "off", "--out", folder.path().string()});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, testing::Not(HasSubstr("is rated for")));
  EXPECT_THAT(result.err, HasSubstr("warning: one-metre: the force that spidar-g6:x3r,simulated has was not enough"));
  const auto summary = nlohmann::json::parse(contents_of(folder.path() / "summary.json"));
  EXPECT_EQ(summary["variants"][0]["settings"]["metric_length_m"], 1.0);
  EXPECT_GT(summary["variants"][0]["safety_events"]["torque_saturated"], 1000);
}

TEST(ProgramInterface, ItsRecordingExportsToTheSameSamples) {
  const TemporaryFolder folder;
  const std::string recording = (folder.path() / "run.mcap").string(), csv = (folder.path() / "run.csv").string();
  ASSERT_EQ(run_program({"experiment", "wedge", "--interface", "simulated:parallel", "--record", recording, "--out",
                         folder.path().string()})
                .exit_code,
            0);
  ASSERT_EQ(run_program({"export", recording, "--csv", csv}).exit_code, 0);
  const SamplesTable samples = read_samples(folder.path() / "samples.csv"), exported = read_samples(csv);
  EXPECT_EQ(samples.names, exported.names);
  EXPECT_EQ(samples.rows, exported.rows);
  EXPECT_GT(samples.column("hqz"), 0U);
}

TEST(ProgramInterface, ARunOnItReplacesNoneWithoutIt) {
  const TemporaryFolder folder;
  const std::string there = "cd '" + folder.path().string() + "' &&";
  ASSERT_EQ(run_program({"experiment", "wedge"}, there).exit_code, 0);
  const std::string played = contents_of(folder.path() / "out" / "wedge" / "samples.csv");
  const ProgramResult held = run_program({"experiment", "wedge", "--interface", "simulated:parallel"}, there);
  ASSERT_EQ(held.exit_code, 0) << held.err;
  EXPECT_EQ(contents_of(folder.path() / "out" / "wedge" / "samples.csv"), played);
  const SamplesTable table = read_samples(folder.path() / "out" / "wedge-simulated-parallel" / "samples.csv");
  EXPECT_GT(table.column("ifx"), 0U);
}

TEST(ProgramInterface, WhatBelongsToItIsRefusedWithoutIt) {
  const std::vector<std::vector<std::string>> options = {
      {"--hand", "firm"}, {"--energy-bound", "off"}, {"--beyond-rating", "on"}};
  for (std::vector<std::string> option : options) {
    const std::string sentence =
        option[0] + " is of an interface in a hand, and without one the motion is played exactly; add --interface NAME";
    option.insert(option.begin(), {"experiment", "wedge", "--out", "/proc/none"});
    expect_refusal(option, 2, sentence);
  }
}

TEST(ProgramInterface, WhatCannotBeIsAnsweredWithASentence) {
  const TemporaryFolder folder;
  const auto on = [](const std::string& interface) {
    return std::vector<std::string>{"experiment", "paper-cube", "--interface", interface};
  };
  expect_refusal(on("spidar-g6:x3r"), 2, "give spidar-g6:x3r,simulated");
  expect_refusal(on("spidar-g6:x3f,simulated"), 2, "x3f");
  expect_refusal(on("spidar-g6:none,simulated"), 2, "neither a SPIDAR that has a name");
  expect_refusal(on("simulated:none"), 2, "there are: simulated:laboratory");
  expect_refusal(on("force-dimension:0"), 2, "is not simulated");
  expect_refusal({"experiment", "paper-cube", "--interface", "simulated:page", "--hand", "none"}, 2, "relaxed");
  expect_refusal(
      {"experiment", "table-edge", "--interface", "spidar-g6:x3r,simulated", "--out", folder.path().string()}, 1,
      "leaves the workspace");
}

TEST(ProgramInterface, ListsWhatThereIsAndWhatIsRefused) {
  const ProgramResult spidar = run_program({"interfaces", "spidar-g6"});
  EXPECT_THAT(spidar.out, HasSubstr("x4l: "));
  EXPECT_THAT(spidar.out, HasSubstr("x3f: refused: "));
  EXPECT_THAT(spidar.out, testing::Not(HasSubstr("page")));
  const ProgramResult all = run_program({"interfaces"});
  for (const char* line : {"page\n", "simulated:NAME\n", "    parallel: ", "force-dimension", "playback"}) {
    EXPECT_THAT(all.out, HasSubstr(line));
  }
  EXPECT_EQ(run_program({"interfaces", "page"}).exit_code, 0);
  EXPECT_THAT(run_program({"experiment", "--help"}).out, testing::Not(HasSubstr("x3f")));
  expect_refusal({"interfaces", "--out", "anywhere"}, 2, "add --workspace");
  expect_refusal({"interfaces", "falcon"}, 2, "there is no driver 'falcon'");
}

TEST(ProgramInterface, DrawsTheWorkspaceOfASpidar) {
  const TemporaryFolder folder;
  const ProgramResult result =
      run_program({"interfaces", "spidar-g6:x4r", "--workspace", "--out", folder.path().string()});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("spidar-g6:x4r: in the middle of the frame 22.5 N and 0.387 N m"));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "workspace-position.png"));
  expect_refusal({"interfaces", "virtuose", "--workspace"}, 2, "not 'virtuose'");
  expect_refusal({"interfaces", "spidar-g6:x9", "--workspace"}, 1, "'x9' is neither");
}

TEST(ProgramInterface, ListsASpidarOnItsOwnersTransport) {
  const std::string library = std::string(TEGOTAE_DOUBLES) + "/spidar/libmyboard.so";
  const ProgramResult result = run_program({"interfaces", "spidar-g6:x3r,transport=" + library});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("library: " + library));
  EXPECT_THAT(result.out, HasSubstr("after a crash: the board's own watchdog must")) << "as its library says";
  EXPECT_THAT(run_program({"interfaces", "spidar-g6:x3r"}).out, HasSubstr("transport=/path/libmyboard.so"));
  expect_refusal({"serve", "--interface", "spidar-g6:x3r,transport=/none.so"}, 1,
                 "was not found (looked for /none.so)");
}

}  // namespace
}  // namespace tegotae
