// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/heartbeat.hpp>
#include <tegotae/device/interface_driver.hpp>

#include <tests/allocation_counter.hpp>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

namespace tegotae {
namespace {

/// Takes commands, or does not; says what the heart was in the middle of the last one.
class WatchedInterface final : public HapticInterface {
 public:
  explicit WatchedInterface(const Heartbeat& heart) : heart_(heart) {}
  InterfaceCapability capability() const override { return {"watched"}; }
  InterfaceStatus read(double time, InterfaceState& state) noexcept override {
    state.time = time - 1.0;
    return InterfaceStatus::kOk;
  }
  InterfaceStatus write(const InterfaceCommand& command) noexcept override {
    last = command;
    displayed_meanwhile = heart_.displays;
    return answer;
  }

  InterfaceCommand last;
  bool displayed_meanwhile = false;
  InterfaceStatus answer = InterfaceStatus::kOk;

 private:
  const Heartbeat& heart_;
};

InterfaceCommand heart_push(double force) { return {{{force, 0.0, 0.0}, Vector3::Zero()}, 0.0}; }

class BeatingInterfaceTest : public ::testing::Test {
 protected:
  Heartbeat heart;
  WatchedInterface device{heart};
  BeatingInterface beating{device, heart};
};

TEST_F(BeatingInterfaceTest, PassesEverythingOn) {
  InterfaceState state;
  EXPECT_EQ(beating.capability().name, "watched");
  EXPECT_EQ(beating.read(3.0, state), InterfaceStatus::kOk);
  EXPECT_EQ(state.time, 2.0);
  EXPECT_EQ(beating.write(heart_push(2.0)), InterfaceStatus::kOk);
  EXPECT_EQ(device.last.wrench.force.x(), 2.0);
  device.answer = InterfaceStatus::kLost;
  EXPECT_EQ(beating.write(heart_push(2.0)), InterfaceStatus::kLost);
}

TEST_F(BeatingInterfaceTest, BeatsWithEachCommandWhateverCameOfIt) {
  beating.write({});
  beating.write(heart_push(1.0));
  device.answer = InterfaceStatus::kLost;
  beating.write(heart_push(1.0));
  EXPECT_EQ(heart.beats, 3U);
}

TEST_F(BeatingInterfaceTest, TellsThePeriodUpToThatOfTheSlowestHaptics) {
  InterfaceState state;
  beating.read(3.0, state);
  beating.read(3.02, state);
  EXPECT_NEAR(heart.period, 0.02, 1e-12);
  beating.read(9.0, state);
  EXPECT_EQ(heart.period, Heartbeat::kSlowest) << "after a standstill";
  beating.read(8.0, state);
  EXPECT_EQ(heart.period, 0.0) << "a clock that goes back";
}

// A call may hang, either way: then the device displays what it displayed, or what it was told.
TEST_F(BeatingInterfaceTest, DisplaysFromBeforeTheFirstForceUntilAfterAZeroThatWasTaken) {
  beating.write({});
  EXPECT_FALSE(device.displayed_meanwhile);
  beating.write(heart_push(1.0));
  EXPECT_TRUE(device.displayed_meanwhile);
  device.answer = InterfaceStatus::kLost;
  beating.write({});
  EXPECT_TRUE(device.displayed_meanwhile);
  EXPECT_TRUE(heart.displays) << "it was not taken";
  device.answer = InterfaceStatus::kOk;
  beating.write({});
  EXPECT_TRUE(device.displayed_meanwhile);
  EXPECT_FALSE(heart.displays);
}

TEST_F(BeatingInterfaceTest, ATorqueOrAGripperForceIsNoZero) {
  beating.write({{Vector3::Zero(), {0.0, 1e-9, 0.0}}, 0.0});
  EXPECT_TRUE(heart.displays);
  beating.write({});
  EXPECT_FALSE(heart.displays);
  beating.write({{}, 0.1});
  EXPECT_TRUE(heart.displays);
}

TEST_F(BeatingInterfaceTest, AllocatesNothing) {
  InterfaceState state;
  const test::AllocationCounter allocations;
  for (int i = 0; i < 100; ++i) {
    beating.read(1e-3 * i, state);
    beating.write(heart_push(i % 2));
  }
  EXPECT_EQ(allocations.count(), 0U);
}

TEST(Standstill, IsAForceThatNobodyRenews) {
  Heartbeat heart;
  heart.displays = true;
  Standstill standstill;
  EXPECT_FALSE(standstill.see(5.0, heart)) << "the first look tells nothing";
  EXPECT_FALSE(standstill.see(5.0 + 0.9 * Standstill::kLongest, heart));
  EXPECT_TRUE(standstill.see(5.0 + 1.1 * Standstill::kLongest, heart));
  ++heart.beats;
  EXPECT_FALSE(standstill.see(6.0, heart));
  EXPECT_FALSE(standstill.see(6.0 + 0.9 * Standstill::kLongest, heart));
}

TEST(Standstill, WaitsForTheTicksOfSlowHaptics) {
  Heartbeat heart;
  heart.displays = true;
  heart.period = Heartbeat::kSlowest;
  const double patience = Standstill::kPeriods * Heartbeat::kSlowest;
  Standstill standstill;
  EXPECT_FALSE(standstill.see(5.0, heart));
  EXPECT_FALSE(standstill.see(5.0 + 0.9 * patience, heart));
  EXPECT_TRUE(standstill.see(5.0 + 1.1 * patience, heart));
}

TEST(Standstill, CountsFromWhenTheForceBegan) {
  Heartbeat heart;
  Standstill standstill;
  EXPECT_FALSE(standstill.see(0.0, heart));
  EXPECT_FALSE(standstill.see(9.0, heart));
  heart.displays = true;
  EXPECT_FALSE(standstill.see(9.0 + 0.9 * Standstill::kLongest, heart));
  EXPECT_TRUE(standstill.see(9.0 + 1.1 * Standstill::kLongest, heart));
}

TEST(HeartbeatMemory, IsSeenByAnotherProcess) {
  const HeartbeatMemory memory;
  const pid_t child = fork();
  if (child == 0) {
    const HeartbeatMemory inherited(memory.descriptor());
    inherited->beats = 42;
    inherited->displays = true;
    _exit(0);
  }
  int status = -1;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_EQ(memory->beats, 42U);
  EXPECT_TRUE(memory->displays);
}

// Standard error would write into it, and a guard finds its socket where standard input was.
TEST(HeartbeatMemory, TakesNoStandardDescriptorThatIsClosed) {
  const pid_t child = fork();
  if (child == 0) {
    for (int i = STDIN_FILENO; i <= STDERR_FILENO; ++i) close(i);
    const HeartbeatMemory memory;
    memory->beats = 42;
    _exit(memory.descriptor() > STDERR_FILENO && fcntl(STDIN_FILENO, F_GETFD) < 0 && memory->beats == 42 ? 0 : 1);
  }
  int status = -1;
  ASSERT_EQ(waitpid(child, &status, 0), child);
  EXPECT_EQ(status, 0);
}

TEST(HeartbeatMemory, ADescriptorOfSomethingElseIsRefused) {
  EXPECT_THROW(HeartbeatMemory(STDIN_FILENO), InterfaceError);
  EXPECT_THROW(HeartbeatMemory(-1), InterfaceError);
}

}  // namespace
}  // namespace tegotae
