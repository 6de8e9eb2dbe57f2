// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/input_error.hpp>
#include <tegotae/lab/trajectory_file.hpp>
#include <tests/lab/temporary_folder.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sstream>
#include <string>

namespace tegotae {
namespace {

using testing::HasSubstr;

Trajectory read_motion(const std::string& text) {
  std::istringstream stream(text);
  return read_trajectory(stream, "motion.csv");
}

std::string error_of(const std::string& text) {
  try {
    read_motion(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

constexpr const char* kHeader = "t,x,y,z,qw,qx,qy,qz\n";

TEST(TrajectoryFile, ReadsPosesInOrderOfTime) {
  const Trajectory motion = read_motion(std::string(kHeader) + "0.5,1,2,3,1,0,0,0\n1.5,-1,2e-3,+3,0,1,0,0\n");
  ASSERT_EQ(motion.samples().size(), 2U);
  EXPECT_EQ(motion.start(), 0.5);
  EXPECT_EQ(motion.end(), 1.5);
  EXPECT_EQ(motion.samples()[1].X_WT.p, Vector3(-1.0, 2e-3, 3.0));
  EXPECT_EQ(motion.samples()[1].X_WT.q.x(), 1.0);
}

TEST(TrajectoryFile, TakesColumnsInAnyOrderAndIgnoresOthers) {
  const Trajectory motion =
      read_motion("# recorded by hand\n\nnote, qz,qy,qx,qw ,z,y,x,t\r\n# in between\nhello,0,0,0,1,3,2,1,7\r\n\n");
  ASSERT_EQ(motion.samples().size(), 1U);
  EXPECT_EQ(motion.start(), 7.0);
  EXPECT_EQ(motion.samples()[0].X_WT.p, Vector3(1.0, 2.0, 3.0));
  EXPECT_EQ(motion.samples()[0].X_WT.q.w(), 1.0);
}

TEST(TrajectoryFile, IgnoresAByteOrderMark) {
  EXPECT_EQ(read_motion("\xEF\xBB\xBF" + std::string(kHeader) + "0,0,0,0,1,0,0,0\n").samples().size(), 1U);
}

TEST(TrajectoryFile, NormalisesRoundedQuaternions) {
  const Trajectory motion = read_motion(std::string(kHeader) + "0,0,0,0,0.924,0,0,0.383\n");
  EXPECT_NEAR(motion.samples()[0].X_WT.q.norm(), 1.0, 1e-15);
  EXPECT_NEAR(motion.samples()[0].X_WT.q.z() / motion.samples()[0].X_WT.q.w(), 0.383 / 0.924, 1e-15);
}

TEST(TrajectoryFile, NamesTheMissingColumn) {
  const std::string error = error_of("t,x,y,qw,qx,qy,qz\n0,0,0,1,0,0,0\n");
  EXPECT_THAT(error, HasSubstr("motion.csv, line 1"));
  EXPECT_THAT(error, HasSubstr("no column 'z'"));
}

TEST(TrajectoryFile, NamesTheDoubledColumn) {
  EXPECT_THAT(error_of("t,x,x,y,z,qw,qx,qy,qz\n"), HasSubstr("more than one column 'x'"));
}

struct BadSample {
  const char* row;
  const char* place;
  const char* what;
};

class BadSamples : public testing::TestWithParam<BadSample> {};

TEST_P(BadSamples, AreRefusedWithLineColumnAndCause) {
  const std::string error = error_of("# a comment\n" + std::string(kHeader) + "0,0,0,0,1,0,0,0\n" + GetParam().row);
  EXPECT_THAT(error, HasSubstr(std::string("motion.csv, line 4, column ") + GetParam().place));
  EXPECT_THAT(error, HasSubstr(GetParam().what));
  EXPECT_EQ(error.find('\n'), std::string::npos);
}

INSTANTIATE_TEST_SUITE_P(TrajectoryFile, BadSamples,
                         testing::Values(BadSample{"1,0,nan,0,1,0,0,0\n", "y", "not finite"},
                                         BadSample{"1,0,0,inf,1,0,0,0\n", "z", "not finite"},
                                         BadSample{"1,abc,0,0,1,0,0,0\n", "x", "'abc' is not a number"},
                                         BadSample{"1,1.5m,0,0,1,0,0,0\n", "x", "'1.5m' is not a number"},
                                         BadSample{"1,,0,0,1,0,0,0\n", "x", "'' is not a number"},
                                         BadSample{"1,0,0,0,1,0,0\n", "qz", "is missing"},
                                         BadSample{"1,0,0,0,0,0,0,0\n", "qw", "norm 0"},
                                         BadSample{"1,0,0,0,2,0,0,0\n", "qw", "norm 2"},
                                         BadSample{"1,0,0,0,1.01,0,0,0\n", "qw", "norm 1.01"},
                                         BadSample{"-1,0,0,0,1,0,0,0\n", "t", "not later than"},
                                         BadSample{"0,0,0,0,1,0,0,0\n", "t", "not later than"}));

TEST(TrajectoryFile, RefusesAFileWithoutSamples) {
  EXPECT_THAT(error_of(""), HasSubstr("empty"));
  EXPECT_THAT(error_of("# nothing\n\n"), HasSubstr("empty"));
  EXPECT_THAT(error_of(kHeader), HasSubstr("no sample"));
}

TEST(TrajectoryFile, SaysWhyAFileCannotBeRead) {
  const TemporaryFolder folder;
  EXPECT_THAT([&] { read_trajectory(folder.path() / "nowhere.csv"); },
              testing::ThrowsMessage<InputError>(HasSubstr("No such file")));
  EXPECT_THAT([&] { read_trajectory(folder.path()); }, testing::ThrowsMessage<InputError>(HasSubstr("folder")));
}

TEST(TrajectoryFile, ReadsFromAFile) {
  const TemporaryFolder folder;
  const std::string file = folder.write("motion.csv", std::string(kHeader) + "0,0,0,0.25,1,0,0,0\n");
  EXPECT_EQ(read_trajectory(file).samples()[0].X_WT.p.z(), 0.25);
}

}  // namespace
}  // namespace tegotae
