// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/child_process.hpp>
#include <tegotae/lab/figure.hpp>
#include <tegotae/lab/input_error.hpp>
#include <tegotae/lab/quantities.hpp>
#include <tegotae/math/rotation.hpp>
#include <tests/lab/svg_texts.hpp>
#include <tests/lab/temporary_folder.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace tegotae {
namespace {

using testing::HasSubstr;

std::vector<TickRecord> turning_ticks() {
  std::vector<TickRecord> records(500);
  for (size_t i = 0; i < records.size(); ++i) {
    const double time = static_cast<double>(i) * 1e-3;
    records[i].time = time;
    records[i].X_WT = Pose{{0.0, time, 0.0}, rotation_from_vector(-time * Vector3::UnitZ())};
    records[i].wrench = Wrench{{1.0, std::sin(20.0 * time), 3.0}, {4.0, 5.0, 6.0}};
  }
  return records;
}

Figure two_panels() {
  Figure figure;
  figure.name = "both";
  figure.title = "A title";
  figure.panels = {{"y [m]", {{"y", 0, position_along(Vector3::UnitY()), false}}},
                   {"f_y [N]",
                    {{"rendered", 0, force_along(Vector3::UnitY()), false},
                     {"closed form", 0, force_along(Vector3::UnitX()), true}}}};
  return figure;
}

TEST(Quantities, ReadCoordinatesOfATick) {
  const TickRecord record = turning_ticks()[250];
  const SessionSettings settings;
  EXPECT_EQ(position_along(Vector3::UnitY())(record, settings), 0.25);
  EXPECT_NEAR(angle_about(Vector3::UnitZ())(record, settings), -0.25 * 180.0 / std::numbers::pi, 1e-12);
  EXPECT_EQ(force_along(Vector3::UnitZ())(record, settings), 3.0);
  EXPECT_EQ(torque_along(Vector3::UnitX())(record, settings), 4.0);
}

TEST(Figures, AreDrawnInBothFormatsWithLabelledAxes) {
  const TemporaryFolder folder;
  const std::vector<TickRecord> records = turning_ticks();
  const SessionSettings settings;
  draw(two_panels(), std::vector<RunSamples>{{records, settings}}, folder.path());
  const std::string svg = contents_of(folder.path() / "both.svg");
  for (const char* text : {"A title", "time [s]", "y [m]", "[N]", "closed form", "</svg>"}) {
    EXPECT_THAT(svg, HasSubstr(text));
  }
  EXPECT_EQ(contents_of(folder.path() / "both.png").substr(1, 3), "PNG");
  EXPECT_LT(svg.size(), 300000U);
}

TEST(Figures, RepeatBitForBit) {
  const TemporaryFolder folder;
  const std::vector<TickRecord> records = turning_ticks();
  const SessionSettings settings;
  for (const char* name : {"first", "second"}) {
    draw(two_panels(), std::vector<RunSamples>{{records, settings}}, folder.path() / name);
  }
  EXPECT_EQ(contents_of(folder.path() / "first" / "both.svg"), contents_of(folder.path() / "second" / "both.svg"));
}

TEST(Figures, LeaveAGapWhereThereIsNoNumberAndBeginALogarithmicAxisWhereItIsSaid) {
  const TemporaryFolder folder;
  const std::vector<TickRecord> records = turning_ticks();
  const SessionSettings settings;
  Figure figure{.name = "gap", .title = "A gap"};
  const Quantity with_gap = [](const TickRecord& record, const SessionSettings&) {
    return record.time > 0.1 && record.time < 0.2 ? std::nan("") : record.time;
  };
  figure.panels = {{"t [s]", {{"", 0, with_gap, false}}, 0.25}};
  draw(figure, std::vector<RunSamples>{{records, settings}}, folder.path());
  const std::string data = contents_of(folder.path() / "gap.dat");
  EXPECT_THAT(data, HasSubstr("\n0.1 0.25\n\n0.2 0.25\n"));
  EXPECT_THAT(data, HasSubstr("\n0.3 0.3\n"));
  EXPECT_THAT(contents_of(folder.path() / "gap.gnuplot"), HasSubstr("set yrange [0.25:*]"));
}

TEST(Figures, HaveTheRangeThatIsSaidInItsPanelAlone) {
  const TemporaryFolder folder;
  const std::vector<TickRecord> records = turning_ticks();
  const SessionSettings settings;
  Figure figure = two_panels();
  figure.panels[0].bottom = -0.5;
  figure.panels[0].top = 2.5;
  draw(figure, std::vector<RunSamples>{{records, settings}}, folder.path());
  const std::string script = contents_of(folder.path() / "both.gnuplot");
  const size_t set = script.find("set yrange [-0.5:2.5]"), freed = script.find("set yrange [*:*]", set);
  ASSERT_NE(set, std::string::npos);
  EXPECT_LT(set, script.find("set ylabel \"y [m]\""));
  EXPECT_LT(freed, script.find("set ylabel \"f_y [N]\""));
}

// Whatever stands in a title; a name of a file may be one long word.
TEST(Figures, LetNoTextLeaveThePicture) {
  const std::vector<TickRecord> records = turning_ticks();
  const SessionSettings settings;
  const std::string words = "From the edge to the face at constant depth (method proxy) (on spidar-g6:x3r,simulated) ";
  for (const std::string& title : {words + words, std::string(200, 'W'), std::string("short")}) {
    const TemporaryFolder folder;
    Figure figure = two_panels();
    figure.title = title;
    figure.panels[1].label = "|displayed - commanded| [mN m]";
    draw(figure, std::vector<RunSamples>{{records, settings}}, folder.path());
    const std::string svg = contents_of(folder.path() / "both.svg");
    EXPECT_THAT(texts_outside(svg), testing::IsEmpty());
    EXPECT_TRUE(shows_text(svg, "time [s]"));
  }
  EXPECT_THAT(texts_outside("<svg width=\"100\" height=\"50\">"
                            "<g transform=\"translate(50.0,20.0)\" font-size=\"14.00\"  text-anchor=\"middle\">\n"
                            "<text><tspan>as wide as two</tspan></text>"),
              testing::ElementsAre("as wide as two"));
}

// Where a reference is drawn over what it is the reference of, both are seen: the one below is the wider.
TEST(Figures, DrawAReferenceThinOverAWideCurve) {
  const TemporaryFolder folder;
  const std::vector<TickRecord> records = turning_ticks();
  const SessionSettings settings;
  Figure figure = two_panels();
  draw(figure, std::vector<RunSamples>{{records, settings}}, folder.path());
  const std::string script = contents_of(folder.path() / "both.gnuplot");
  const size_t wide = script.find("index 1 with lines lw 5"), thin = script.find("index 2 with lines lw 1.5 dt");
  ASSERT_NE(wide, std::string::npos);
  EXPECT_LT(wide, thin);
  EXPECT_THAT(script, HasSubstr("index 0 with lines lw 2 lt 1"));
}

TEST(Figures, HaveAsManyPointsOfAShortPartAsOfAWholeRun) {
  const TemporaryFolder folder;
  const std::vector<TickRecord> records = turning_ticks();
  const SessionSettings settings;
  Figure figure{.name = "part", .title = "A part"};
  const Quantity of_part = [](const TickRecord& record, const SessionSettings&) {
    return record.time < 0.1 ? std::sin(1e3 * record.time) : std::nan("");
  };
  figure.panels = {{"t [s]", {{"", 0, of_part, false}}}};
  draw(figure, std::vector<RunSamples>{{records, settings}}, folder.path());
  const std::string data = contents_of(folder.path() / "part.dat");
  EXPECT_GE(std::count(data.begin(), data.end(), '\n'), 100);
}

TEST(Figures, SayWhereTheyCannotBeWritten) {
  const TemporaryFolder folder;
  const std::string file = folder.write("occupied", "");
  const std::vector<TickRecord> records = turning_ticks();
  const SessionSettings settings;
  EXPECT_THAT(
      [&] {
        draw(two_panels(), std::vector<RunSamples>{{records, settings}}, file);
      },
      testing::ThrowsMessage<InputError>(HasSubstr("occupied")));
}

TEST(ChildProcess, GivesTheExitCode) {
  EXPECT_EQ(run_child({"true"}, "/").exit_code, 0);
  EXPECT_EQ(run_child({"sh", "-c", "exit 7"}, "/").exit_code, 7);
  EXPECT_EQ(run_child({"sh", "-c", "kill -9 $$"}, "/").exit_code, 128 + 9);
}

TEST(ChildProcess, RunsInTheFolder) {
  const TemporaryFolder folder;
  EXPECT_EQ(run_child({"sh", "-c", "echo here > written"}, folder.path()).exit_code, 0);
  EXPECT_EQ(contents_of(folder.path() / "written"), "here\n");
}

TEST(ChildProcess, TellsAProgramThatIsNotThere) {
  EXPECT_TRUE(run_child({"no-such-program-anywhere"}, "/").not_found);
  EXPECT_FALSE(run_child({"true"}, "/").not_found);
}

}  // namespace
}  // namespace tegotae
