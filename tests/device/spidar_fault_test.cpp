// SPDX-License-Identifier: Apache-2.0
// Faults of a SPIDAR's board in the full loop: what the hand feels meanwhile.
#include <tegotae/runtime/realtime_session.hpp>
#include <tegotae/runtime/safety_limits.hpp>
#include <tegotae/runtime/simulated_session.hpp>

#include <tests/device/spidar_rig.hpp>
#include <tests/free_body_world.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <cstdio>
#include <functional>
#include <limits>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

namespace tegotae {
namespace {

using test::kSpidarPeriod;

constexpr double kStiffness = 1000.0;   // N/m
constexpr double kMetricLength = 0.08;  // m
constexpr double kDuration = 8.0;       // s
constexpr double kFault = 2.8;          // s, when the ramp has risen and the hand has pressed for long
constexpr double kMended = 3.2;         // s
constexpr double kOut = 4.0;            // s, when the hand goes out

/// A board that fails as it is told, on a simulated SPIDAR.
class FaultyBoard final : public SpidarTransport {
 public:
  explicit FaultyBoard(std::unique_ptr<SimulatedSpidar> spidar) : spidar_(std::move(spidar)) {}

  bool reset() noexcept override { return spidar_->reset(); }
  bool read(double time, SpidarVector& counts) noexcept override {
    now = time;
    before_read();
    spidar_->set_connected(!is_unplugged.load());
    if (!spidar_->read(time, counts)) return false;
    counts += slip;
    return !fails();
  }
  bool write(const SpidarVector& tensions) noexcept override { return !fails() && spidar_->write(tensions); }

  SimulatedSpidar& spidar() noexcept { return *spidar_; }

  double now = 0.0;                          ///< s
  SpidarVector slip = SpidarVector::Zero();  ///< added to the counts, pulses
  std::atomic<bool> is_unplugged{false};     ///< by any thread
  int fail_every = 0;                        ///< calls; 0: none
  std::function<void()> before_read = [] {};

 private:
  bool fails() noexcept { return fail_every > 0 && ++calls_ % fail_every == 0; }

  std::unique_ptr<SimulatedSpidar> spidar_;
  long calls_ = 0;
};

// S stands upright in a world whose y is up. The cube lies on the grip as it stands in S, which is one of its
// symmetries.
const Pose& frame() {
  static const Pose X_WS{{0.0, 0.1, 0.0}, rotation_from_vector({-0.5 * std::numbers::pi, 0.0, 0.0})};
  return X_WS;
}

// The cube's middle is the frame's: the hand means it 8 mm in the floor, out of it from kOut on, when the ramp may
// begin again, and in it again.
Trajectory pressing() {
  const auto at = [](double height) { return Pose{{0.0, height, 0.0}, frame().q}; };
  return Trajectory({{0.0, at(0.105)},
                     {0.2, at(0.105)},
                     {0.4, at(0.092)},
                     {kOut, at(0.092)},
                     {kOut + 0.2, at(0.105)},
                     {kOut + 0.4, at(0.105)},
                     {kOut + 0.6, at(0.092)},
                     {kDuration, at(0.092)}});
}

/// What the hand felt, and what was commanded.
struct Felt {
  double force = 0.0, torque = 0.0;                ///< N, N m, worst displayed from the fault to when the hand goes out
  double force_growth = 0.0, torque_growth = 0.0;  ///< N, N m a tick, greatest commanded of the whole run
  double commanded_force = 0.0;                    ///< N, greatest of the whole run
  double time_to_zero = -1.0;                      ///< s, from the fault to least tensions or none; -1: never
  double force_before = 0.0, force_at_end = 0.0;   ///< N
};

class SpidarFault : public ::testing::Test {
 protected:
  SpidarFault() {
    settings.X_WS = frame();
    auto owned = std::make_unique<FaultyBoard>(test::simulated_spidar(settings, pressing()));
    board = owned.get();
    interface = std::make_unique<SpidarInterface>(settings, std::move(owned));
    limits = safety_limits(interface->capability(), kStiffness, kMetricLength, 0.01);
    MethodSettings method;
    method.stiffness = kStiffness;
    method.metric_length = kMetricLength;
    haptics = std::make_unique<HapticTick>(make_method("paper", method, world.geometry()), world.geometry().tool,
                                           limits, kSpidarPeriod);
  }

  bool is_slack() const {
    const SpidarVector excess = board->spidar().tensions() - min_tensions(settings.geometry);
    return excess.maxCoeff() < 1e-9;
  }

  Felt run(
      const char* name, const std::function<void()>& at_fault, const std::function<void()>& mend = [] {}) {
    bool is_faulty = false, is_mended = false;
    board->before_read = [&] {
      if (!is_faulty && board->now >= kFault) {
        is_faulty = true;
        at_fault();
      } else if (!is_mended && board->now >= kMended) {
        is_mended = true;
        mend();
      }
    };
    Felt felt;
    Wrench before;
    run_simulated(physics, *haptics, *interface, kSpidarPeriod, kDuration, [&](const TickRecord& record) {
      const Wrench commanded = record.displayed, displayed = board->spidar().displayed();
      felt.commanded_force = std::max(felt.commanded_force, commanded.force.norm());
      felt.force_growth = std::max(felt.force_growth, commanded.force.norm() - before.force.norm());
      felt.torque_growth = std::max(felt.torque_growth, commanded.torque.norm() - before.torque.norm());
      before = commanded;
      if (!is_faulty) {
        felt.force_before = displayed.force.norm();
        return true;
      }
      felt.force_at_end = displayed.force.norm();
      if (record.time > kOut) return true;
      felt.force = std::max(felt.force, displayed.force.norm());
      felt.torque = std::max(felt.torque, displayed.torque.norm());
      if (felt.time_to_zero < 0.0 && is_slack()) felt.time_to_zero = std::max(0.0, record.time - kFault);
      return true;
    });
    std::printf("%-32s worst %.2f N and %.4f N m, after %.2f N; slack after %.0f ms; at the end %.2f N\n", name,
                felt.force, felt.torque, felt.force_before, 1e3 * felt.time_to_zero, felt.force_at_end);
    // Rounding, and the least tensions, which display a little off the middle.
    EXPECT_LE(felt.force, limits.max_force + 0.1);
    EXPECT_LE(felt.torque, limits.max_torque + 0.01);
    EXPECT_LE(felt.commanded_force, limits.max_force * (1.0 + 1e-12));
    EXPECT_LE(felt.force_growth, limits.force_rate * kSpidarPeriod * (1.0 + 1e-9));
    EXPECT_LE(felt.torque_growth, limits.torque_rate * kSpidarPeriod * (1.0 + 1e-9));
    EXPECT_GT(felt.force_before, 2.0) << "the hand pressed before the fault";
    return felt;
  }

  SpidarSettings settings = test::spidar_settings();
  FaultyBoard* board = nullptr;
  std::unique_ptr<SpidarInterface> interface;
  test::FreeBodyWorld world{test::cube_over_floor()};
  PhysicsLoop physics{world, {0.01, 0.005}, ModelNeeds{}};
  SafetyLimits limits;
  std::unique_ptr<HapticTick> haptics;
};

TEST_F(SpidarFault, WithoutOneTheHandPressesAllAlong) {
  const Felt felt = run("none", [] {});
  EXPECT_EQ(felt.time_to_zero, -1.0) << "off the middle even no wrench takes more than least tensions";
  EXPECT_NEAR(felt.force_at_end, felt.force_before, 0.3);
}

TEST_F(SpidarFault, UnpluggedAndBack) {
  const Felt felt = run(
      "unplugged for 0.4 s", [&] { board->is_unplugged = true; }, [&] { board->is_unplugged = false; });
  EXPECT_NEAR(felt.time_to_zero, 0.0, 1e-9) << "in the same tick";
  EXPECT_LE(felt.force, felt.force_before + 1.0) << "not more than before";
  EXPECT_GT(felt.force_at_end, 2.0) << "and it is back";
}

TEST_F(SpidarFault, CallsThatFailNowAndThen) {
  const Felt felt = run(
      "every 50th call fails", [&] { board->fail_every = 50; }, [&] { board->fail_every = 0; });
  EXPECT_GE(felt.time_to_zero, 0.0);
  EXPECT_LE(felt.time_to_zero, 0.051) << "at the first that fails, or one tick later";
  EXPECT_LE(felt.force, felt.force_before + 1.0);
  EXPECT_GT(felt.force_at_end, 2.0);
}

TEST_F(SpidarFault, CountsThatAreNoNumbers) {
  const Felt felt = run(
      "a count that is no number", [&] { board->slip[3] = std::numeric_limits<double>::quiet_NaN(); },
      [&] { board->slip[3] = 0.0; });
  EXPECT_NEAR(felt.time_to_zero, 0.0, 1e-9);
  EXPECT_LE(felt.force, felt.force_before + 1.0);
  EXPECT_GT(felt.force_at_end, 2.0);
}

// Of 16.7 um a pulse: 0.33 mm, 3.3 mm and 33 mm in one string. What the redundant strings do not see moves the pose by
// the like, which changes the wrench as a hand would that moved so.
TEST_F(SpidarFault, ACounterThatSlipped) {
  for (const double pulses : {20.0, 200.0}) {
    SpidarFault_ACounterThatSlipped_Test fresh;
    const Felt felt = fresh.run((std::to_string(static_cast<int>(pulses)) + " pulses slipped").c_str(),
                                [&] { fresh.board->slip[0] = pulses; }, [&] { fresh.board->slip[0] = 0.0; });
    EXPECT_LE(felt.force, felt.force_before + kStiffness * pulses * 1.66555e-5 + 1.0) << pulses;
    EXPECT_GT(felt.force_at_end, 2.0);
  }
  const Felt felt = run(
      "2000 pulses slipped", [&] { board->slip[0] = 2000.0; }, [&] { board->slip[0] = 0.0; });
  EXPECT_NEAR(felt.time_to_zero, 0.0, 1e-9) << "no pose fits: lost in the same tick";
  EXPECT_LE(felt.force, felt.force_before + 1.0);
  EXPECT_GT(felt.force_at_end, 2.0);
}

TEST_F(SpidarFault, UnpluggedAndBackInRealTimeByAnotherThread) {
  enum { kPressing, kUnplugged, kBack, kDone } phase = kPressing;
  const auto is_stopped = [](const TickRecord& record) {
    return (record.safety_events >> static_cast<unsigned>(SafetyEvent::kStopped) & 1U) != 0;
  };
  const std::atomic<bool> never{false};
  constexpr double kLongest = 60.0;  // s, for a machine as slow as may be
  run_realtime(physics, *haptics, *interface, kSpidarPeriod, kLongest, never, [&](const TickRecord& record) {
    if (phase == kPressing && Wrench(record.displayed).force.norm() > 0.5) {
      board->is_unplugged = true;
      phase = kUnplugged;
    } else if (phase == kUnplugged && is_stopped(record)) {
      EXPECT_EQ(Wrench(record.displayed).force.norm(), 0.0);
      board->is_unplugged = false;
      phase = kBack;
    } else if (phase == kBack && !is_stopped(record)) {
      phase = kDone;
    }
    return phase != kDone;
  });
  EXPECT_EQ(phase, kDone);
  EXPECT_LT(board->spidar().displayed().force.norm(), 0.5) << "zero, but for what least tensions display";
}

}  // namespace
}  // namespace tegotae
