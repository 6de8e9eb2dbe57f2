// SPDX-License-Identifier: Apache-2.0
#include <tests/lab/program_run.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <string>
#include <vector>

namespace tegotae {
namespace {

using testing::HasSubstr;
using testing::Not;

TEST(ProgramCompare, LeavesATableAJsonFileAndTheStability) {
  const TemporaryFolder folder;
  const std::string out = (folder.path() / "a").string();
  const ProgramResult result =
      run_program({"compare", "--method", "adachi", "--out", out, "--no-figures", "--experiment", "drag-vertex"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("Largest stable stiffness"));
  EXPECT_THAT(result.out, HasSubstr(out + "/comparison.md"));
  EXPECT_THAT(contents_of(folder.path() / "a" / "comparison.md"), HasSubstr("# Comparison of methods"));
  const auto json = nlohmann::json::parse(contents_of(folder.path() / "a" / "comparison.json"));
  EXPECT_EQ(json["format"], 1);
  EXPECT_FALSE(json["interrupted"]);
  EXPECT_EQ(json["methods"], std::vector<std::string>{"adachi"});
  EXPECT_EQ(json["stability"]["largest_stable_stiffness"].size(), 3U);
}

TEST(ProgramCompare, ComparesTwoMethodsOnAnExperiment) {
  const TemporaryFolder folder;
  const ProgramResult result = run_program({"compare", "--method", "proxy", "--method", "paper", "--experiment",
                                            "twist-square", "--no-stability", "--out", folder.path().string()});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("| experiment | proxy | paper |"));
  EXPECT_THAT(result.out, HasSubstr("| twist-square | "));
  EXPECT_THAT(result.out, Not(HasSubstr("Largest stable stiffness")));
  const auto json = nlohmann::json::parse(contents_of(folder.path() / "comparison.json"));
  ASSERT_EQ(json["experiments"].size(), 1U);
  const auto& rows = json["experiments"][0]["methods"];
  ASSERT_EQ(rows.size(), 2U);
  for (const auto& row : rows) EXPECT_EQ(row["state"], "done");
  // Only the proxy knows friction.
  EXPECT_LT(rows[0]["metrics"]["torque_rmse_of_peak"].get<double>(), 0.01);
  EXPECT_GT(rows[1]["metrics"]["torque_rmse_of_peak"].get<double>(), 0.5);
  EXPECT_TRUE(json["stability"].is_null());
  EXPECT_GT(std::filesystem::file_size(folder.path() / "figures" / "twist-square.svg"), 1000U);
  const std::string page = contents_of(folder.path() / "comparison.md");
  for (const char* text : {"## twist-square", "force RMSE [N]", "tick median [us]", "figures/twist-square.svg"}) {
    EXPECT_THAT(page, HasSubstr(text));
  }
}

TEST(ProgramCompare, WithoutGnuplotKeepsTheTablesAndSaysWhatToInstall) {
  const TemporaryFolder folder;
  const ProgramResult result = run_program({"compare", "--method", "adachi", "--experiment", "twist-square",
                                            "--no-stability", "--out", folder.path().string()},
                                           "PATH=/nowhere");
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("gnuplot"));
  EXPECT_THAT(contents_of(folder.path() / "comparison.md"), HasSubstr("| twist-square | "));
}

TEST(ProgramCompare, SaysWhatItCannotObey) {
  const TemporaryFolder folder;
  const std::string occupied = folder.write("occupied", "");
  const std::vector<std::vector<std::string>> wrong = {
      {"--method", "no-such"}, {"--experiment", "no-such"}, {"--out", ""}, {"--threads", "0"}, {"--fast"}};
  for (std::vector<std::string> arguments : wrong) {
    const std::string what = arguments[0];
    arguments.insert(arguments.begin(), "compare");
    const ProgramResult result = run_program(arguments);
    EXPECT_EQ(result.exit_code, 2) << what << result.err;
    EXPECT_EQ(result.err.rfind("tegotae: ", 0), 0U) << result.err;
    EXPECT_EQ(std::count(result.err.begin(), result.err.end(), '\n'), 1) << what << result.err;
  }
  EXPECT_THAT(run_program({"compare", "--method", "no-such"}).err, HasSubstr("there is no method 'no-such'"));
  EXPECT_EQ(run_program({"compare", "--out", occupied + "/out"}).exit_code, 1);
}

TEST(ProgramCompare, InterruptedLeavesWhatWasDoneAndSaysSo) {
  const TemporaryFolder folder;
  const ProgramResult result = run_program({"compare", "--threads", "1", "--out", folder.path().string()},
                                           "timeout --preserve-status -s TERM 1");
  EXPECT_EQ(result.exit_code, 143) << result.err;
  EXPECT_THAT(result.err, HasSubstr("tegotae: interrupted; what was done until then stands in "));
  EXPECT_TRUE(nlohmann::json::parse(contents_of(folder.path() / "comparison.json"))["interrupted"]);
  EXPECT_THAT(contents_of(folder.path() / "comparison.md"), HasSubstr("Interrupted"));
}

}  // namespace
}  // namespace tegotae
