// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/simulated_presets.hpp>
#include <tegotae/lab/closed_loop.hpp>
#include <tegotae/lab/session.hpp>
#include <tegotae/lab/stability.hpp>

#include <tests/lab/press_and_slide.hpp>
#include <tests/lab/vibration_meter.hpp>
#include <tests/sweep_size.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

// The energy bound in closed loop: a simulated interface in a simulated hand, in simulated time.
namespace tegotae {
namespace {

constexpr std::uint32_t kSeed = 5;
// s; a sanitizer sees one hold.
const double kFeltDuration = std::max(2.0 * test::PressAndSlide::kEpisode, 1.0 * test::sweep_size(60));

// Frictionless: nothing that the contact takes helps to damp.
StabilitySetup setup_of(const char* device, const char* method, double delay) {
  SettingsRequest request;
  request.method = method;
  request.metric_length = 0.0;  // the cube's gyration length
  request.physics_rate = 20.0;
  if (std::string(method) == "proxy") request.friction = 0.0;
  StabilitySetup setup;
  setup.device = simulated_device(device);
  setup.device.delay = delay;
  setup.hand = simulated_hand("moderate");
  setup.settings = decide_settings(request, cube_over_floor().tool);
  return setup;
}

// The largest stiffness (N/m) at which all of vertex, edge and face are stable, as the laboratory finds it.
double stable_stiffness(const StabilitySetup& setup) {
  double least = std::numeric_limits<double>::infinity();
  const auto features = touched_features();
  for (const TouchedFeature& feature : features.first(test::kSweepDivisor > 1 ? 1 : features.size())) {
    least = std::min(least, measure_stability(setup, feature, [](double) {}).limit.largest_stable);
  }
  return least;
}

struct Contact {
  double vibration = 0.0;       // m/s above 20 Hz (RMS), of the worst hold
  double mean_vibration = 0.0;  // of all holds
  double injected = 0.0;        // J that the motors gave to the hand in all holds
  double displayed = 0.0;       // part of the method's force that was displayed, mean over the holds
  double held = 0.0;            // s
  double force = 0.0;           // N, mean over the holds
};

// Sixty seconds (fewer under a sanitizer) of tapping, pressing and sliding with faces, edges and vertices.
Contact press_and_slide(StabilitySetup setup, double stiffness, bool bound) {
  setup.settings.stiffness = stiffness;
  setup.settings.energy_bound = bound;
  const SceneGeometry scene = cube_over_floor();
  const test::PressAndSlide motion(scene.tool, kFeltDuration, kSeed);
  SimulatedHandInterface interface(motion.motion(), setup.device, setup.hand);
  const SafetyLimits limits = safety_limits_of(setup.settings, interface.capability(), scene.tool);
  const double gyration_length = scene.tool.mass.gyration_length();
  test::VibrationMeter meter(1.0 / setup.settings.haptic_rate);
  Contact contact;
  Pose X_WG_before;
  Wrench motors;
  double asked = 0.0;
  bool was_held = false;
  run_closed_loop(scene, setup.settings, limits, interface, kFeltDuration, [&](const TickRecord& record) {
    const GripState& grip = interface.grip();
    Vector6 velocity;
    velocity << grip.V_WG.linear, gyration_length * grip.V_WG.angular;
    // From the third second on: the ramp has risen.
    const bool held = record.time > 3.0 && test::PressAndSlide::is_held(record.time);
    meter.add(velocity, held);
    if (held && was_held) {
      const Vector6 way = displacement(X_WG_before, grip.X_WG, Vector3::Zero());
      contact.injected += motors.force.dot(way.head<3>()) + motors.torque.dot(way.tail<3>());
      contact.held += 1.0 / setup.settings.haptic_rate;
      contact.force += record.displayed.force.vector().norm() / setup.settings.haptic_rate;
      asked += record.wrench.force.vector().norm() / setup.settings.haptic_rate;
    }
    was_held = held;
    X_WG_before = grip.X_WG;
    motors = interface.displayed();
    return true;
  });
  contact.vibration = meter.worst();
  contact.mean_vibration = meter.mean();
  contact.displayed = contact.force / asked;
  contact.force /= contact.held;
  return contact;
}

void print(const char* device, const char* method, double stiffness, double factor, bool on, const Contact& contact) {
  std::printf("| %-10s | %-5s | %6.0f | %3.1f | %-3s | %8.3f | %8.3f | %8.3f | %5.2f | %6.2f |\n", device, method,
              stiffness, factor, on ? "on" : "off", 1e3 * contact.vibration, 1e3 * contact.mean_vibration,
              1e3 * contact.injected, contact.force, 100.0 * contact.displayed);
}

// What a hand no longer feels as a vibration: at 100 Hz 2 mm/s are 3 um.
constexpr double kStill = 2e-3;  // m/s

struct Case {
  const char* device;
  const char* method;
  double delay;  // s
};

class EnergyBoundInTheLoop : public ::testing::TestWithParam<Case> {};

TEST_P(EnergyBoundInTheLoop, NoVibrationStaysAtTwiceTheStableStiffnessAndWithoutItOneDoes) {
  const auto [device, method, delay] = GetParam();
  const StabilitySetup setup = setup_of(device, method, delay);
  const double stable = stable_stiffness(setup);
  for (const bool on : {true, false}) {
    const Contact contact = press_and_slide(setup, 2.0 * stable, on);
    print(device, method, 2.0 * stable, 2.0, on, contact);
    EXPECT_GT(contact.force, 0.5) << "it presses";
    if (on) {
      EXPECT_LT(contact.vibration, kStill);
      EXPECT_LT(contact.injected, 1e-3) << "J";
    } else {
      EXPECT_GT(contact.mean_vibration, 2.0 * kStill);
      EXPECT_GT(contact.injected, 2e-3 * contact.held) << "J: 2 mW";
    }
  }
}

TEST_P(EnergyBoundInTheLoop, AStableContactIsNotSpoiled) {
  const auto [device, method, delay] = GetParam();
  const StabilitySetup setup = setup_of(device, method, delay);
  const double stable = stable_stiffness(setup);
  for (const double factor : {0.5, 0.9}) {
    const Contact without = press_and_slide(setup, factor * stable, false);
    const Contact with = press_and_slide(setup, factor * stable, true);
    print(device, method, factor * stable, factor, false, without);
    print(device, method, factor * stable, factor, true, with);
    EXPECT_NEAR(with.displayed, 1.0, 0.01);
    EXPECT_NEAR(with.force, without.force, 0.01 * without.force);
    EXPECT_LE(with.mean_vibration, without.mean_vibration + 1e-4);
  }
}

std::string name_of_case(const ::testing::TestParamInfo<Case>& info) {
  return std::string(info.param.device) + "_" + info.param.method;
}

// `laboratory`: viscous, a sample of delay, no rating; `page`: no delay, rated at a quarter of what is asked of it
// here.
INSTANTIATE_TEST_SUITE_P(Devices, EnergyBoundInTheLoop,
                         ::testing::Values(Case{"laboratory", "proxy", 1e-3}, Case{"laboratory", "paper", 1e-3},
                                           Case{"page", "proxy", 0.0}),
                         name_of_case);

}  // namespace
}  // namespace tegotae
