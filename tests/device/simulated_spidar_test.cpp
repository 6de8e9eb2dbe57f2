// SPDX-License-Identifier: Apache-2.0
#include <tests/allocation_counter.hpp>
#include <tests/device/spidar_rig.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <utility>

namespace tegotae {
namespace {

using test::counts_at;
using test::held_still;
using test::kSpidarPeriod;
using test::simulated_settings;
using test::spidar_settings;
using test::turn_between;

/// Driver, simulated device and hand.
struct Simulated {
  Simulated(const SpidarSettings& driver, const SimulatedSpidarSettings& device, Trajectory intended) {
    auto owned = std::make_unique<SimulatedSpidar>(device, std::make_unique<IntendedTrajectory>(std::move(intended)));
    device_ = owned.get();
    interface = std::make_unique<SpidarInterface>(driver, std::move(owned));
  }
  SimulatedSpidar* device_;
  std::unique_ptr<SpidarInterface> interface;
};

TEST(SimulatedSpidar, AHandTakesTheGripAndTheDriverFollows) {
  SpidarSettings settings = spidar_settings();
  settings.X_WS = {{0.0, 0.0, 0.4}, rotation_from_vector({0.0, 0.0, 0.5})};
  const Pose goal{{0.01, -0.008, 0.41}, rotation_from_vector({0.2, 0.1, 0.6})};
  Simulated spidar(settings, simulated_settings(settings), Trajectory({{0.0, settings.X_WS}, {0.5, goal}}));
  InterfaceState state;
  double fastest = 0.0;
  for (int k = 0; k <= 2000; ++k) {
    ASSERT_EQ(spidar.interface->read(k * kSpidarPeriod, state), InterfaceStatus::kOk) << k;
    ASSERT_LT((state.X_WT.p - spidar.device_->grip().X_WG.p).norm(), 20e-6) << k;
    ASSERT_LT(turn_between(state.X_WT, spidar.device_->grip().X_WG), 2e-3) << k;
    fastest = std::max(fastest, state.V_WT.linear.norm());
    ASSERT_EQ(spidar.interface->write({}), InterfaceStatus::kOk);
  }
  EXPECT_LT((state.X_WT.p - goal.p).norm(), 1e-4);
  EXPECT_GT(fastest, 0.02);
  EXPECT_LT(fastest, 0.1);
}

TEST(SimulatedSpidar, FeelsTheWrenchThatWasCommanded) {
  SpidarSettings settings = spidar_settings("x4r");
  Simulated spidar(settings, simulated_settings(settings), held_still(settings.X_WS));
  const Wrench wrench{{2.0, -1.0, 1.5}, {0.05, 0.0, -0.05}};
  InterfaceState state;
  for (int k = 0; k <= 2000; ++k) {
    spidar.interface->read(k * kSpidarPeriod, state);
    spidar.interface->write({wrench, 0.0});
  }
  // At rest the hand's spring carries it. The driver knows the pose to 20 um of 0.1 m, so the wrench to a part in 5000.
  const HandImpedance hand = simulated_hand("moderate");
  const GripState& grip = spidar.device_->grip();
  EXPECT_LT((grip.X_WG.p - wrench.force / hand.stiffness).norm(), 5e-6);
  EXPECT_LT((rotation_vector(grip.X_WG.q) - wrench.torque / hand.rotational_stiffness).norm(), 2e-4);
  EXPECT_LT((spidar.device_->displayed().force - wrench.force).norm(), 0.01);
  EXPECT_LT((spidar.device_->displayed().torque - wrench.torque).norm(), 5e-4);
}

TEST(SimulatedSpidar, StringsThatGiveMisleadADriverThatDoesNotKnow) {
  for (const bool knows : {false, true}) {
    SpidarSettings settings = spidar_settings();
    SimulatedSpidarSettings device = simulated_settings(settings);
    device.geometry.axial_stiffness = 5000.0;
    if (knows) settings.geometry.axial_stiffness = 5000.0;
    Simulated spidar(settings, device, held_still());
    InterfaceState state;
    for (int k = 0; k <= 2000; ++k) {
      spidar.interface->read(k * kSpidarPeriod, state);
      spidar.interface->write({{{8.0, 0.0, 0.0}, Vector3::Zero()}, 0.0});
    }
    const double error = (state.X_WT.p - spidar.device_->grip().X_WG.p).norm();
    if (knows) {
      EXPECT_LT(error, 20e-6);
    } else {
      EXPECT_GT(error, 40e-6);
      EXPECT_LT(error, 500e-6);
    }
  }
}

TEST(SimulatedSpidar, MotorsClipAndRefuseWhatIsNoNumber) {
  SpidarSettings settings = spidar_settings();
  SimulatedSpidar spidar(simulated_settings(settings), std::make_unique<IntendedTrajectory>(held_still()));
  SpidarVector tensions = SpidarVector::Constant(1.0);
  tensions[0] = 50.0;
  tensions[1] = -3.0;
  tensions[2] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(spidar.write(tensions));
  EXPECT_EQ(spidar.tensions()[0], 20.0);
  EXPECT_EQ(spidar.tensions()[1], 0.0);
  EXPECT_EQ(spidar.tensions()[2], 0.3);
  EXPECT_EQ(spidar.tensions()[3], 1.0);
}

TEST(SimulatedSpidar, CountsAreWholeAndZeroAtTheCentreWhereverTheMotionBegins) {
  SpidarSettings settings = spidar_settings();
  const Pose start{{0.01, 0.0, 0.0}, Quaternion::Identity()};
  SimulatedSpidar spidar(simulated_settings(settings), std::make_unique<IntendedTrajectory>(held_still(start)));
  SpidarVector counts;
  ASSERT_TRUE(spidar.read(0.0, counts));
  EXPECT_EQ(counts, counts_at(settings.geometry, start));
  spidar.set_grip({});
  ASSERT_TRUE(spidar.read(0.0, counts));
  EXPECT_EQ(counts.cwiseAbs().maxCoeff(), 0.0);
}

TEST(SimulatedSpidar, AClockThatFailsAndAPulledPlugFail) {
  SpidarSettings settings = spidar_settings();
  Simulated spidar(settings, simulated_settings(settings), held_still());
  InterfaceState state;
  EXPECT_EQ(spidar.interface->read(std::numeric_limits<double>::quiet_NaN(), state), InterfaceStatus::kLost);
  EXPECT_EQ(spidar.interface->read(1e6, state), InterfaceStatus::kLost);
  EXPECT_EQ(spidar.interface->read(kSpidarPeriod, state), InterfaceStatus::kOk);
  spidar.interface->write({{{5.0, 0.0, 0.0}, Vector3::Zero()}, 0.0});
  spidar.device_->set_connected(false);
  EXPECT_EQ(spidar.device_->displayed().force.norm(), 0.0);
  EXPECT_EQ(spidar.interface->read(2 * kSpidarPeriod, state), InterfaceStatus::kLost);
  EXPECT_EQ(spidar.interface->calibrate(), InterfaceStatus::kLost);
  spidar.device_->set_connected(true);
  EXPECT_EQ(spidar.interface->read(3 * kSpidarPeriod, state), InterfaceStatus::kOk);
}

TEST(SimulatedSpidar, NothingIsAllocatedOnceMade) {
  SpidarSettings settings = spidar_settings();
  Simulated spidar(settings, simulated_settings(settings), held_still());
  InterfaceState state;
  const test::AllocationCounter counter;
  for (int k = 0; k < 100; ++k) {
    spidar.interface->read(k * kSpidarPeriod, state);
    spidar.interface->write({{{0.5 * k, 0.0, 0.0}, Vector3::Zero()}, 0.0});
  }
  spidar.device_->set_connected(false);
  spidar.interface->read(0.1, state);
  spidar.interface->write({});
  EXPECT_EQ(counter.count(), 0U);
}

}  // namespace
}  // namespace tegotae
