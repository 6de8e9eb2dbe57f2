// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/interface_drivers.hpp>
#include <tegotae/lab/playback_driver.hpp>
#include <tests/lab/program_run.hpp>
#include <tests/lab/recorded_run.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

namespace tegotae {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::StartsWith;
using ::testing::ThrowsMessage;

Pose read(HapticInterface& interface, double time) {
  InterfaceState state;
  EXPECT_EQ(interface.read(time, state), InterfaceStatus::kOk);
  EXPECT_EQ(state.time, time);
  return state.X_WT;
}

TEST(PlaybackDriver, PlaysATrajectoryFromItsStartAndHoldsItsEnd) {
  const TemporaryFolder folder;
  const std::string file = folder.write("a:motion,2.csv",
                                        "t,x,y,z,qw,qx,qy,qz\n"
                                        "5,0.1,0,0,1,0,0,0\n"
                                        "6,0.3,0,0,1,0,0,0\n");
  const auto interface = playback_driver().open(file);
  EXPECT_EQ(interface->capability().name, "playback");
  EXPECT_DOUBLE_EQ(read(*interface, 0.0).p.x(), 0.1);
  EXPECT_DOUBLE_EQ(read(*interface, 0.5).p.x(), 0.2);
  EXPECT_EQ(interface->write({}), InterfaceStatus::kOk);
  EXPECT_DOUBLE_EQ(read(*interface, 10.0).p.x(), 0.3);
}

TEST(PlaybackDriver, PlaysARecording) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "run.mcap";
  const std::vector<TickRecord> ticks = record_table(file, 0.2);
  ASSERT_GT(ticks.size(), 100U);
  const auto interface = playback_driver().open(file.string());
  for (const std::size_t i : {std::size_t{0}, std::size_t{50}, ticks.size() - 1}) {
    const Pose X_WT = read(*interface, ticks[i].time - ticks.front().time);
    EXPECT_LT((X_WT.p - ticks[i].X_WT.p.vector()).norm(), 1e-9) << i;
  }
}

TEST(PlaybackDriver, RefusesWhatItCannotPlay) {
  const TemporaryFolder folder;
  const auto opened = [](const std::string& file) { static_cast<void>(playback_driver().open(file)); };
  EXPECT_THAT([&] { opened(""); }, ThrowsMessage<InterfaceError>(HasSubstr("playback:FILE")));
  EXPECT_THAT([&] { opened((folder.path() / "none.csv").string()); },
              ThrowsMessage<InterfaceError>(AllOf(StartsWith("playback: "), HasSubstr("none.csv"))));
  const std::string bad = folder.write("bad.csv", "t,x\n0,0\n");
  EXPECT_THAT([&] { opened(bad); }, ThrowsMessage<InterfaceError>(HasSubstr("bad.csv")));
}

TEST(PlaybackDriver, IsAmongThoseThatTheProgramKnows) {
  EXPECT_EQ(known_drivers().size(), interface_drivers().size() + 1);
  EXPECT_EQ(&find_interface_driver("playback", known_drivers()), &playback_driver());
  EXPECT_EQ(&find_interface_driver("openhaptics", known_drivers()), &find_interface_driver("openhaptics"));
  EXPECT_THAT([] { find_interface_driver("gramophone", known_drivers()); },
              ThrowsMessage<InterfaceError>(HasSubstr("playback")));
}

TEST(PlaybackDriver, TheProgramListsItAndRefusesAFileThatIsNotThere) {
  const ProgramResult listed = run_program({"interfaces", "playback"});
  EXPECT_EQ(listed.exit_code, 0);
  EXPECT_THAT(listed.out, AllOf(StartsWith("playback[:FILE]\n"), HasSubstr("displays no force")));
  EXPECT_THAT(run_program({"interfaces"}).out, HasSubstr("\nplayback[:FILE]\n"));
  const ProgramResult missing = run_program({"serve", "--interface", "playback:/none.csv"});
  EXPECT_NE(missing.exit_code, 0);
  EXPECT_THAT(missing.err, AllOf(HasSubstr("tegotae: playback: "), HasSubstr("/none.csv")));
}

}  // namespace
}  // namespace tegotae
