// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/experiment.hpp>
#include <tegotae/lab/input_error.hpp>
#include <tegotae/lab/scene_file.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>
#include <string>

namespace tegotae {
namespace {

using testing::HasSubstr;

TEST(Experiments, HaveNamesOfTheirOwnAndAllThatARunNeeds) {
  std::set<std::string> names;
  for (const Experiment& experiment : experiments()) {
    EXPECT_TRUE(names.insert(experiment.name).second) << experiment.name;
    EXPECT_FALSE(experiment.summary.empty());
    EXPECT_FALSE(experiment.notes.empty());
    EXPECT_FALSE(experiment.phases.empty());
    EXPECT_FALSE(experiment.figures.empty());
    ASSERT_FALSE(experiment.variants.empty());
    EXPECT_EQ(&find_experiment(experiment.name), &experiment);
  }
  EXPECT_EQ(names.count("paper-cube"), 1U);
}

TEST(Experiments, PhasesFollowEachOtherAndFiguresReadVariantsThatAreThere) {
  for (const Experiment& experiment : experiments()) {
    for (size_t i = 0; i < experiment.phases.size(); ++i) {
      EXPECT_LT(experiment.phases[i].begin, experiment.phases[i].end);
      if (i > 0) {
        EXPECT_EQ(experiment.phases[i].begin, experiment.phases[i - 1].end);
      }
    }
    for (const Figure& figure : experiment.figures) {
      for (const Panel& panel : figure.panels) {
        for (const Curve& curve : panel.curves) EXPECT_LT(curve.variant, experiment.variants.size()) << figure.name;
      }
    }
  }
}

TEST(Experiments, AnUnknownNameIsAnsweredWithThoseThereAre) {
  EXPECT_THAT([] { find_experiment("paper-cubes"); },
              testing::ThrowsMessage<InputError>(testing::AllOf(HasSubstr("'paper-cubes'"), HasSubstr("tool-18"))));
}

TEST(SceneFile, IsFoundForEveryExperiment) {
  for (const Experiment& experiment : experiments()) {
    EXPECT_TRUE(std::filesystem::exists(find_scene(experiment.scene))) << experiment.scene;
  }
}

TEST(SceneFile, SaysWhereItLooked) {
  EXPECT_THAT([] { find_scene("no-such-scene.xml"); }, testing::ThrowsMessage<InputError>(testing::AllOf(
                                                           HasSubstr(TEGOTAE_SCENES), HasSubstr("TEGOTAE_SCENES"))));
}

}  // namespace
}  // namespace tegotae
