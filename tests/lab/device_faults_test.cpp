// SPDX-License-Identifier: Apache-2.0
#include <tests/doubles/double_state_file.hpp>
#include <tests/lab/started_program.hpp>

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <functional>
#include <optional>
#include <string>
#include <thread>

// The program as a person runs it, driving a device through its maker's C interface, while faults are done to both. The
// device is simulated in this project's own library of that interface, which holds its last force for ever, as the
// worst device would: what brings it to zero is the program, or its guard. Times are printed, not asserted.
namespace tegotae {
namespace {

using test::DoubleState;
using test::DoubleStateFile;

constexpr double kStiffness = 1000.0;                // N/m
constexpr double kLargestForce = 12.0;               // N, of the model
constexpr double kGrowth = 2.0 * kStiffness * 1e-3;  // N a period: a strike at 1 m/s, and as much again
constexpr double kRounding = 1e-9;                   // N

// A ball 5 mm above a floor.
constexpr const char* kScene = R"(<mujoco>
  <option gravity="0 0 -9.81"/>
  <worldbody>
    <geom name="floor" type="plane" size="1 1 0.1"/>
    <body name="tool" pos="0 0 0.025" mocap="true"><geom type="sphere" size="0.02" mass="0.1"/></body>
  </worldbody>
</mujoco>)";

std::int64_t now() {
  timespec time{};
  clock_gettime(CLOCK_MONOTONIC, &time);
  return time.tv_sec * 1'000'000'000LL + time.tv_nsec;
}

bool comes(const std::function<bool()>& what) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(2);
  while (!what()) {
    if (std::chrono::steady_clock::now() > deadline) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

// A device in a hand that presses the ball on the floor with several newtons.
class PressingDevice : public ::testing::Test {
 protected:
  PressingDevice() : PressingDevice("omega.6", "force-dimension", [](DoubleState&) {}) {}
  PressingDevice(const char* model, const std::string& interface, const std::function<void(DoubleState&)>& prepare)
      : device_(model) {
    scene_ = folder_.write("floor.xml", kScene);
    device_.place({Vector3::Zero(), Quaternion::Identity()});
    prepare(*device_);
    program_.emplace(std::vector<std::string>{"serve", scene_, "--interface", interface, "--port", "0", "--stiffness",
                                              "1000", "--physics-rate", "500"},
                     std::vector<std::string>{std::string("LD_LIBRARY_PATH=") + TEGOTAE_DOUBLES + "/force-dimension",
                                              "TEGOTAE_DOUBLE_STATE=" + device_.path()});
  }
  ~PressingDevice() override { program_.reset(); }

  bool press() {
    if (!comes([&] { return device_->command_count > 100; })) return false;
    device_.move_hand({Vector3(0.0, 0.0, -0.03), Quaternion::Identity()});
    return comes([&] { return force() > 2.0; });
  }
  // After a fault nothing is felt before the hand has let go and the ramp of 2 s is over.
  bool let_go_and_press_again() {
    device_.move_hand({Vector3::Zero(), Quaternion::Identity()});
    if (!comes([&] { return device_.pose().p.z() > -1e-3; })) return false;
    const std::uint64_t free = device_->command_count;
    if (!comes([&] { return device_->command_count > free + 2500; })) return false;
    device_.move_hand({Vector3(0.0, 0.0, -0.03), Quaternion::Identity()});
    return comes([&] { return force() > 2.0; });
  }
  double force() const { return device_.displayed().force.norm(); }

  // From `begin` (ns) to the first command of zero after it, in ms.
  std::optional<double> milliseconds_to_zero(std::int64_t begin) const {
    const std::uint64_t count = device_->command_count;
    for (std::uint64_t i = count > DoubleState::kCommands ? count - DoubleState::kCommands : 0; i < count; ++i) {
      const auto& command = device_->commands[i % DoubleState::kCommands];
      if (command.time < begin) continue;
      bool is_zero = true;
      for (const auto* part : {&command.force, &command.torque}) {
        for (const auto& each : *part) is_zero = is_zero && each.load() == 0.0;
      }
      if (is_zero) return 1e-6 * static_cast<double>(command.time - begin);
    }
    return std::nullopt;
  }

  void expect_bounded(const char* fault, std::int64_t begin) {
    EXPECT_LE(device_->largest_force, kLargestForce + kRounding);
    EXPECT_LE(device_->largest_force_growth, kGrowth + kRounding);
    EXPECT_EQ(device_->bad_commands, 0u);
    const auto time = milliseconds_to_zero(begin);
    EXPECT_TRUE(time.has_value()) << "no command of zero came";
    std::printf("%-16s largest force %5.2f N, growth %5.3f N a tick; zero after %.1f ms\n", fault,
                device_->largest_force.load(), device_->largest_force_growth.load(), time.value_or(NAN));
  }

  TemporaryFolder folder_;
  DoubleStateFile device_;
  std::string scene_;
  std::optional<StartedProgram> program_;
};

class EndedPressingDevice : public PressingDevice, public ::testing::WithParamInterface<int> {};

TEST_P(EndedPressingDevice, IsAtZeroWhateverSignalEndsTheProgram) {
  ASSERT_TRUE(press()) << program_->output();
  const int signal = GetParam();
  const std::int64_t begin = now();
  program_->kill(signal);
  EXPECT_TRUE(comes([&] { return force() == 0.0; })) << program_->output();
  program_->wait();
  expect_bounded(strsignal(signal), begin);  // NOLINT(concurrency-mt-unsafe)
  EXPECT_EQ(device_.commanded().force.norm(), 0.0);
}

INSTANTIATE_TEST_SUITE_P(Signals, EndedPressingDevice, ::testing::Values(SIGINT, SIGTERM, SIGHUP, SIGSEGV, SIGKILL),
                         [](const auto& test) { return std::string(sigabbrev_np(test.param)); });

TEST_F(PressingDevice, UnpluggedIsToldZeroAndFeltAgainFromZeroWhenItIsBack) {
  ASSERT_TRUE(press()) << program_->output();
  const std::int64_t begin = now();
  device_.unplug();
  ASSERT_TRUE(comes([&] { return device_->refused_opens > 0; })) << "it is looked for";
  device_.plug_in();
  ASSERT_TRUE(comes([&] { return device_->opens >= 2; })) << program_->output();
  // The hand presses still.
  const std::uint64_t commands = device_->command_count;
  ASSERT_TRUE(comes([&] { return device_->command_count > commands + 200; }));
  EXPECT_EQ(force(), 0.0);
  EXPECT_TRUE(let_go_and_press_again()) << program_->output();
  expect_bounded("unplugged", begin);
  EXPECT_FALSE(program_->has_ended());
}

TEST_F(PressingDevice, CallsThatFailNowAndThenNeverThrowAForce) {
  ASSERT_TRUE(press()) << program_->output();
  const std::int64_t begin = now();
  device_->fail_every = 97;
  const std::uint64_t failed = device_->failed_calls;
  ASSERT_TRUE(comes([&] { return device_->failed_calls > failed + 20; }));
  device_->fail_every = 0;
  expect_bounded("failing calls", begin);
  EXPECT_FALSE(program_->has_ended());
}

TEST_F(PressingDevice, APoseThatIsNoneOrJumpsNeverThrowsAForce) {
  ASSERT_TRUE(press()) << program_->output();
  std::int64_t begin = now();
  device_->nan_pose = true;
  ASSERT_TRUE(comes([&] { return force() == 0.0; })) << program_->output();
  expect_bounded("no pose", begin);
  device_->nan_pose = false;
  ASSERT_TRUE(let_go_and_press_again()) << program_->output();
  begin = now();
  device_->jump[2] = -0.2;
  ASSERT_TRUE(comes([&] { return force() == 0.0; })) << program_->output();
  expect_bounded("jump of 0.2 m", begin);
  EXPECT_FALSE(program_->has_ended());
}

// The child of `parent` that guards its interface, other than `known`; 0: none.
pid_t guard_of(pid_t parent, pid_t known = 0) {
  const std::string guard_word("\0guard\0", 7);
  for (const auto& process : std::filesystem::directory_iterator("/proc")) {
    const std::string name = process.path().filename().string();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    std::ifstream stat(process.path() / "stat"), words(process.path() / "cmdline");
    std::string of_process, command;
    std::getline(stat, of_process);
    std::getline(words, command);
    const std::size_t end = of_process.rfind(") ");
    if (end == std::string::npos || of_process[end + 2] == 'Z') continue;
    const bool is_child = std::stoi(of_process.substr(end + 4)) == parent;
    if (is_child && std::stoi(name) != known && command.find(guard_word) != std::string::npos) {
      return std::stoi(name);
    }
  }
  return 0;
}

TEST_F(PressingDevice, AGuardThatWasEndedIsReplacedSoThatACrashEndsAtZeroAllTheSame) {
  ASSERT_TRUE(press()) << program_->output();
  const pid_t first = guard_of(program_->pid());
  ASSERT_GT(first, 0);
  ::kill(first, SIGKILL);
  ASSERT_TRUE(comes([&] { return guard_of(program_->pid(), first) > 0; }));
  EXPECT_TRUE(comes([&] {
    return program_->output().find(
               "warning: the process that guards the interface was ended by somebody; another was "
               "started") != std::string::npos;
  })) << program_->output();
  // On a busy machine a tick may come late, which ends the press.
  ASSERT_TRUE(force() > 2.0 || let_go_and_press_again()) << "what is felt goes on";
  const std::int64_t begin = now();
  program_->kill(SIGKILL);
  EXPECT_TRUE(comes([&] { return force() == 0.0; })) << program_->output();
  expect_bounded("guard, then all", begin);
}

TEST_F(PressingDevice, WhereNoGuardCanBeKeptTheProgramEndsAtZero) {
  ASSERT_TRUE(press()) << program_->output();
  const std::int64_t begin = now();
  pid_t last = 0;
  ASSERT_TRUE(comes([&] {
    const pid_t guard = guard_of(program_->pid(), last);
    if (guard > 0) ::kill(last = guard, SIGKILL);
    return program_->has_ended();
  })) << program_->output();
  EXPECT_EQ(program_->wait(), 1);
  EXPECT_EQ(force(), 0.0);
  EXPECT_NE(program_->output().find("no other can be kept"), std::string::npos) << program_->output();
  expect_bounded("no guard", begin);
}

// By SIGSTOP, as by Ctrl-Z: nobody else can open the device, so it must go on to say zero.
TEST_F(PressingDevice, AProgramThatIsStoppedWithAForceGoesOnAndSaysZero) {
  ASSERT_TRUE(press()) << program_->output();
  const std::int64_t begin = now();
  program_->kill(SIGSTOP);
  EXPECT_TRUE(comes([&] { return force() == 0.0; })) << program_->output();
  expect_bounded("stopped", begin);
  EXPECT_FALSE(program_->has_ended());
  EXPECT_TRUE(let_go_and_press_again()) << program_->output();
}

// A SPIDAR-G6 on a library as its owner would write it, whose board has no watchdog and takes packets of two processes.
class PressingSpidar : public PressingDevice {
 protected:
  PressingSpidar()
      : PressingDevice("x3r",
                       std::string("spidar-g6:x3r,hold=0,transport=") + TEGOTAE_DOUBLES + "/spidar/libmyboard.so",
                       [](DoubleState& state) {
                         state.max_force = 100.0;
                         state.max_torque = 10.0;
                         state.sharing = 2;  // TEGOTAE_SPIDAR_ANY_TIME
                         state.shared = true;
                       }) {}
};

class EndedPressingSpidar : public PressingSpidar, public ::testing::WithParamInterface<int> {};

TEST_P(EndedPressingSpidar, HasNoCurrentInItsMotorsWhateverSignalEndsTheProgram) {
  ASSERT_TRUE(press()) << program_->output();
  const std::int64_t begin = now();
  program_->kill(GetParam());
  EXPECT_TRUE(comes([&] { return force() == 0.0; })) << program_->output();
  program_->wait();
  expect_bounded(strsignal(GetParam()), begin);  // NOLINT(concurrency-mt-unsafe)
  for (const auto& tension : device_->tensions) EXPECT_EQ(tension, 0.0);
}

INSTANTIATE_TEST_SUITE_P(Signals, EndedPressingSpidar, ::testing::Values(SIGTERM, SIGKILL),
                         [](const auto& test) { return std::string(sigabbrev_np(test.param)); });

// In a call of the library that does not return, for longer than this test waits.
TEST_F(PressingSpidar, IsStoppedByTheGuardWhereTheProgramIsStuckInACall) {
  ASSERT_TRUE(press()) << program_->output();
  EXPECT_EQ(device_->opens, 1U);
  const std::int64_t begin = now();
  device_->stall = 600'000;  // ms
  EXPECT_TRUE(comes([&] { return device_->stall == 0 && device_->opens >= 2 && force() == 0.0; }))
      << program_->output();
  for (const auto& tension : device_->tensions) EXPECT_EQ(tension, 0.0);
  EXPECT_FALSE(program_->has_ended());
  expect_bounded("stuck in a call", begin);
}

}  // namespace
}  // namespace tegotae
