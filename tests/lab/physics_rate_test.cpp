// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/experiment_run.hpp>
#include <tegotae/lab/motion.hpp>
#include <tegotae/lab/physics_rate.hpp>
#include <tests/lab/temporary_folder.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace tegotae {
namespace {

const char* const kSceneWithoutRate =
    "<mujoco><worldbody><geom type=\"box\" size=\"1 1 0.1\"/><body name=\"tool\" mocap=\"true\" pos=\"0 0 1\">"
    "<geom type=\"box\" size=\"0.1 0.1 0.1\"/></body></worldbody></mujoco>";

TEST(PhysicsRate, IsAsHighAsAThirdOfACoreAffords) {
  EXPECT_EQ(shortest_publish_period(0.0, 2e-3), 2e-3);
  EXPECT_EQ(shortest_publish_period(0.2e-3, 2e-3), 2e-3);     // 2 steps and 0.2 ms of 2 ms
  EXPECT_EQ(shortest_publish_period(0.3e-3, 2e-3), 4e-3);     // 3 steps and 0.2 ms of 4 ms
  EXPECT_EQ(shortest_publish_period(0.2e-3, 0.5e-3), 50e-3);  // the substeps alone take more than that
  EXPECT_EQ(shortest_publish_period(1.0, 2e-3), 50e-3);
}

TEST(PhysicsRate, MeasuredOneIsWithinItsLimitsAndSaidWhy) {
  const TemporaryFolder folder;
  const auto world = load_mujoco_world(folder.write("scene.xml", kSceneWithoutRate), "tool");
  const PhysicsRateChoice choice = measured_physics_rate(*world, 1000.0);
  EXPECT_GE(choice.rate, 20.0);
  EXPECT_LE(choice.rate, 500.0);
  EXPECT_THAT(choice.reason, testing::HasSubstr("chosen as a step of the scene takes"));
  EXPECT_LE(measured_physics_rate(*world, 10.0).rate, 10.0);
}

class UnsetRate : public testing::Test {
 protected:
  ExperimentResult perform(bool real_time, std::optional<double> rate) const {
    Experiment experiment;
    experiment.name = "short";
    experiment.scene = folder_.write("scene.xml", kSceneWithoutRate);
    experiment.tool = "tool";
    experiment.motion = [](const Tool&) {
      return sampled(0.0, 0.02, [](double) { return Pose{{0.0, 0.0, 1.0}, Quaternion::Identity()}; });
    };
    experiment.phases = {{"a", "all", 0.0, 0.02}};
    experiment.variants = {{"only", "", {}}};
    ExperimentRequest request;
    request.folder = folder_.path() / "out";
    request.real_time = real_time;
    request.settings.physics_rate = rate;
    return run_experiment(experiment, request, [](double) {});
  }

 private:
  TemporaryFolder folder_;
};

TEST_F(UnsetRate, IsMeasuredInRealTime) {
  const VariantResult result = perform(true, std::nullopt).variants.at(0);
  EXPECT_FALSE(result.physics_rate_choice.empty());
  EXPECT_LE(result.settings.physics_rate, 500.0);
}

TEST_F(UnsetRate, IsFixedInSimulatedTime) {
  const VariantResult result = perform(false, std::nullopt).variants.at(0);
  EXPECT_EQ(result.physics_rate_choice, "");
  EXPECT_EQ(result.settings.physics_rate, 500.0);
}

TEST_F(UnsetRate, IsNotMeasuredWhereARateIsSet) {
  const VariantResult result = perform(true, 50.0).variants.at(0);
  EXPECT_EQ(result.physics_rate_choice, "");
  EXPECT_EQ(result.settings.physics_rate, 50.0);
}

}  // namespace
}  // namespace tegotae
