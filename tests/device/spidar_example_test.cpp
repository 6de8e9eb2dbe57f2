// SPDX-License-Identifier: Apache-2.0
// examples/spidar_board.c as a person's own library: compiled, loaded by the driver, and spoken to by a board at the
// other end of its port.
#include <tegotae/device/spidar_driver.hpp>

#include <tests/device/refusal.hpp>
#include <tests/device/waiting.hpp>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <thread>

namespace tegotae {
namespace {

constexpr const char* kExampleLibrary = TEGOTAE_DOUBLES "/spidar-example/libmyboard.so";
constexpr double kNewtonsPerAmpere = 0.0438 / 0.008;

// A board that speaks the example's packets on a pseudo terminal: its counts stand at zero.
class MadeUpBoard {
 public:
  MadeUpBoard() : master_(posix_openpt(O_RDWR | O_NOCTTY)) {
    EXPECT_EQ(grantpt(master_), 0);
    EXPECT_EQ(unlockpt(master_), 0);
    port = ptsname(master_);                        // NOLINT(concurrency-mt-unsafe)
    hold_ = open(port.c_str(), O_RDWR | O_NOCTTY);  // without it the terminal hangs up between two openings
    termios mode{};
    tcgetattr(hold_, &mode);
    cfmakeraw(&mode);
    tcsetattr(hold_, TCSANOW, &mode);
    thread_ = std::thread([this] { serve(); });
  }
  MadeUpBoard(const MadeUpBoard&) = delete;
  MadeUpBoard& operator=(const MadeUpBoard&) = delete;
  ~MadeUpBoard() {
    ends_ = true;
    thread_.join();
    close(hold_);
    close(master_);
  }

  std::string port;
  std::atomic<bool> answers{true};
  std::atomic<int> resets{0}, packets{0};
  std::array<std::atomic<float>, 8> amperes{};

 private:
  bool take(void* into, std::size_t size) {
    for (std::size_t got = 0; got < size;) {
      pollfd ready{master_, POLLIN, 0};
      if (ends_) return false;
      if (poll(&ready, 1, 10) <= 0) continue;
      const ssize_t more = read(master_, static_cast<char*>(into) + got, size - got);
      if (more > 0) got += static_cast<std::size_t>(more);
    }
    return true;
  }
  void serve() {
    for (char word = 0; take(&word, 1);) {
      if (word == 'z') ++resets;
      if (word == 'r' && answers) {
        const std::array<std::int32_t, 8> counts{};
        EXPECT_EQ(write(master_, counts.data(), sizeof counts), static_cast<ssize_t>(sizeof counts));
      }
      std::array<float, 8> told{};
      if (word != 'w' || !take(told.data(), sizeof told)) continue;
      for (std::size_t i = 0; i < told.size(); ++i) amperes[i] = told[i];
      ++packets;
    }
  }

  int master_, hold_ = -1;
  std::atomic<bool> ends_{false};
  std::thread thread_;
};

std::string example_options(const std::string& port) {
  return std::string("x3r,hold=0,transport=") + kExampleLibrary + ",board=" + port;
}

TEST(SpidarExample, DrivesABoardThroughTheDriver) {
  MadeUpBoard board;
  const auto amperes = [&](float wanted) {
    return test::comes_true([&] { return std::abs(board.amperes[0] - wanted) < 1e-6F; });
  };
  const auto least = static_cast<float>(0.3 / kNewtonsPerAmpere);
  {
    const auto interface = spidar_driver().open(example_options(board.port));
    EXPECT_TRUE(test::comes_true([&] { return board.resets == 1; }));
    EXPECT_TRUE(amperes(least));
    InterfaceState state;
    // A packet may come late on a busy machine.
    ASSERT_TRUE(test::comes_true([&] { return interface->read(0.0, state) == InterfaceStatus::kOk; }));
    EXPECT_LT(state.X_WT.p.norm(), 1e-9);
    EXPECT_TRUE(test::comes_true([&] {
      interface->read(0.0, state);
      interface->write({{{0.0, 0.0, 5.0}, Vector3::Zero()}, 0.0});
      float greatest = 0.0F;
      for (const auto& each : board.amperes) greatest = std::max(greatest, each.load());
      return greatest > 3.0F * least;
    }));
  }
  EXPECT_TRUE(amperes(0.0F)) << "closed";
}

TEST(SpidarExample, AnotherProcessMayStopItsMotors) {
  const MadeUpBoard board;
  EXPECT_EQ(rescue_of(spidar_driver(), example_options(board.port)).time, RescueTime::kAnyTime);
  EXPECT_TRUE(spidar_driver().silence(example_options(board.port)));
  EXPECT_TRUE(test::comes_true([&] { return board.packets == 1; }));
}

TEST(SpidarExample, APortThatIsNoneAndABoardThatIsSilentAreRefusedWithItsWords) {
  EXPECT_THAT(test::refusal([] { spidar_driver().open(example_options("/none")); }),
              ::testing::HasSubstr("'/none' cannot be opened (No such file or directory)"));
  MadeUpBoard board;
  board.answers = false;
  EXPECT_THAT(test::refusal([&] { spidar_driver().open(example_options(board.port)); }),
              ::testing::HasSubstr("the board does not answer (the board did not answer in time)"));
}

}  // namespace
}  // namespace tegotae
