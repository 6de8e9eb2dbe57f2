// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/guard_process.hpp>

#include <tests/device/waiting.hpp>

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <thread>

namespace tegotae {
namespace {

std::atomic<int> tries{0};
std::atomic<int> tries_needed{1};

bool silence_after_some_tries(std::string_view options) noexcept { return options == "7" && ++tries >= tries_needed; }

InterfaceDriver driver() {
  InterfaceDriver made = {"double", "a double", "", "the guard.", nullptr, nullptr, &silence_after_some_tries};
  return made;
}

struct GuardsFile {
  GuardsFile() { close(mkstemp(path.data())); }
  GuardsFile(const GuardsFile&) = delete;
  GuardsFile& operator=(const GuardsFile&) = delete;
  ~GuardsFile() { unlink(path.c_str()); }
  std::string text() const {
    std::ifstream file(path);
    return {std::istreambuf_iterator<char>(file), {}};
  }
  std::string path = (std::filesystem::temp_directory_path() / "tegotae-guard-XXXXXX").string();
};

// The guard on a thread of its own, at one end of a socket.
struct Guard {
  explicit Guard(int needed, double patience = 60.0, RescueTime rescue = RescueTime::kAfterDeath, pid_t process = 0) {
    tries = 0;
    tries_needed = needed;
    EXPECT_EQ(socketpair(AF_UNIX, SOCK_STREAM, 0, ends), 0);
    const GuardedProcess guarded{ends[1], process, &heart, rescue, patience};
    thread = std::thread([this, guarded] { end = guard_interface(driver(), "7", guarded); });
  }
  Guard(const Guard&) = delete;
  Guard& operator=(const Guard&) = delete;
  ~Guard() {
    if (thread.joinable()) thread.join();
    ::close(ends[1]);
  }
  GuardEnd after_close() {
    ::close(ends[0]);
    thread.join();
    return end;
  }

  Heartbeat heart;
  int ends[2] = {-1, -1};
  GuardEnd end = GuardEnd::kFailed;
  std::thread thread;
};

TEST(GuardProcess, FarewellLeavesTheInterfaceAlone) {
  Guard guard(1);
  EXPECT_EQ(write(guard.ends[0], "f", 1), 1);
  EXPECT_EQ(guard.after_close(), GuardEnd::kFarewell);
  EXPECT_EQ(tries, 0);
}

TEST(GuardProcess, AnEndWithoutFarewellSilences) {
  Guard guard(1);
  EXPECT_EQ(guard.after_close(), GuardEnd::kSilenced);
  EXPECT_EQ(tries, 1);
}

TEST(GuardProcess, AnotherWordIsNoFarewell) {
  Guard guard(1);
  EXPECT_EQ(write(guard.ends[0], "x", 1), 1);
  EXPECT_EQ(guard.after_close(), GuardEnd::kSilenced);
}

TEST(GuardProcess, TriesAgainWhileTheDeviceIsHeld) {
  Guard guard(5);
  EXPECT_EQ(guard.after_close(), GuardEnd::kSilenced);
  EXPECT_EQ(tries, 5);
}

TEST(GuardProcess, SaysWhereItCouldNot) {
  Guard guard(1'000'000, 0.05);
  EXPECT_EQ(guard.after_close(), GuardEnd::kFailed);
  EXPECT_GE(tries, 1);
}

TEST(GuardProcess, IsStartedWithTheSocketAsInputAndEndsWithItsOwner) {
  pid_t pid = 0;
  {
    GuardProcess guard({"/bin/sh", {"-c", "cat >/dev/null"}});
    pid = guard.pid();
    EXPECT_FALSE(guard.has_ended());
    EXPECT_EQ(kill(pid, 0), 0);
    EXPECT_EQ(getsid(pid), pid) << "signals of the terminal are not for it";
  }
  EXPECT_EQ(kill(pid, 0), -1) << "waited for";
}

TEST(GuardProcess, OneThatHangsIsEndedWithItsOwner) {
  pid_t pid = 0;
  {
    GuardProcess guard({"/bin/sleep", {"1000"}});
    pid = guard.pid();
  }
  EXPECT_EQ(kill(pid, 0), -1) << "waited for";
}

TEST(GuardProcess, AProgramThatIsNotThereIsRefused) {
  EXPECT_THROW(GuardProcess({"/no/such/program", {}}), InterfaceError);
}

TEST(GuardProcess, HoldsNoFileOfItsOwnersButSocketAndHeartbeat) {
  const HeartbeatMemory heart;
  const int leaking = dup(STDOUT_FILENO);  // as a maker's library may keep one, without the flag that closes it
  ASSERT_GT(leaking, kGuardHeartbeat);
  const GuardsFile seen;
  GuardProcess guard({"/bin/sh", {"-c", "ls /proc/$$/fd > " + seen.path + "; cat >/dev/null"}, heart.descriptor()});
  ASSERT_TRUE(test::comes_true([&] { return std::filesystem::file_size(seen.path) > 0; }));
  const std::string list = seen.text();
  EXPECT_NE(list.find("\n3\n"), std::string::npos) << list;
  EXPECT_EQ(list.find("\n" + std::to_string(leaking) + "\n"), std::string::npos) << list;
  close(leaking);
}

TEST(GuardProcess, NoticesOneThatWasEndedOrStopped) {
  for (const int signal : {SIGKILL, SIGSTOP}) {
    GuardProcess guard({"/bin/sh", {"-c", "cat >/dev/null"}});
    kill(guard.pid(), signal);
    EXPECT_TRUE(test::comes_true([&] { return guard.has_ended(); })) << signal;
    EXPECT_EQ(kill(guard.pid(), 0), -1) << "it is gone";
  }
}

// As where a maker's library forked off a process, which has all that was open.
TEST(GuardProcess, ADeathIsSeenAlsoWhereAnotherHoldsTheSocket) {
  const pid_t child = fork();
  if (child == 0) {
    pause();
    _exit(0);
  }
  Guard guard(1, 60.0, RescueTime::kAfterDeath, child);
  kill(child, SIGKILL);
  EXPECT_TRUE(test::comes_true([] { return tries == 1; }));
  EXPECT_EQ(guard.after_close(), GuardEnd::kSilenced);
  EXPECT_EQ(waitpid(child, nullptr, 0), child);
}

// While the guarded process lives: nobody beats and a force is displayed.
TEST(GuardProcess, AHeartThatStandsIsSilencedWhereTwoMayOpenTheDevice) {
  Guard guard(1, 60.0, RescueTime::kAnyTime);
  guard.heart.displays = true;
  EXPECT_TRUE(test::comes_true([] { return tries >= 3; })) << "a command that was on its way may come after the first";
  EXPECT_EQ(write(guard.ends[0], "f", 1), 1);
  EXPECT_EQ(guard.after_close(), GuardEnd::kFarewell);
}

TEST(GuardProcess, AHeartThatStandsAtZeroIsLeftAlone) {
  Guard guard(1, 60.0, RescueTime::kAnyTime);
  std::this_thread::sleep_for(std::chrono::duration<double>(3.0 * Standstill::kLongest));
  EXPECT_EQ(write(guard.ends[0], "f", 1), 1);
  EXPECT_EQ(guard.after_close(), GuardEnd::kFarewell);
  EXPECT_EQ(tries, 0);
}

// Nobody else can open its device: it must say zero itself.
TEST(GuardProcess, AProcessThatWasStoppedWithAForceGoesOn) {
  GuardProcess stopped({"/bin/sh", {"-c", "cat >/dev/null"}});
  Guard guard(1, 60.0, RescueTime::kAfterDeath, stopped.pid());
  const auto is_stopped = [&] {
    std::ifstream file("/proc/" + std::to_string(stopped.pid()) + "/stat");
    std::string text;
    std::getline(file, text);
    return text.find(") T ") != std::string::npos;
  };
  kill(stopped.pid(), SIGSTOP);
  ASSERT_TRUE(test::comes_true(is_stopped));
  guard.heart.displays = true;
  EXPECT_TRUE(test::comes_true([&] { return !is_stopped(); }));
  EXPECT_EQ(write(guard.ends[0], "f", 1), 1);
  EXPECT_EQ(guard.after_close(), GuardEnd::kFarewell);
  EXPECT_EQ(tries, 0);
}

}  // namespace
}  // namespace tegotae
