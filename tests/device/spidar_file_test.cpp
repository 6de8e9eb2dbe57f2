// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/spidar_file.hpp>
#include <tegotae/device/spidar_presets.hpp>

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <string>

namespace tegotae {
namespace {

const std::string kHead =
    "# a frame of our own\n"
    "name ours\n"
    "metres_per_pulse 2e-5  # at the pulley\n"
    "volts_per_newton 0.1\n"
    "tension 0.4 15\n"
    "axial_stiffness 5000\n";

// What must stand above the strings.
const std::string kNumbers =
    "metres_per_pulse 2e-5\n"
    "volts_per_newton 0.1\n"
    "tension 0.4 15\n";

// The X3R before its turn, as its table has it.
const std::string kStrings =
    "left_handed\n"
    "string -0.06 -0.076  0.06  -0.0225 0 0\n"
    "string  0.06 -0.076  0.06   0.0225 0 0\n"
    "string  0.06 -0.076 -0.06   0 -0.0225 0  -1\n"
    "string -0.06 -0.076 -0.06   0 -0.0225 0  -1\n"
    "string -0.06  0.076  0.06  -0.0225 0 0  -1\n"
    "string  0.06  0.076  0.06   0.0225 0 0  -1\n"
    "string  0.06  0.076 -0.06   0 0.0225 0\n"
    "string -0.06  0.076 -0.06   0 0.0225 0  1\n";

class SpidarFile : public ::testing::Test {
 protected:
  ~SpidarFile() override { std::filesystem::remove(file_); }

  SpidarGeometry read(const std::string& text) const {
    std::ofstream(file_) << text;
    return read_spidar_file(file_);
  }

  std::string refusal(const std::string& text) const {
    try {
      read(text);
    } catch (const SpidarFileError& error) {
      return error.what();
    }
    return "accepted";
  }

  std::filesystem::path file_ =
      std::filesystem::path(::testing::TempDir()) /
      (std::string("spidar_") + ::testing::UnitTest::GetInstance()->current_test_info()->name() + ".txt");
};

TEST_F(SpidarFile, IsReadWithItsNumbersAndItsFrame) {
  const SpidarGeometry geometry = read(kHead + kStrings);
  EXPECT_EQ(geometry.name, "ours");
  EXPECT_EQ(geometry.axial_stiffness, 5000.0);
  EXPECT_EQ(geometry.strings[0].motor_S, Vector3(-0.06, 0.06, -0.076));
  EXPECT_EQ(geometry.strings[6].knot_G, Vector3(0.0, 0.0, 0.0225));
  EXPECT_EQ(geometry.strings[1].metres_per_pulse, 2e-5);
  EXPECT_EQ(geometry.strings[2].metres_per_pulse, -2e-5);
  EXPECT_EQ(geometry.strings[7].metres_per_pulse, 2e-5);
  EXPECT_EQ(geometry.strings[7].volts_per_newton, 0.1);
  EXPECT_EQ(geometry.strings[7].min_tension, 0.4);
  EXPECT_EQ(geometry.strings[7].max_tension, 15.0);
}

TEST_F(SpidarFile, WithoutItsOwnNameHasTheFiles) {
  EXPECT_EQ(read(kNumbers + kStrings).name, "spidar_WithoutItsOwnNameHasTheFiles");
}

TEST_F(SpidarFile, FaultsAreNamedWithFileLineAndMend) {
  const std::string file = file_.string();
  EXPECT_EQ(refusal("\nlengths 1\n"),
            file +
                ":2: there is no word 'lengths'; there are: name, metres_per_pulse, volts_per_newton, tension, "
                "axial_stiffness, left_handed, string.");
  EXPECT_EQ(refusal("tension 1\n"),
            file + ":1: 'tension' needs two numbers; write 'tension LEAST GREATEST', in newtons.");
  EXPECT_EQ(refusal("tension 0.3 20N\n"), file + ":1: '20N' is not a finite number; write it as 0.05 or 5e-2.");
  EXPECT_EQ(refusal("metres_per_pulse nan\n"), file + ":1: 'nan' is not a finite number; write it as 0.05 or 5e-2.");
  EXPECT_EQ(refusal("axial_stiffness\n"),
            file + ":1: 'axial_stiffness' needs one number; write 'axial_stiffness NUMBER'.");
  EXPECT_EQ(refusal("string 1 2 3\n"),
            file +
                ":1: 'string' needs 6 or 7 numbers and has 3; write 'string X Y Z KX KY KZ SIGN': motor and knot in "
                "metres, 1 or -1.");
  EXPECT_EQ(refusal(kNumbers + "string 1 2 3 4 5 5 2\n"),
            file + ":4: the sign of a count must be 1 or -1 (the count falls as the string grows longer).");
  EXPECT_EQ(refusal("name\n"), file + ":1: 'name' needs a name; write 'name NAME'.");
  EXPECT_EQ(refusal("name a b\n"), file + ":1: 'b' is too much on this line; remove it.");
  EXPECT_EQ(refusal(kNumbers + "string 1 2 3 4 5 5\n"),
            file + ": it has 1 strings and a SPIDAR-G6 has 8; add a line 'string' for each.");
  EXPECT_EQ(refusal(kNumbers + kStrings + "string 1 2 3 4 5 5\n"),
            file + ":13: this is the ninth string, and a SPIDAR-G6 has 8; remove one.");
}

TEST_F(SpidarFile, AFileThatIsNotThereOrAFolderIsNamed) {
  for (const std::string& name : {std::string("no/such.txt"), ::testing::TempDir()}) {
    try {
      read_spidar_file(name);
      FAIL() << name;
    } catch (const SpidarFileError& error) {
      EXPECT_EQ(std::string(error.what()),
                name + ": no such file, or it may not be read; name a file with a SPIDAR's geometry.");
    }
  }
}

TEST_F(SpidarFile, AGeometryWithoutForceClosureIsRefusedWithTheFile) {
  // All knots at the grip's origin turn nothing.
  std::string knotted = kNumbers + kStrings;
  for (std::size_t at = 0; (at = knotted.find("0.0225", at)) != std::string::npos; at += 6) {
    knotted.replace(at, 6, "0.0000");
  }
  const std::string sentence = refusal(knotted);
  EXPECT_EQ(sentence.find(file_.string() + ": "), 0U) << sentence;
  EXPECT_NE(sentence.find("knots"), std::string::npos) << sentence;
}

TEST_F(SpidarFile, WordsThatWouldHoldForNothingAreRefused) {
  EXPECT_NE(refusal(kHead + kStrings + "tension 0.3 2\n").find(":16: 'tension' holds for the strings below it"),
            std::string::npos)
      << refusal(kHead + kStrings + "tension 0.3 2\n");
  EXPECT_NE(refusal("name ours\n" + kStrings).find("above the first string"), std::string::npos);
}

TEST_F(SpidarFile, NumbersInAnotherUnitAreRefused) {
  for (const std::string line : {"metres_per_pulse 2e-2", "metres_per_pulse -2e-5", "tension 0.3 2000", "tension 5 2",
                                 "string 60 -76 60  -22.5 0 0", "name ../ours"}) {
    std::string text = kHead;
    text.append(line).append("\n").append(kStrings);
    EXPECT_NE(refusal(text).find(":7: "), std::string::npos) << line;
  }
}

}  // namespace
}  // namespace tegotae
