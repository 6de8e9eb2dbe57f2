// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/input_error.hpp>
#include <tegotae/lab/scripted_motion.hpp>

#include <gtest/gtest.h>

#include <string>

namespace tegotae {
namespace {

TEST(ScriptedMotion, EachBeginsAndEndsWhereTheHandIsAtTheSpeedOfAHand) {
  for (const ScriptedMotion& script : scripted_motions()) {
    SCOPED_TRACE(script.name);
    const Trajectory motion = script.motion(Vector3::UnitZ());
    EXPECT_GT(motion.end() - motion.start(), 0.5);
    for (const auto* sample : {&motion.samples().front(), &motion.samples().back()}) {
      EXPECT_LT(sample->X_WT.p.norm(), 1e-9);
      EXPECT_LT(sample->X_WT.q.vec().norm(), 1e-9);
    }
    double way = 0.0;
    for (const Trajectory::Sample& sample : motion.samples()) {
      const Twist V = motion.twist_at(sample.time);
      EXPECT_LT(V.linear.norm(), 1.0);
      EXPECT_LT(V.angular.norm(), 5.0);
      way = std::max(way, sample.X_WT.p.norm() + sample.X_WT.q.vec().norm());
    }
    EXPECT_GT(way, 0.02) << "it moves";
  }
}

TEST(ScriptedMotion, DownIsAgainstTheAxisThatPointsUp) {
  const ScriptedMotion& press = find_scripted_motion("press");
  for (const Vector3& up : {Vector3(Vector3::UnitZ()), Vector3(Vector3::UnitY())}) {
    const Trajectory motion = press.motion(up);
    EXPECT_NEAR(motion.at(2.0).p.dot(up), -0.06, 1e-9);
    EXPECT_NEAR(motion.at(2.0).p.norm(), 0.06, 1e-9);
  }
}

TEST(ScriptedMotion, AnUnknownNameIsRefusedWithThoseThereAre) {
  try {
    find_scripted_motion("jump");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("press, tap"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace tegotae
