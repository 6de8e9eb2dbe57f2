// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/connection.hpp>
#include <tegotae/device/interface_driver.hpp>
#include <tegotae/device/reconnecting_interface.hpp>

#include <tests/allocation_counter.hpp>
#include <tests/device/waiting.hpp>
#include <tests/lock_counter.hpp>

#include <gtest/gtest.h>

#include <atomic>

namespace tegotae {
namespace {

using test::comes_true;

constexpr Connection::Pace kQuick{std::chrono::milliseconds(1), std::chrono::milliseconds(3)};

// What a bench of made-up devices did, looked at from every thread.
struct Bench {
  std::atomic<int> opened{0}, closed{0}, refused{0};
  std::atomic<bool> is_there{true};
  std::atomic<DeviceAnswer> reading{DeviceAnswer::kOk}, writing{DeviceAnswer::kOk};
  std::atomic<double> max_force{10.0};
};

class MadeUpDevice final : public OpenDevice {
 public:
  explicit MadeUpDevice(Bench& bench) : bench_(bench), number_(++bench.opened), max_force_(bench.max_force) {}
  ~MadeUpDevice() override { ++bench_.closed; }
  InterfaceCapability capability() const override {
    InterfaceCapability result;
    result.name = "made-up";
    result.max_force = max_force_;
    return result;
  }
  // Not atomic, for the thread sanitizer to see who comes here.
  DeviceAnswer read(double time, InterfaceState& state) noexcept override {
    ++calls_;
    state.time = time;
    state.buttons = static_cast<std::uint32_t>(number_);
    return bench_.reading;
  }
  DeviceAnswer write(const InterfaceCommand& /*command*/) noexcept override {
    ++calls_;
    return bench_.writing;
  }

 private:
  Bench& bench_;
  int number_;
  double max_force_;
  int calls_ = 0;
};

DeviceOpener opener_of(Bench& bench) {
  return [&bench]() -> std::unique_ptr<OpenDevice> {
    if (!bench.is_there) {
      ++bench.refused;
      throw InterfaceError("it is not there.");
    }
    return std::make_unique<MadeUpDevice>(bench);
  };
}

TEST(Connection, HandsTheDeviceOverAndClosesItInTheEnd) {
  Bench bench;
  {
    Connection connection(opener_of(bench)(), opener_of(bench), kQuick);
    OpenDevice* device = connection.device();
    ASSERT_NE(device, nullptr);
    EXPECT_EQ(connection.device(), device);
    EXPECT_EQ(bench.closed, 0);
  }
  EXPECT_EQ(bench.opened, 1);
  EXPECT_EQ(bench.closed, 1);
}

TEST(Connection, ADeviceThatNobodyTookIsClosedToo) {
  Bench bench;
  { const Connection connection(opener_of(bench)(), opener_of(bench), kQuick); }
  EXPECT_EQ(bench.closed, 1);
}

TEST(Connection, OpensALostDeviceAgainWhenItIsBackAndClosesTheOldOneBefore) {
  Bench bench;
  {
    Connection connection(opener_of(bench)(), opener_of(bench), kQuick);
    ASSERT_NE(connection.device(), nullptr);
    bench.is_there = false;
    connection.give_up();
    EXPECT_EQ(connection.device(), nullptr);
    ASSERT_TRUE(comes_true([&] { return bench.refused >= 3; }));
    EXPECT_EQ(bench.closed, 1);
    EXPECT_EQ(connection.reconnections(), 0u);
    bench.is_there = true;
    ASSERT_TRUE(comes_true([&] { return connection.device() != nullptr; }));
    EXPECT_EQ(connection.reconnections(), 1u);
    EXPECT_EQ(bench.opened, 2);
  }
  EXPECT_EQ(bench.closed, 2);
}

// Many hand-overs between the two threads, for the thread sanitizer.
TEST(Connection, LosesAndFindsItsDeviceAgainAndAgain) {
  Bench bench;
  {
    Connection connection(opener_of(bench)(), opener_of(bench),
                          {std::chrono::milliseconds(0), std::chrono::milliseconds(0)});
    InterfaceState state;
    for (int i = 1; i <= 100; ++i) {
      OpenDevice* device = nullptr;
      ASSERT_TRUE(comes_true([&] { return (device = connection.device()) != nullptr; }));
      ASSERT_EQ(device->read(0.0, state), DeviceAnswer::kOk);
      ASSERT_EQ(state.buttons, static_cast<std::uint32_t>(i));
      connection.give_up();
    }
  }
  EXPECT_EQ(bench.opened, bench.closed);
}

TEST(ReconnectingInterface, ARefusedCallIsLostForThatTickAlone) {
  Bench bench;
  ReconnectingInterface interface(opener_of(bench)(), opener_of(bench), kQuick);
  EXPECT_EQ(interface.capability().name, "made-up");
  InterfaceState state;
  for (int tick = 0; tick < 100; ++tick) {
    const bool refused = tick % ReconnectingInterface::kPatience != 0;  // never that many on end
    bench.reading = refused ? DeviceAnswer::kFailed : DeviceAnswer::kOk;
    ASSERT_EQ(interface.read(1e-3 * tick, state), refused ? InterfaceStatus::kLost : InterfaceStatus::kOk) << tick;
    ASSERT_EQ(interface.write({}), InterfaceStatus::kOk);
  }
  EXPECT_EQ(bench.opened, 1);
  EXPECT_EQ(bench.closed, 0);
}

TEST(ReconnectingInterface, ADeviceThatRefusesForLongIsOpenedAnew) {
  Bench bench;
  ReconnectingInterface interface(opener_of(bench)(), opener_of(bench), kQuick);
  InterfaceState state;
  bench.writing = DeviceAnswer::kFailed;
  for (int tick = 0; tick <= ReconnectingInterface::kPatience; ++tick) {
    EXPECT_EQ(bench.closed, 0);
    interface.read(0.0, state);
    interface.write({});
  }
  bench.writing = DeviceAnswer::kOk;
  ASSERT_TRUE(comes_true([&] { return interface.read(0.0, state) == InterfaceStatus::kOk; }));
  EXPECT_EQ(state.buttons, 2u);
  EXPECT_EQ(interface.reconnections(), 1u);
  EXPECT_EQ(bench.closed, 1);
}

TEST(ReconnectingInterface, ADeviceWithoutPowerIsLostButKept) {
  Bench bench;
  ReconnectingInterface interface(opener_of(bench)(), opener_of(bench), kQuick);
  InterfaceState state;
  bench.reading = DeviceAnswer::kNotReady;
  for (int tick = 0; tick < 50; ++tick) EXPECT_EQ(interface.read(0.0, state), InterfaceStatus::kLost);
  bench.reading = DeviceAnswer::kOk;
  EXPECT_EQ(interface.read(0.0, state), InterfaceStatus::kOk);
  EXPECT_EQ(bench.opened, 1);
}

TEST(ReconnectingInterface, AnotherDeviceInItsPlaceIsNotTaken) {
  Bench bench;
  ReconnectingInterface interface(opener_of(bench)(), opener_of(bench), kQuick);
  InterfaceState state;
  bench.max_force = 200.0;
  bench.reading = DeviceAnswer::kFailed;
  for (int tick = 0; tick <= ReconnectingInterface::kPatience; ++tick) interface.read(0.0, state);
  bench.reading = DeviceAnswer::kOk;
  ASSERT_TRUE(comes_true([&] { return bench.opened >= 3; }));
  EXPECT_EQ(interface.read(0.0, state), InterfaceStatus::kLost);
  bench.max_force = 10.0;
  EXPECT_TRUE(comes_true([&] { return interface.read(0.0, state) == InterfaceStatus::kOk; }));
}

TEST(ReconnectingInterface, ReadingAndWritingTakeNoLockAndNoMemory) {
  Bench bench;
  ReconnectingInterface interface(opener_of(bench)(), opener_of(bench), kQuick);
  InterfaceState state;
  const test::AllocationCounter allocations;
  const test::LockCounter locks;
  for (int tick = 0; tick < 100; ++tick) {
    bench.reading = tick < 20 ? DeviceAnswer::kFailed : DeviceAnswer::kOk;
    interface.read(0.0, state);
    interface.write({});
  }
  EXPECT_EQ(allocations.count(), 0u);
  EXPECT_EQ(locks.count(), 0u);
}

}  // namespace
}  // namespace tegotae
