// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/doctor.hpp>
#include <tests/lab/program_run.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <set>
#include <string>
#include <vector>

namespace tegotae {
namespace {

using ::testing::HasSubstr;

TEST(Doctor, IsPossibleUnlessOneFindingSaysItIsNot) {
  EXPECT_TRUE(is_possible({}));
  std::vector<Finding> findings = {{Verdict::kOk, "a", "", ""}, {Verdict::kCouldBeBetter, "b", "", ""}};
  EXPECT_TRUE(is_possible(findings));
  findings.push_back({Verdict::kNotPossible, "c", "", ""});
  EXPECT_FALSE(is_possible(findings));
}

TEST(Doctor, WritesFindingsAsJson) {
  const std::vector<Finding> findings = {{Verdict::kCouldBeBetter, "clock rate", "a \"quoted\" word", "do this"},
                                         {Verdict::kNotPossible, "usb", "", ""}};
  const auto json = nlohmann::json::parse(findings_json(findings));
  ASSERT_EQ(json.size(), 2U);
  EXPECT_EQ(json[0]["subject"], "clock rate");
  EXPECT_EQ(json[0]["verdict"], "could be better");
  EXPECT_EQ(json[0]["found"], "a \"quoted\" word");
  EXPECT_EQ(json[0]["mend"], "do this");
  EXPECT_EQ(json[1]["verdict"], "not possible");
  EXPECT_EQ(nlohmann::json::parse(findings_json({})), nlohmann::json::array());
}

// What it says of this machine depends on it; that it looks at everything, and ends as it says, does not.
TEST(Doctor, TheProgramLooksAtEverythingAndItsExitCodeIsItsVerdict) {
  const ProgramResult result = run_program({"doctor", "--seconds", "0.3", "--json"});
  const auto json = nlohmann::json::parse(result.out);
  std::set<std::string> subjects;
  bool possible = true;
  for (const auto& finding : json) {
    subjects.insert(finding["subject"]);
    possible = possible && finding["verdict"] != "not possible";
    EXPECT_EQ(finding["verdict"] == "ok", finding["mend"].get<std::string>().empty()) << finding;
  }
  EXPECT_THAT(subjects, testing::IsSupersetOf(
                            {"kernel", "scheduling", "memory", "clock rate", "wake-ups", "tick", "usb", "spidar-g6"}));
  EXPECT_EQ(result.exit_code, possible ? 0 : 1) << result.err;
}

TEST(Doctor, TheProgramFailsWhereTheInterfaceAskedForIsNotThere) {
  const ProgramResult result = run_program({"doctor", "--seconds", "0.1", "--interface", "spidar-g6"});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.out, HasSubstr("not possible     spidar-g6"));
  EXPECT_THAT(result.err, HasSubstr("cannot be done on this machine"));
  const ProgramResult unknown = run_program({"doctor", "--interface", "typewriter"});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_THAT(unknown.err, HasSubstr("there is no interface 'typewriter'; there are: page, "));
}

TEST(Doctor, TheProgramKnowsInterfacesWithoutADevice) {
  const auto finding = [](const std::string& interface, const std::string& subject) {
    const ProgramResult result = run_program({"doctor", "--seconds", "0.1", "--json", "--interface", interface});
    for (const auto& found : nlohmann::json::parse(result.out)) {
      if (found["subject"] == subject) return found["verdict"].get<std::string>();
    }
    return std::string("none");
  };
  EXPECT_EQ(finding("page", "page"), "ok");
  EXPECT_EQ(finding("playback:/nowhere/none.mcap", "playback"), "not possible");
  EXPECT_EQ(run_program({"doctor", "--seconds", "0.1", "--interface", "playback:/nowhere/none.mcap"}).exit_code, 1);
  const ProgramResult without_file = run_program({"doctor", "--interface", "playback"});
  EXPECT_EQ(without_file.exit_code, 2);
  EXPECT_THAT(without_file.err, HasSubstr("tegotae: playback needs a file"));
}

}  // namespace
}  // namespace tegotae
