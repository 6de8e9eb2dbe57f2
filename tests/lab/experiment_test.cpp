// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/experiment.hpp>
#include <tegotae/lab/input_error.hpp>
#include <tegotae/lab/scene_file.hpp>
#include <tegotae/world/mujoco_world.hpp>

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
    EXPECT_FALSE(experiment.notes.empty() && experiment.paper_notes.empty());
    EXPECT_FALSE(experiment.phases.empty());
    EXPECT_FALSE(experiment.figures.empty());
    EXPECT_TRUE(experiment.reference) << experiment.name;
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

TEST(Experiments, DescribedForThePaperTellOfIt) {
  const Experiment cube = described_for(find_experiment("paper-cube"), "paper");
  EXPECT_THAT(cube.variants[0].summary, HasSubstr("the paper's equations"));
  EXPECT_THAT(cube.figures[0].title, HasSubstr("the paper's figure 5"));
  EXPECT_THAT(cube.notes, HasSubstr("as the paper saw"));
}

TEST(Experiments, DescribedForAnotherMethodDoNotSpeakOfThePapers) {
  for (const Experiment& experiment : experiments()) {
    const Experiment described = described_for(experiment, "adachi");
    EXPECT_THAT(described.notes, testing::Not(HasSubstr("paper")));
    EXPECT_EQ(described.notes, experiment.notes);
    for (const Variant& variant : described.variants) {
      EXPECT_THAT(variant.summary, testing::Not(HasSubstr("paper")));
      EXPECT_FALSE(variant.settings.constraint_set.has_value());
    }
    for (const Figure& figure : described.figures) {
      EXPECT_THAT(figure.title, testing::AllOf(HasSubstr("adachi"), testing::Not(HasSubstr("paper"))));
      for (const Panel& panel : figure.panels) {
        EXPECT_FALSE(panel.curves.empty()) << figure.name;
        for (const Curve& curve : panel.curves) {
          EXPECT_FALSE(curve.is_reference) << figure.name;
          EXPECT_LT(curve.variant, described.variants.size()) << figure.name;
        }
      }
    }
  }
  EXPECT_EQ(described_for(find_experiment("tilt-sweep"), "adachi").variants.size(), 1U);
  EXPECT_EQ(described_for(find_experiment("paper-cube"), "adachi").variants.size(), 2U);
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

TEST(SceneFile, OfEveryExperimentLoadsWithoutAWarning) {
  for (const Experiment& experiment : experiments()) {
    const auto world = load_mujoco_world(find_scene(experiment.scene), experiment.tool);
    EXPECT_TRUE(world->warnings().empty()) << experiment.scene << ": " << world->warnings().front();
    const Trajectory motion = experiment.motion(world->geometry().tool);
    EXPECT_EQ(motion.start(), experiment.phases.front().begin);
    EXPECT_NEAR(motion.end(), experiment.phases.back().end, 1e-9) << experiment.name;
  }
}

TEST(SceneFile, SaysWhereItLooked) {
  EXPECT_THAT([] { find_scene("no-such-scene.xml"); }, testing::ThrowsMessage<InputError>(testing::AllOf(
                                                           HasSubstr(TEGOTAE_SCENES), HasSubstr("TEGOTAE_SCENES"))));
}

}  // namespace
}  // namespace tegotae
