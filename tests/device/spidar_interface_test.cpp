// SPDX-License-Identifier: Apache-2.0
#include <tests/device/spidar_rig.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <string>
#include <utility>

namespace tegotae {
namespace {

using test::counts_at;
using test::kSpidarPeriod;
using test::spidar_settings;
using test::turn_between;

/// A board whose counts a test sets.
class StubTransport final : public SpidarTransport {
 public:
  bool reset() noexcept override {
    ++resets;
    return answers;
  }
  bool read(double /*time*/, SpidarVector& result) noexcept override {
    result = counts;
    return answers;
  }
  bool write(const SpidarVector& tensions) noexcept override {
    if (answers) written = tensions;
    if (shared != nullptr) *shared = written;
    return answers;
  }

  bool answers = true;
  int resets = 0;
  SpidarVector counts = SpidarVector::Zero(), written = SpidarVector::Zero();
  SpidarVector* shared = nullptr;  ///< outlives it
};

struct Stubbed {
  explicit Stubbed(const SpidarSettings& settings) {
    auto owned = std::make_unique<StubTransport>();
    board = owned.get();
    interface = std::make_unique<SpidarInterface>(settings, std::move(owned));
  }
  StubTransport* board;
  std::unique_ptr<SpidarInterface> interface;
};

TEST(SpidarInterface, CalibratesAndReportsThePoseInTheWorld) {
  SpidarSettings settings = spidar_settings();
  settings.X_WS = {{0.1, 0.2, 0.3}, rotation_from_vector({0.0, 0.0, 0.7})};
  Stubbed spidar(settings);
  EXPECT_EQ(spidar.board->resets, 1);
  EXPECT_EQ(spidar.board->written, min_tensions(settings.geometry));
  InterfaceState state;
  ASSERT_EQ(spidar.interface->read(0.0, state), InterfaceStatus::kOk);
  EXPECT_LT((state.X_WT.p - settings.X_WS.p).norm(), 1e-12);
  const Pose X_SG{{0.01, -0.005, 0.008}, rotation_from_vector({0.1, 0.2, -0.3})};
  spidar.board->counts = counts_at(settings.geometry, X_SG);
  ASSERT_EQ(spidar.interface->read(kSpidarPeriod, state), InterfaceStatus::kOk);
  EXPECT_LT((state.X_WT.p - (settings.X_WS * X_SG).p).norm(), 20e-6);
  EXPECT_LT(turn_between(state.X_WT, settings.X_WS * X_SG), 2e-3);
  EXPECT_EQ(state.time, kSpidarPeriod);
  EXPECT_LT(spidar.interface->pose().misfit, 20e-6);
}

TEST(SpidarInterface, CountSignsAreFollowed) {
  // A longer string counts down on motors 2 to 5 of an X3: read with the other sign the lengths fit no pose.
  SpidarSettings settings = spidar_settings();
  Stubbed spidar(settings);
  spidar.board->counts = counts_at(settings.geometry, {{0.01, 0.01, 0.01}, rotation_from_vector({0.1, 0.0, 0.2})});
  InterfaceState state;
  EXPECT_EQ(spidar.interface->read(0.0, state), InterfaceStatus::kOk);
  spidar.board->counts.segment<4>(2) *= -1.0;
  EXPECT_EQ(spidar.interface->read(0.0, state), InterfaceStatus::kLost);
}

TEST(SpidarInterface, DisplaysWorldWrenchesByTensions) {
  SpidarSettings settings = spidar_settings("x4r");
  settings.X_WS.q = rotation_from_vector({0.3, -0.2, 1.0});
  Stubbed spidar(settings);
  const Pose X_SG{{0.005, 0.0, -0.004}, rotation_from_vector({0.0, 0.1, 0.1})};
  spidar.board->counts = counts_at(settings.geometry, X_SG);
  InterfaceState state;
  ASSERT_EQ(spidar.interface->read(0.0, state), InterfaceStatus::kOk);
  const Wrench wrench{{1.0, -2.0, 3.0}, {0.05, 0.02, -0.03}};
  ASSERT_EQ(spidar.interface->write({wrench, 0.0}), InterfaceStatus::kOk);
  // By the pose that was read, about the grip.
  const SpidarWrenchMatrix W = spidar_strings(settings.geometry, spidar.interface->pose().X_SG).wrenches;
  const Vector6 displayed_S = W * spidar.board->written;
  EXPECT_LT((settings.X_WS.q * displayed_S.head<3>() - wrench.force).norm(), 1e-9);
  EXPECT_LT((settings.X_WS.q * displayed_S.tail<3>() - wrench.torque).norm(), 1e-9);
  EXPECT_EQ(spidar.interface->shortfalls(), 0U);
  spidar.interface->write({{{100.0, 0.0, 0.0}, Vector3::Zero()}, 0.0});
  EXPECT_EQ(spidar.interface->shortfalls(), 1U);
  EXPECT_LT(spidar.interface->display().scale, 1.0);
}

TEST(SpidarInterface, CapabilityIsOfTheGeometry) {
  Stubbed spidar(spidar_settings());
  const InterfaceCapability capability = spidar.interface->capability();
  EXPECT_EQ(capability.name, "spidar-g6:x3r");
  EXPECT_EQ(capability.input_degrees_of_freedom, 6);
  EXPECT_EQ(capability.output_degrees_of_freedom, 6);
  EXPECT_GT(capability.max_force, 20.0);
  EXPECT_LT(capability.max_force, 40.0);
  EXPECT_GT(capability.max_torque, 0.4);
  EXPECT_LT(capability.max_torque, 0.9);
  EXPECT_GT(capability.encoder_step, 1e-5);
  EXPECT_LT(capability.encoder_step, 2e-5);
  // Both are displayed, any way round.
  InterfaceState state;
  ASSERT_EQ(spidar.interface->read(0.0, state), InterfaceStatus::kOk);
  for (const Vector3& axis : {Vector3(Vector3::UnitX()), Vector3(-Vector3::UnitY()), Vector3(Vector3::UnitZ())}) {
    spidar.interface->write({{0.999 * capability.max_force * axis, Vector3::Zero()}, 0.0});
    spidar.interface->write({{Vector3::Zero(), 0.999 * capability.max_torque * axis}, 0.0});
  }
  EXPECT_EQ(spidar.interface->shortfalls(), 0U);
}

TEST(SpidarInterface, LostTransportIsReportedAndRecoversWithLeastTensionsAtFirst) {
  SpidarSettings settings = spidar_settings();
  Stubbed spidar(settings);
  InterfaceState state;
  spidar.interface->read(0.0, state);
  spidar.interface->write({{{5.0, 0.0, 0.0}, Vector3::Zero()}, 0.0});
  EXPECT_GT(spidar.board->written.maxCoeff(), 3.0);
  spidar.board->answers = false;
  EXPECT_EQ(spidar.interface->read(kSpidarPeriod, state), InterfaceStatus::kLost);
  EXPECT_EQ(spidar.interface->write({{{5.0, 0.0, 0.0}, Vector3::Zero()}, 0.0}), InterfaceStatus::kLost);
  spidar.board->answers = true;
  // Back, but no pose was read yet.
  EXPECT_EQ(spidar.interface->write({{{5.0, 0.0, 0.0}, Vector3::Zero()}, 0.0}), InterfaceStatus::kLost);
  EXPECT_EQ(spidar.board->written, min_tensions(settings.geometry));
  EXPECT_EQ(spidar.interface->read(2 * kSpidarPeriod, state), InterfaceStatus::kOk);
  EXPECT_EQ(state.V_WT.linear.norm(), 0.0);
  EXPECT_EQ(spidar.interface->write({{{5.0, 0.0, 0.0}, Vector3::Zero()}, 0.0}), InterfaceStatus::kOk);
}

TEST(SpidarInterface, AFailedWriteIsLost) {
  Stubbed spidar(spidar_settings());
  InterfaceState state;
  spidar.interface->read(0.0, state);
  spidar.board->answers = false;
  EXPECT_EQ(spidar.interface->write({}), InterfaceStatus::kLost);
}

TEST(SpidarInterface, CountsThatAreNoNumbersOrFitNoPoseAreLostUntilTheyFitAgain) {
  SpidarSettings settings = spidar_settings();
  Stubbed spidar(settings);
  InterfaceState state;
  const SpidarVector good = counts_at(settings.geometry, {{2e-3, 1e-3, 0.0}, Quaternion::Identity()});
  for (const double bad :
       {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(), 2e3, 1e9, -1e9}) {
    spidar.board->counts = good;
    ASSERT_EQ(spidar.interface->read(0.0, state), InterfaceStatus::kOk) << bad;
    spidar.interface->write({{{5.0, 0.0, 0.0}, Vector3::Zero()}, 0.0});
    const Pose before = state.X_WT;
    spidar.board->counts[6] = bad;
    EXPECT_EQ(spidar.interface->read(kSpidarPeriod, state), InterfaceStatus::kLost) << bad;
    EXPECT_EQ(spidar.board->written, min_tensions(settings.geometry)) << bad;
    EXPECT_EQ(state.X_WT.p, before.p);
  }
}

// Some of these fit a pose tens of degrees away within a millimetre.
TEST(SpidarInterface, ACounterThatLeapedIsNotBelievedWhateverItFits) {
  SpidarSettings settings = spidar_settings();
  Stubbed spidar(settings);
  InterfaceState state;
  double time = 0.0;
  const SpidarVector good = counts_at(settings.geometry, {{2e-3, 1e-3, -4e-3}, rotation_from_vector({0.0, 0.1, 0.0})});
  for (int i = 0; i < kSpidarStrings; ++i) {
    for (const double way : {7e-3, 10e-3, 20e-3, 33e-3, -7e-3, -20e-3}) {
      spidar.board->counts = good;
      ASSERT_EQ(spidar.interface->read(time += kSpidarPeriod, state), InterfaceStatus::kOk) << i << " " << way;
      const auto string = static_cast<std::size_t>(i);
      spidar.board->counts[i] += std::round(way / std::abs(settings.geometry.strings[string].metres_per_pulse));
      for (int k = 0; k < 50; ++k) {
        ASSERT_EQ(spidar.interface->read(time += kSpidarPeriod, state), InterfaceStatus::kLost) << i << " " << way;
      }
    }
  }
}

TEST(SpidarInterface, AGripThatReallyLeapedIsBelieved) {
  SpidarSettings settings = spidar_settings();
  Stubbed spidar(settings);
  InterfaceState state;
  ASSERT_EQ(spidar.interface->read(0.0, state), InterfaceStatus::kOk);
  const Pose far{{0.015, -0.01, 0.01}, rotation_from_vector({0.0, 0.2, -0.1})};
  spidar.board->counts = counts_at(settings.geometry, far);
  ASSERT_EQ(spidar.interface->read(kSpidarPeriod, state), InterfaceStatus::kOk);
  EXPECT_LT((state.X_WT.p - far.p).norm(), 20e-6);
}

TEST(SpidarInterface, ACommandThatIsNoNumberLeavesLeastTensions) {
  SpidarSettings settings = spidar_settings();
  Stubbed spidar(settings);
  InterfaceState state;
  spidar.interface->read(0.0, state);
  spidar.interface->write({{{0.0, std::numeric_limits<double>::quiet_NaN(), 0.0}, Vector3::Zero()}, 0.0});
  EXPECT_EQ(spidar.board->written, min_tensions(settings.geometry));
}

TEST(SpidarInterface, LeavesLeastTensions) {
  SpidarSettings settings = spidar_settings();
  SpidarVector last = SpidarVector::Zero();
  {
    Stubbed spidar(settings);
    spidar.board->shared = &last;
    InterfaceState state;
    spidar.interface->read(0.0, state);
    spidar.interface->write({{{5.0, 0.0, 0.0}, Vector3::Zero()}, 0.0});
    EXPECT_GT(last.maxCoeff(), 3.0);
  }
  EXPECT_EQ(last, min_tensions(settings.geometry));
}

TEST(SpidarInterface, RefusesWhatCannotBe) {
  EXPECT_THROW(Stubbed(spidar_settings("x3f")), std::invalid_argument);
  SpidarSettings nowhere = spidar_settings(), windowless = spidar_settings();
  nowhere.X_WS.p.x() = std::numeric_limits<double>::quiet_NaN();
  windowless.velocity_window = -1.0;
  EXPECT_THROW(Stubbed{nowhere}, std::invalid_argument);
  EXPECT_THROW(Stubbed{windowless}, std::invalid_argument);
  auto mute = std::make_unique<StubTransport>();
  mute->answers = false;
  EXPECT_THROW(SpidarInterface(spidar_settings(), std::move(mute)), std::runtime_error);
}

}  // namespace
}  // namespace tegotae
