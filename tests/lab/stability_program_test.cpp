// SPDX-License-Identifier: Apache-2.0
#include <tests/lab/program_run.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace tegotae {
namespace {

using testing::HasSubstr;

TEST(ProgramStability, PrintsATableAndLeavesTheSameAsJson) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "a").string();
  const ProgramResult result =
      run_program({"stability", "--method", "paper", "--contact", "face", "--metric-length", "0.08", "--out", out});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  for (const char* text :
       {"largest [N/m]", "linear [N/m]", "C-S", "A-O", "face", "excess [J]", "delay 1 ms", "report"}) {
    EXPECT_THAT(result.out, HasSubstr(text));
  }
  const auto json = nlohmann::json::parse(contents_of(folder.path() / "a" / "stability.json"));
  EXPECT_EQ(json["largest_stable_stiffness"].size(), 1U);
  EXPECT_EQ(json["energy_in_random_contact"].size(), 1U);
  EXPECT_GT(json["largest_stable_stiffness"][0]["ratio_to_linear"].get<double>(), 0.9);
}

TEST(ProgramStability, InterruptedKeepsWholeRowsAndSaysSo) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "stability.json";
  folder.write("stability.json", "an earlier one");
  for (const auto& [signal, exit_code] : {std::pair("INT", 130), std::pair("TERM", 143)}) {
    const ProgramResult result = run_program({"stability", "--all", "--out", folder.path().string()},
                                             std::string("timeout --preserve-status -s ") + signal + " 1");
    EXPECT_EQ(result.exit_code, exit_code) << result.err;
    EXPECT_THAT(result.err, HasSubstr("tegotae: interrupted; the rows until then stand in " + file.string()));
    EXPECT_TRUE(nlohmann::json::parse(contents_of(file))["interrupted"]);
  }
}

TEST(ProgramStability, SaysWhatItCannotObey) {
  const std::vector<std::vector<std::string>> wrong = {
      {"--method", "no-such"}, {"--contact", "corner"},        {"--hand", "third"},   {"--device", "anvil"},
      {"--delay", "-1"},       {"--all", "--method", "paper"}, {"--stiffness", "-5"}, {"--metric-length", "-1"},
      {"--haptic-rate", "0"},  {"--physics-rate", "1e9"}};
  for (std::vector<std::string> arguments : wrong) {
    const std::string what = arguments[0];
    arguments.insert(arguments.begin(), "stability");
    const ProgramResult result = run_program(arguments);
    EXPECT_EQ(result.exit_code, 2) << what << result.err;
    EXPECT_EQ(result.err.rfind("tegotae: ", 0), 0U) << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << what << result.err;
  }
}

}  // namespace
}  // namespace tegotae
