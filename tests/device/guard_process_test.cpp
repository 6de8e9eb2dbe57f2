// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/guard_process.hpp>

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <atomic>
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

// The guard on a thread of its own, at one end of a socket.
struct Guard {
  explicit Guard(int needed, double patience = 60.0) {
    tries = 0;
    tries_needed = needed;
    EXPECT_EQ(socketpair(AF_UNIX, SOCK_STREAM, 0, ends), 0);
    thread = std::thread([this, patience] { end = guard_interface(driver(), "7", ends[1], patience); });
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
    const GuardProcess guard("/bin/sh", {"-c", "cat >/dev/null"});
    pid = guard.pid();
    EXPECT_EQ(kill(pid, 0), 0);
    EXPECT_EQ(getsid(pid), pid) << "signals of the terminal are not for it";
  }
  EXPECT_EQ(kill(pid, 0), -1) << "waited for";
}

TEST(GuardProcess, AProgramThatIsNotThereIsRefused) {
  EXPECT_THROW(GuardProcess("/no/such/program", {}), InterfaceError);
}

}  // namespace
}  // namespace tegotae
