// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/simulated_presets.hpp>
#include <tegotae/lab/input_error.hpp>
#include <tegotae/lab/motion.hpp>
#include <tegotae/lab/random_contact.hpp>
#include <tegotae/lab/stability_json.hpp>
#include <tegotae/math/rotation.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <string>

namespace tegotae {
namespace {

StabilitySetup setup_of(const std::string& method, double delay = 1e-3) {
  SettingsRequest request;
  request.method = method;
  request.metric_length = 0.0;  // the cube's gyration length
  request.physics_rate = 20.0;
  StabilitySetup setup;
  setup.device = simulated_device("laboratory");
  setup.device.delay = delay;
  setup.hand = simulated_hand("moderate");
  setup.settings = decide_settings(request, cube_over_floor().tool);
  return setup;
}

StabilityRow measured(const StabilitySetup& setup, const char* contact) {
  return measure_stability(setup, touched_feature(contact), [](double) {});
}

TEST(CubeTouch, BeginsAboveTheFloorAndPressesTheFeatureIntoIt) {
  const Tool tool = cube_over_floor().tool;
  for (const double friction : {0.0, 0.26}) {
    GripMechanics mechanics;
    mechanics.friction_force = friction;
    const CubeTouch touch(mechanics, simulated_hand("relaxed"));
    EXPECT_NEAR(touch.depth(), CubeTouch::kPress + friction / 135.0, 1e-15);
    for (const TouchedFeature& feature : touched_features()) {
      const Trajectory motion = touch.motion(tool, feature);
      const auto lowest = [&](double time) {
        const Pose X_WT = motion.at(time);
        return X_WT.p.z() + lowest_height(tool, X_WT.q, Vector3::UnitZ());
      };
      EXPECT_NEAR(lowest(0.0), CubeTouch::kGap, 1e-12) << feature.name;
      EXPECT_NEAR(lowest(touch.end()), -touch.depth(), 1e-12) << feature.name;
      EXPECT_NEAR(motion.twist_at(0.1).linear.z(), -1e-3, 1e-12);
      EXPECT_NEAR(motion.twist_at(touch.end() - 0.1).angular.norm() * 0.1 * std::sqrt(2.0), 1e-3, 1e-4);
      EXPECT_LT(rotation_vector(motion.at(touch.end()).q * feature.q_WT.conjugate()).norm(), 1e-12);
    }
  }
  EXPECT_THROW(CubeTouch({}, {}), InputError);
}

TEST(CubeTouch, TheCentreIsAboveTheFeature) {
  const Tool tool = cube_over_floor().tool;
  const double heights[] = {0.1 * std::sqrt(3.0), 0.1 * std::sqrt(2.0), 0.1};
  int i = 0;
  for (const TouchedFeature& feature : touched_features()) {
    EXPECT_NEAR(-lowest_height(tool, feature.q_WT, Vector3::UnitZ()), heights[i++], 1e-12) << feature.name;
  }
  EXPECT_THROW(touched_feature("corner"), InputError);
}

TEST(Stability, ThePublishedMethodReachesTheLinearBoundWithItsGyrationLength) {
  for (const char* contact : {"vertex", "edge", "face"}) {
    const StabilityRow row = measured(setup_of("paper"), contact);
    EXPECT_GE(row.ratio_to_linear(), 0.95) << contact;
    EXPECT_LE(row.ratio_to_linear(), 1.05) << contact;
    EXPECT_LE(row.limit.smallest_unstable, row.limit.largest_stable * (1.0 + kStabilityWidth));
  }
}

TEST(Stability, WithoutDelayThreeTimesAsMuch) {
  const StabilityRow row = measured(setup_of("paper", 0.0), "face");
  EXPECT_NEAR(row.bounds.linear, 12000.0, 1e-6);
  EXPECT_NEAR(row.ratio_to_linear(), 1.0, 0.06);
}

TEST(Stability, TheDampingOfTheCouplingCountsAndPassivityAsksForLess) {
  StabilitySetup setup = setup_of("paper", 0.0);
  setup.settings.damping = 2.0;
  const StabilityRow row = measured(setup, "face");
  EXPECT_NEAR(row.bounds.linear, 16000.0, 1e-6);
  EXPECT_GT(row.ratio_to_linear(), 0.8);
  EXPECT_EQ(row.bounds.colgate_schenkel, 0.0) << "the coupling damps more than the interface";
}

TEST(Stability, FrictionOfTheInterfaceRaisesTheLimitAndTheHandStillTouches) {
  StabilitySetup setup = setup_of("paper");
  setup.device = simulated_device("stylus");
  for (const char* hand : {"relaxed", "firm"}) {
    setup.hand = simulated_hand(hand);
    EXPECT_TRUE(touch_decays(setup, touched_feature("vertex"), 1000.0)) << hand;
    EXPECT_GT(measured(setup, "vertex").ratio_to_linear(), 1.2) << hand;
  }
}

TEST(Stability, SpringsAtEachPointFallToAQuarterAtAFace) {
  const double face = measured(setup_of("berkelman"), "face").ratio_to_linear();
  EXPECT_NEAR(face, 0.25, 0.05);
  EXPECT_GT(measured(setup_of("paper"), "face").ratio_to_linear(), 3.5 * face);
}

TEST(Stability, TheProxyReachesTheBoundAtEveryContact) {
  for (const char* contact : {"vertex", "edge", "face"}) {
    EXPECT_GE(measured(setup_of("proxy"), contact).ratio_to_linear(), 0.95) << contact;
  }
}

TEST(RandomContact, RepeatsAndTouchesWithEveryFeature) {
  const Tool tool = cube_over_floor().tool;
  const Trajectory a = random_contact(tool, 60.0, 1), b = random_contact(tool, 60.0, 1);
  const Trajectory other = random_contact(tool, 60.0, 2);
  double deepest = 0.0, highest = 0.0, steepest = 0.0, difference = 0.0;
  for (size_t i = 0; i < a.samples().size(); ++i) {
    const Pose& X_WT = a.samples()[i].X_WT;
    ASSERT_EQ(X_WT.p, b.samples()[i].X_WT.p);
    const double low = X_WT.p.z() + lowest_height(tool, X_WT.q, Vector3::UnitZ());
    deepest = std::min(deepest, low);
    highest = std::max(highest, low);
    steepest = std::max(steepest, std::acos((X_WT.q * Vector3::UnitZ()).z()));
    difference = std::max(difference, (X_WT.p - other.samples()[i].X_WT.p).norm());
  }
  EXPECT_LT(deepest, -2e-3);
  EXPECT_GT(deepest, -6.1e-3);
  EXPECT_GT(highest, 2e-3);
  EXPECT_GT(steepest, 0.6) << "beyond a vertex under the centre";
  EXPECT_GT(difference, 0.01);
}

TEST(RandomContact, ThePublishedMethodsEnergyIsMeasuredAndRepeats) {
  const StabilitySetup setup = setup_of("paper");
  const EnergyRow a = measure_energy(setup, 10.0, 3, [](double) {});
  const EnergyRow b = measure_energy(setup, 10.0, 3, [](double) {});
  EXPECT_EQ(a.given, b.given);
  EXPECT_EQ(a.excess, b.excess);
  EXPECT_GT(a.contacts, 5);
  EXPECT_GT(a.time_in_contact, 2.0);
  EXPECT_LT(a.time_in_contact, 9.0);
  EXPECT_GT(a.greatest_force, 0.5);
  EXPECT_GT(a.allowed, 0.0);
  EXPECT_GE(a.excess, a.worst_contact);
}

TEST(StabilityJson, HoldsEveryRowAndWritesInfinityAsNull) {
  StabilityReport report;
  report.setup = setup_of("paper");
  report.hand = "moderate";
  StabilityRow row;
  row.method = "paper";
  row.contact = "face";
  row.limit = {900.0, std::numeric_limits<double>::infinity(), 7};
  row.bounds = stiffness_bounds({report.setup.device, report.setup.hand, 1e-3, 0.0, 0.08});
  row.bounds.abbott_okamura = std::numeric_limits<double>::infinity();
  report.limits.push_back(row);
  report.energies.push_back({"paper", 0.08, 1000.0, 60.0, 12, 30.0, -0.1, 0.2, 0.0, 0.0, 3.0});
  const auto json = nlohmann::json::parse(stability_json(report));
  const auto& limit = json["largest_stable_stiffness"][0];
  EXPECT_EQ(limit["contact"], "face");
  EXPECT_EQ(limit["largest_stable_stiffness_N_per_m"], 900.0);
  EXPECT_TRUE(limit["smallest_unstable_stiffness_N_per_m"].is_null());
  EXPECT_TRUE(limit["abbott_okamura_bound_N_per_m"].is_null());
  EXPECT_NEAR(limit["ratio_to_linear"].get<double>(), 900.0 / row.bounds.linear, 1e-12);
  EXPECT_EQ(json["energy_in_random_contact"][0]["given_J"], -0.1);
  EXPECT_EQ(json["device"]["delay_s"], 1e-3);
  EXPECT_TRUE(json["device"]["max_force_N"].is_null());
  EXPECT_EQ(json["hand"]["name"], "moderate");
  EXPECT_FALSE(json["interrupted"]);
}

}  // namespace
}  // namespace tegotae
