// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/friction_rule.hpp>

#include <gtest/gtest.h>

namespace tegotae {
namespace {

Shape surface(double friction, bool frictionless = false, int priority = 0) {
  Shape shape = make_sphere(0.01);
  shape.friction = friction;
  shape.frictionless = frictionless;
  shape.priority = priority;
  return shape;
}

TEST(FrictionRule, OfEqualPriorityTheGreaterCoefficientHolds) {
  for (const int priority : {-2, 0, 3}) {
    const SceneFriction both = scene_friction(surface(0.2, false, priority), surface(0.7, false, priority));
    EXPECT_EQ(both.coefficient, 0.7);
    EXPECT_FALSE(both.frictionless);
    EXPECT_FALSE(scene_friction(surface(0.2, true, priority), surface(0.7, false, priority)).frictionless);
    EXPECT_TRUE(scene_friction(surface(0.2, true, priority), surface(0.7, true, priority)).frictionless);
  }
}

TEST(FrictionRule, OfUnequalPriorityTheHigherOneSaysBoth) {
  const Shape low = surface(0.9, false, -1), high = surface(0.1, true, 2);
  for (const SceneFriction& both : {scene_friction(low, high), scene_friction(high, low)}) {
    EXPECT_EQ(both.coefficient, 0.1);
    EXPECT_TRUE(both.frictionless);
  }
  EXPECT_FALSE(scene_friction(surface(0.9, true, 0), surface(0.1, false, 1)).frictionless);
}

TEST(FrictionRule, SettingsScaleOrReplaceTheScenesCoefficient) {
  FrictionSettings settings;
  settings.scale = 0.5;
  settings.kinetic = 0.8;
  settings.viscous = 3.0;
  settings.compliance = 1e-8;
  FrictionLaw law = friction_law({0.6, false}, settings);
  EXPECT_DOUBLE_EQ(law.static_coefficient, 0.3);
  EXPECT_DOUBLE_EQ(law.kinetic_coefficient, 0.24);
  EXPECT_EQ(law.viscous, 3.0);
  EXPECT_EQ(law.compliance, 1e-8);
  settings.coefficient = 1.0;
  law = friction_law({0.6, false}, settings);
  EXPECT_DOUBLE_EQ(law.static_coefficient, 1.0);
  EXPECT_DOUBLE_EQ(law.kinetic_coefficient, 0.8);
}

TEST(FrictionRule, AFrictionlessPairStaysSo) {
  FrictionSettings settings;
  settings.coefficient = 1.0;
  settings.viscous = 3.0;
  EXPECT_FALSE(friction_law({0.6, true}, settings).rubs());
}

}  // namespace
}  // namespace tegotae
