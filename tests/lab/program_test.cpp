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

const std::string kProgramScene = TEGOTAE_SCENES "/paper-cube.xml";
const std::string kMotion = "t,x,y,z,qw,qx,qy,qz\n5,0,0.11,0,1,0,0,0\n5.25,0,0.0996,0,1,0,0,0\n";

std::vector<std::string> render_command(const std::string& trajectory, const std::string& out,
                                        const std::vector<std::string>& more = {}) {
  std::vector<std::string> arguments = {"render",       "--scene",  kProgramScene, "--tool", "tool",
                                        "--trajectory", trajectory, "--out",       out};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

/// One clear sentence on the error stream, and nothing else of the kind that no person should see.
void expect_one_sentence(const ProgramResult& result, int exit_code, const std::string& what) {
  EXPECT_EQ(result.exit_code, exit_code) << result.err;
  EXPECT_THAT(result.err, HasSubstr(what));
  EXPECT_EQ(result.err.rfind("tegotae: ", 0), 0U) << result.err;
  EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << result.err;
  EXPECT_THAT(result.err, testing::Not(HasSubstr("terminate")));
}

TEST(Program, TellsItsVersionAndHelp) {
  const ProgramResult version = run_program({"--version"});
  EXPECT_EQ(version.exit_code, 0);
  EXPECT_THAT(version.out, testing::MatchesRegex("tegotae [0-9.]+\n"));
  const ProgramResult help = run_program({"render", "--help"});
  EXPECT_EQ(help.exit_code, 0);
  for (const char* word : {"--stiffness N/m", "--metric-length m|gyration", "--physics-rate Hz", "default"}) {
    EXPECT_THAT(help.out, HasSubstr(word));
  }
}

TEST(Program, ListsExperimentsAndMethods) {
  const ProgramResult experiments = run_program({"experiment", "--list"});
  EXPECT_EQ(experiments.exit_code, 0);
  for (const char* name : {"paper-cube", "tool-18", "tool-230-round", "tool-230-flat", "tilt-sweep"}) {
    EXPECT_THAT(experiments.out, HasSubstr(name));
  }
  EXPECT_THAT(run_program({"methods"}).out, HasSubstr("paper"));
}

TEST(ProgramExperiment, LeavesSamplesSummaryAndFigures) {
  const TemporaryFolder folder;
  const ProgramResult result = run_program({"experiment", "paper-cube", "--out", folder.path().string()});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  for (const char* text : {"force y [N]", "torque z [N m]", "contacts", "simulated time", "a  ", "b  ", "c  ",
                           "missed deadlines", "figures"}) {
    EXPECT_THAT(result.out, HasSubstr(text));
  }
  EXPECT_THAT(result.out, HasSubstr(folder.path().string()));
  EXPECT_EQ(read_samples(folder.path() / "samples.csv").rows.size(), 6001U);
  EXPECT_EQ(read_samples(folder.path() / "samples-gyration.csv").rows.size(), 6001U);
  const auto summary = nlohmann::json::parse(contents_of(folder.path() / "summary.json"));
  EXPECT_EQ(summary["variants"].size(), 2U);
  for (const char* name : {"figure-5", "figure-6", "metric-length", "face-contact"}) {
    for (const char* format : {".svg", ".png"}) {
      EXPECT_GT(std::filesystem::file_size(folder.path() / "figures" / (name + std::string(format))), 1000U) << name;
    }
  }
}

TEST(ProgramExperiment, ItsFiguresNameWhatWasRendered) {
  const TemporaryFolder folder;
  ASSERT_EQ(run_program({"experiment", "paper-cube", "--out", folder.path().string()}).exit_code, 0);
  const std::string svg = contents_of(folder.path() / "figures" / "metric-length.svg");
  EXPECT_TRUE(shows_text(svg, "l = 1 m"));
  EXPECT_TRUE(shows_text(svg, "l = gyration length"));
  EXPECT_TRUE(
      shows_text(contents_of(folder.path() / "figures" / "figure-5.svg"), "Height and force, l = 1 m (method proxy)"));
}

TEST(ProgramExperiment, RepeatsBitForBitWhereverItWrites) {
  const TemporaryFolder folder;
  for (const char* name : {"first", "quite/another place"}) {
    ASSERT_EQ(run_program({"experiment", "tool-18", "--out", (folder.path() / name).string()}).exit_code, 0);
  }
  const auto first = folder.path() / "first", second = folder.path() / "quite" / "another place";
  EXPECT_EQ(without_last_column(first / "samples.csv"), without_last_column(second / "samples.csv"));
  auto a = nlohmann::json::parse(contents_of(first / "summary.json"));
  auto b = nlohmann::json::parse(contents_of(second / "summary.json"));
  for (auto* summary : {&a, &b}) {
    for (auto& variant : (*summary)["variants"]) variant.erase("timing");
  }
  EXPECT_EQ(a, b);
}

TEST(ProgramExperiment, WithoutGnuplotKeepsTheSamplesAndSaysWhatToInstall) {
  const TemporaryFolder folder;
  const ProgramResult result =
      run_program({"experiment", "paper-cube", "--out", folder.path().string()}, "PATH=/nowhere");
  expect_one_sentence(result, 1, "gnuplot");
  EXPECT_EQ(read_samples(folder.path() / "samples.csv").rows.size(), 6001U);
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "summary.json"));
}

TEST(ProgramExperiment, InterruptedBeginsNoFurtherVariantAndLeavesNothingOfAnEarlierRun) {
  const TemporaryFolder folder;
  const std::vector<std::string> command = {"experiment", "paper-cube", "--out", folder.path().string()};
  ASSERT_EQ(run_program(command).exit_code, 0);
  std::vector<std::string> in_real_time = command;
  in_real_time.emplace_back("--realtime");
  const ProgramResult result = run_program(in_real_time, "timeout --preserve-status -s TERM 1");
  EXPECT_EQ(result.exit_code, 143) << result.err;
  EXPECT_THAT(result.err, HasSubstr("tegotae: interrupted; "));
  EXPECT_THAT(result.out, HasSubstr("not reached"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "samples-gyration.csv"));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "figures" / "figure-5.svg"));
  const SamplesTable table = read_samples(folder.path() / "samples.csv");
  ASSERT_FALSE(table.rows.empty());
  EXPECT_LT(table.rows.size(), 6001U);
  EXPECT_EQ(table.rows.back().size(), table.names.size());
  EXPECT_TRUE(nlohmann::json::parse(contents_of(folder.path() / "summary.json"))["interrupted"]);
}

TEST(ProgramExperiment, BadInputIsAnsweredWithASentence) {
  const TemporaryFolder folder;
  const std::string occupied = folder.write("occupied", "");
  expect_one_sentence(run_program({"experiment", "nothing"}), 2, "there is no experiment 'nothing'");
  expect_one_sentence(run_program({"experiment"}), 2, "--list");
  expect_one_sentence(run_program({"experiment", "paper-cube", "--method", "magic"}), 2, "there is no method 'magic'");
  expect_one_sentence(run_program({"experiment", "paper-cube", "--out", occupied + "/out"}), 1, "occupied/out");
  expect_one_sentence(run_program({"experiment", "paper-cube", "--out", "/proc/none"}), 1, "/proc/none");
  expect_one_sentence(run_program({"experiment", "paper-cube", "--out", ""}), 2, "takes a folder, not ''");
  expect_one_sentence(
      run_program({"experiment", "paper-cube", "--out", folder.path().string()}, "TEGOTAE_SCENES=/nowhere"), 1,
      "no scene file paper-cube.xml in /nowhere");
}

TEST(ProgramRender, WritesARowATickFromTheFirstToTheLastTime) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "out.csv").string();
  const ProgramResult result = run_program(render_command(folder.write("motion.csv", kMotion), out));
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(result.err, "");
  const SamplesTable table = read_samples(out);
  ASSERT_EQ(table.rows.size(), 251U);
  EXPECT_EQ(table.rows.front().front(), "5");
  EXPECT_EQ(table.rows[9].front(), "5.009");
  EXPECT_EQ(table.rows.back().front(), "5.25");
  EXPECT_NEAR(table.at(125, "y"), 0.1048, 1e-12);
  EXPECT_EQ(table.at(0, "fy"), 0.0);
  constexpr double kSkin = 2e-6;  // m
  EXPECT_NEAR(table.at(250, "fy"), 9000.0 * (0.4e-3 + kSkin), 1e-3);
  EXPECT_LT(std::abs(table.at(250, "tz")), 1e-9);
}

TEST(ProgramRender, CommandLineWinsOverTheScene) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "out.csv").string(), motion = folder.write("motion.csv", kMotion);
  ASSERT_EQ(run_program(render_command(motion, out,
                                       {"--stiffness", "1000", "--haptic-rate", "500", "--physics-rate", "50",
                                        "--metric-length", "gyration", "--margin", "0.01", "--constraint-set", "near",
                                        "--damping", "0", "--method", "paper"}))
                .exit_code,
            0);
  const SamplesTable table = read_samples(out);
  EXPECT_EQ(table.rows.size(), 126U);
  EXPECT_NEAR(table.at(125, "fy"), 1000.0 * 0.4e-3, 1e-3);
  for (const char* note : {"# stiffness: 1000 N/m", "# haptic rate: 500 Hz", "# physics rate: 50 Hz",
                           "# constraint set: near", "# margin: 0.01 m"}) {
    EXPECT_THAT(table.comments, testing::Contains(note));
  }
}

TEST(ProgramRender, RepeatsBitForBit) {
  const TemporaryFolder folder;
  const std::string motion = folder.write("motion.csv", kMotion);
  const std::string first = (folder.path() / "1.csv").string(), second = (folder.path() / "2.csv").string();
  ASSERT_EQ(run_program(render_command(motion, first)).exit_code, 0);
  ASSERT_EQ(run_program(render_command(motion, second)).exit_code, 0);
  EXPECT_EQ(without_last_column(first), without_last_column(second));
}

TEST(ProgramRender, RefusesOptionsThatMakeNoSense) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "out.csv").string(), motion = folder.write("motion.csv", kMotion);
  const auto with = [&](const std::string& option, const std::string& value) {
    return run_program(render_command(motion, out, {option, value}));
  };
  expect_one_sentence(with("--stiffness", "-5"), 2, "permitted are");
  expect_one_sentence(with("--stiffness", "stiff"), 2, "--stiffness: takes a number in N/m, not 'stiff'");
  expect_one_sentence(with("--damping", "nan"), 2, "permitted are");
  expect_one_sentence(with("--metric-length", "-1"), 2, "metric length");
  expect_one_sentence(with("--metric-length", "long"), 2, "'gyration'");
  expect_one_sentence(with("--physics-rate", "0"), 2, "permitted are");
  expect_one_sentence(with("--haptic-rate", "1e9"), 2, "permitted are");
  expect_one_sentence(with("--margin", "0"), 2, "permitted are");
  expect_one_sentence(with("--constraint-set", "some"), 2, "'near'");
  expect_one_sentence(with("--method", "magic"), 2, "there is no method");
  expect_one_sentence(with("--colour", "red"), 2, "--colour");
  expect_one_sentence(with("--tool-weight", "2"), 2, "--tool-weight takes 'on' or 'off'");
  expect_one_sentence(run_program({"render", "--scene", kProgramScene}), 2, "required");
  expect_one_sentence(run_program({"render"}), 2, "see 'tegotae render --help'");
  expect_one_sentence(run_program({}), 2, "--help");
  expect_one_sentence(run_program({"rendr"}), 2, "there is no command 'rendr'; there are: experiment, serve, render");
  expect_one_sentence(run_program(render_command(motion, out, {"--method", "adachi", "--constraint-set", "near"})), 2,
                      "'adachi' has no choice of constraint set");
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(ProgramRender, HasNoOptionsOfAnInterfaceAndSaysSo) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "out.csv").string(), motion = folder.write("motion.csv", kMotion);
  const std::string help = run_program({"render", "--help"}).out;
  for (const std::string option : {"--translation-scale", "--rotation-scale", "--force-scale", "--clutch-button",
                                   "--dead-man-button", "--energy-bound", "--beyond-rating"}) {
    const std::string sentence =
        option + " is of an interface in a hand, and 'tegotae render' plays the motion exactly";
    expect_one_sentence(run_program(render_command(motion, out, {option, "1"})), 2, sentence);
    expect_one_sentence(run_program(render_command(motion, out, {option})), 2, sentence);
    EXPECT_THAT(help, testing::Not(HasSubstr(option)));
  }
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(ProgramServe, TakesPortsThatThereAre) {
  for (const std::string command : {"serve", "replay"}) {
    for (const std::string port : {"99999", "65536", "-1", "80.5", "http"}) {
      std::vector<std::string> arguments = {command, "--port=" + port};
      if (command == "replay") arguments.emplace_back("none.mcap");
      expect_one_sentence(run_program(arguments, "timeout 20"), 2,
                          "--port: takes a port from 0 to 65535, not '" + port + "'");
    }
  }
}

TEST(ProgramServe, RefusesWhatMakesNoSenseBeforeItServes) {
  const auto with = [](const std::string& option, const std::string& value) {
    return run_program({"serve", "--port", "0", option, value}, "timeout 20");
  };
  expect_one_sentence(with("--energy-bound", "maybe"), 2, "--energy-bound takes 'on' or 'off', not 'maybe'");
  expect_one_sentence(with("--force-scale", "0"), 2, "permitted are");
  expect_one_sentence(with("--clutch-button", "0.5"), 2, "a whole number");
  expect_one_sentence(with("--clutch-button", "0"), 2, "the page has no buttons for --clutch-button");
  expect_one_sentence(with("--dead-man-button", "0"), 2, "the page has no buttons for --dead-man-button");
  expect_one_sentence(with("--translation-scale", "2"), 2, "the page moves the tool itself, without scales");
  expect_one_sentence(with("--interface", "simulated:parallel"), 2,
                      "tegotae experiment NAME --interface simulated:parallel");
  expect_one_sentence(with("--tool", "hammer"), 2, "--tool is a body of SCENE");
  expect_one_sentence(with("--recordings", "/proc/none"), 2, "--recordings: ");
}

TEST(ProgramRender, RefusesToReplaceWhatItReads) {
  const TemporaryFolder folder;
  const std::string motion = folder.write("motion.csv", kMotion),
                    scene = folder.write("scene.xml", contents_of(kProgramScene));
  std::filesystem::create_symlink(motion, folder.path() / "link.csv");
  const auto with = [&](const std::string& out) {
    return run_program({"render", "--scene", scene, "--tool", "tool", "--trajectory", motion, "--out", out});
  };
  expect_one_sentence(with(motion), 2, "is the file of --trajectory");
  expect_one_sentence(with((folder.path() / "link.csv").string()), 2, "is the file of --trajectory");
  expect_one_sentence(with(scene), 2, "is the file of --scene");
  EXPECT_EQ(contents_of(motion), kMotion);
  EXPECT_EQ(contents_of(scene), contents_of(kProgramScene));
}

TEST(ProgramRender, TellsOfForcesCutToTheirLimit) {
  const TemporaryFolder folder;
  const std::string deep = "t,x,y,z,qw,qx,qy,qz\n0,0,0.11,0,1,0,0,0\n1,0,0.08,0,1,0,0,0\n";
  const ProgramResult result =
      run_program(render_command(folder.write("deep.csv", deep), (folder.path() / "out.csv").string()));
  EXPECT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.err, HasSubstr("tegotae: warning: of 1001 ticks: "));
  EXPECT_THAT(result.err, HasSubstr("cut to its limit in "));
}

TEST(ProgramRender, InterruptedLeavesWholeRowsAndSaysSo) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "out.csv").string();
  const std::string endless = "t,x,y,z,qw,qx,qy,qz\n0,0,0.11,0,1,0,0,0\n50000,0,0.0996,0,1,0,0,0\n";
  for (const auto& [signal, exit_code] : {std::pair("INT", 130), std::pair("TERM", 143), std::pair("HUP", 129)}) {
    const ProgramResult result = run_program(render_command(folder.write("endless.csv", endless), out),
                                             std::string("timeout --preserve-status -s ") + signal + " 1");
    EXPECT_EQ(result.exit_code, exit_code) << result.err;
    EXPECT_THAT(result.err, HasSubstr("tegotae: interrupted; the "));
    const SamplesTable table = read_samples(out);
    ASSERT_FALSE(table.rows.empty());
    EXPECT_EQ(table.rows.back().size(), table.names.size());
  }
}

TEST(ProgramRender, NamesTheSceneSettingThatIsOutOfRange) {
  const TemporaryFolder folder;
  const std::string scene = folder.write(
      "fast.xml",
      "<mujoco><custom><numeric name=\"tegotae_physics_rate\" data=\"9999\"/></custom><worldbody>"
      "<body name=\"tool\" mocap=\"true\"><geom size=\"0.1\"/></body><geom size=\"0.1\"/></worldbody></mujoco>");
  expect_one_sentence(run_program({"render", "--scene", scene, "--tool", "tool", "--trajectory",
                                   folder.write("motion.csv", kMotion), "--out", (folder.path() / "out").string()}),
                      1, "fast.xml: the setting 'tegotae_physics_rate' in <custom>: ");
}

TEST(ProgramRender, RefusesBadTrajectories) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "out.csv").string(), header = "t,x,y,z,qw,qx,qy,qz\n0,0,1,0,1,0,0,0\n";
  const auto with = [&](const std::string& text) {
    return run_program(render_command(folder.write("bad.csv", text), out));
  };
  expect_one_sentence(with("t,x,y,z,qw,qx,qy\n0,0,1,0,1,0,0\n"), 1, "bad.csv, line 1: the header has no column 'qz'");
  expect_one_sentence(with(header + "1,0,nan,0,1,0,0,0\n"), 1, "bad.csv, line 3, column y");
  expect_one_sentence(with(header + "1,0,1,0,0,0,0,0\n"), 1, "bad.csv, line 3, column qw");
  expect_one_sentence(with(header + "-1,0,1,0,1,0,0,0\n"), 1, "bad.csv, line 3, column t");
  expect_one_sentence(with(header + "1e9,0,1,0,1,0,0,0\n"), 1, "seconds");
  expect_one_sentence(with(""), 1, "empty");
  expect_one_sentence(run_program(render_command((folder.path() / "none.csv").string(), out)), 1, "none.csv");
}

TEST(ProgramRender, RefusesBadScenesAndTools) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "out.csv").string(), motion = folder.write("motion.csv", kMotion);
  const auto with = [&](const std::string& scene, const std::string& tool) {
    return run_program({"render", "--scene", scene, "--tool", tool, "--trajectory", motion, "--out", out});
  };
  expect_one_sentence(with((folder.path() / "none.xml").string(), "tool"), 1, "none.xml");
  expect_one_sentence(with(folder.write("cut.xml", "<mujoco><worldbody>"), "tool"), 1, "cut.xml");
  expect_one_sentence(with(folder.write("text.xml", "hello"), "tool"), 1, "text.xml");
  expect_one_sentence(with(kProgramScene, "hammer"), 1, "'hammer'");
  const std::string newer = "<mujoco><option><flag nativeccd=\"enable\"/></option><worldbody/></mujoco>";
  expect_one_sentence(with(folder.write("newer.xml", newer), "tool"), 1, "newer.xml");
  const std::string jointed =
      "<mujoco><worldbody><body name=\"tool\"><freejoint/><geom size=\"0.1\"/></body></worldbody></mujoco>";
  expect_one_sentence(with(folder.write("jointed.xml", jointed), "tool"), 1, "jointed.xml");
  EXPECT_FALSE(std::filesystem::exists(out));
}

TEST(ProgramRender, RefusesAnOutputThatCannotBeWritten) {
  const TemporaryFolder folder;
  const std::string motion = folder.write("motion.csv", kMotion), occupied = folder.write("occupied", "");
  expect_one_sentence(run_program(render_command(motion, occupied + "/out.csv")), 1, "occupied/out.csv");
  expect_one_sentence(run_program(render_command(motion, (folder.path() / "none" / "out.csv").string())), 1,
                      "none/out.csv");
  expect_one_sentence(run_program(render_command(motion, "/dev/full")), 1, "No space left");
  expect_one_sentence(run_program(render_command(motion, folder.path().string())), 1, "this is a folder");
  expect_one_sentence(run_program(render_command(motion, "")), 2, "takes a file, not ''");
}

}  // namespace
}  // namespace tegotae
