// SPDX-License-Identifier: Apache-2.0
#include <tests/random_shapes.hpp>
#include <tests/world/scene_files.hpp>

#include <cmath>

namespace tegotae {
namespace {

using test::kTool;
using test::no_impulses;
using test::states_of;

class Impulse : public test::SceneFiles {
 protected:
  // A ball with its centre of mass at the body's origin: its momenta are m v and I w, exactly.
  std::unique_ptr<MujocoWorld> ball_in_space(const std::string& option = "") const {
    return load("<option gravity='0 0 0' " + option + "/><worldbody>" + kTool +
                R"(<body name="ball" pos="0.3 0.2 1"><freejoint/>
                   <inertial pos="0 0 0" mass="2" diaginertia="0.01 0.01 0.01"/><geom size="0.1"/></body></worldbody>)");
  }
};

constexpr double kMass = 2.0, kInertia = 0.01;

void expect_momentum(const BodyState& state, const BodyImpulse& given) {
  EXPECT_LT((kMass * state.V_WB.linear - given.linear).norm(), 1e-9);
  EXPECT_LT((kInertia * state.V_WB.angular - given.angular).norm(), 1e-9);
}

TEST_F(Impulse, IsAppliedOnceAndOnlyOnce) {
  std::mt19937_64 random(31);
  for (const char* option : {"", "integrator='RK4'", "timestep='0.0005'"}) {
    const auto world = ball_in_space(option);
    BodyImpulse sum;
    for (const double duration : {0.05, 0.002, 0.001, 0.0123, 0.0007, 0.02}) {
      std::vector<BodyImpulse> impulses{{test::random_vector(random, 0.5), test::random_vector(random, 0.003)}};
      world->advance(duration, {}, impulses);
      sum.linear += impulses[0].linear;
      sum.angular += impulses[0].angular;
      expect_momentum(states_of(*world)[0], sum);
      world->advance(duration, {}, no_impulses(*world));
      expect_momentum(states_of(*world)[0], sum);
    }
    EXPECT_TRUE(world->diagnostics().is_healthy());
  }
}

// A force at the centre of mass of a body whose frame lies elsewhere turns nothing; the velocity that is read is that
// of the centre of mass. (Explicit integration of a turning body leaves errors of first order in the substep, so this
// body does not turn.)
TEST_F(Impulse, ActsAtTheCentreOfMass) {
  const auto world = load("<option gravity='0 0 0'/><worldbody>" + kTool +
                          R"(<body name="b" pos="1 2 3" quat="0.5 0.5 0.5 0.5"><freejoint/>
                             <inertial pos="0.1 -0.2 0.3" mass="2" diaginertia="0.02 0.03 0.04"/>
                             <geom size="0.1"/></body></worldbody>)");
  EXPECT_LT((world->geometry().bodies[0].p_BC - Vector3(0.1, -0.2, 0.3)).norm(), 1e-15);
  const Vector3 given(0.4, -0.3, 0.2);
  world->advance(0.01, {}, std::vector<BodyImpulse>{{given, Vector3::Zero()}});
  const BodyState state = states_of(*world)[0];
  EXPECT_LT((2.0 * state.V_WB.linear - given).norm(), 1e-9);
  EXPECT_LT(state.V_WB.angular.norm(), 1e-9);
}

// A pure torque turns the body about its centre of mass, which stays: the frame's origin moves.
TEST_F(Impulse, TorqueIsAboutTheCentreOfMass) {
  const auto world = load("<option gravity='0 0 0'/><worldbody>" + kTool +
                          R"(<body name="b"><freejoint/>
                             <inertial pos="0.1 0 0" mass="2" diaginertia="0.02 0.02 0.02"/>
                             <geom size="0.1"/></body></worldbody>)");
  const Vector3 given(0.0, 0.0, 1e-3);
  world->advance(0.002, {}, std::vector<BodyImpulse>{{Vector3::Zero(), given}});
  const BodyState state = states_of(*world)[0];
  EXPECT_LT((0.02 * state.V_WB.angular - given).norm(), 1e-9);
  EXPECT_LT(state.V_WB.linear.norm(), 1e-4 * state.V_WB.angular.norm() * 0.1);
  world->advance(0.1, {}, no_impulses(*world));
  const BodyState later = states_of(*world)[0];
  EXPECT_LT((later.X_WB * Vector3(0.1, 0.0, 0.0) - Vector3(0.1, 0.0, 0.0)).norm(), 1e-6);
  EXPECT_GT((later.X_WB.p - state.X_WB.p).norm(), 1e-4);
}

// The velocity that is read is the rate of the pose that is read.
TEST_F(Impulse, VelocityIsThatOfTheCentreOfMassInWorldAxes) {
  const auto world = load("<option gravity='0 0 0'/><worldbody>" + kTool +
                          R"(<body name="b" quat="0.8 0 0.6 0"><freejoint/>
                             <inertial pos="0.1 0 0.05" mass="2" diaginertia="0.02 0.02 0.02"/>
                             <geom size="0.1"/></body></worldbody>)");
  world->advance(0.002, {}, std::vector<BodyImpulse>{{{0.3, 0.1, 0.0}, {0.01, 0.02, 0.03}}});
  const Vector3 p_BC = world->geometry().bodies[0].p_BC;
  const BodyState before = states_of(*world)[0];
  const double dt = 1e-6;
  world->advance(dt, {}, no_impulses(*world));
  const BodyState after = states_of(*world)[0];
  const Vector6 moved = displacement(before.X_WB, after.X_WB, p_BC);
  EXPECT_LT((moved.head<3>() / dt - before.V_WB.linear).norm(), 1e-5);
  EXPECT_LT((moved.tail<3>() / dt - before.V_WB.angular).norm(), 1e-5);
  EXPECT_GT(before.V_WB.linear.norm(), 0.1);
}

// Semi-implicit Euler falls too far by g t h / 2, to rounding.
TEST_F(Impulse, FreeFallIsTheClosedFormWithinTheIntegratorsError) {
  const auto world =
      load("<worldbody>" + kTool + "<body pos='0 0 10'><freejoint/><geom size='0.1'/></body></worldbody>");
  double time = 0.0, fallen = 0.0;
  for (const double duration : {0.05, 0.003, 0.0011, 0.002}) {
    world->advance(duration, {}, no_impulses(*world));
    const int count = static_cast<int>(std::ceil(duration / 0.002 - 1e-9));
    const double h = duration / count;
    fallen += 9.81 * (time * duration + 0.5 * duration * duration + 0.5 * duration * h);
    time += duration;
    const BodyState state = states_of(*world)[0];
    EXPECT_NEAR(state.X_WB.p.z(), 10.0 - fallen, 1e-12);
    EXPECT_NEAR(state.V_WB.linear.z(), -9.81 * time, 1e-12);
    EXPECT_NEAR(world->time(), time, 1e-15);
  }
}

TEST_F(Impulse, SubstepsAreEqualAndNoLongerThanAskedFor) {
  const std::string scene =
      "<worldbody>" + kTool + "<body pos='0 0 10'><freejoint/><geom size='0.1'/></body></worldbody>";
  const auto substeps = [&](const std::string& option, double max_substep, double duration) {
    MujocoWorldOptions options;
    options.max_substep = max_substep;
    const auto world = load(option + scene, options);
    world->advance(duration, {}, no_impulses(*world));
    return world->diagnostics().substeps;
  };
  EXPECT_EQ(substeps("", 0.002, 0.05), 25U);
  EXPECT_EQ(substeps("", 0.002, 0.0021), 2U);
  EXPECT_EQ(substeps("", 0.002, 0.0001), 1U);
  EXPECT_EQ(substeps("<option timestep='0.01'/>", 0.002, 0.05), 25U);
  EXPECT_EQ(substeps("<option timestep='0.001'/>", 0.002, 0.05), 50U);
  EXPECT_EQ(substeps("", 0.0005, 0.003), 6U);
}

TEST_F(Impulse, WhatIsNotFiniteIsIgnoredAndCounted) {
  const auto world = ball_in_space();
  const double nan = std::nan("");
  world->advance(0.01, {}, std::vector<BodyImpulse>{{{nan, 0.0, 0.0}, Vector3::Zero()}});
  EXPECT_EQ(world->diagnostics().ignored_impulses, 1U);
  EXPECT_FALSE(world->diagnostics().is_healthy());
  expect_momentum(states_of(*world)[0], {});
}

TEST_F(Impulse, RefusesImpossibleCalls) {
  const auto world = ball_in_space();
  EXPECT_THROW(world->advance(0.0, {}, no_impulses(*world)), std::invalid_argument);
  EXPECT_THROW(world->advance(std::nan(""), {}, no_impulses(*world)), std::invalid_argument);
  EXPECT_THROW(world->advance(0.01, {}, {}), std::invalid_argument);
  std::vector<BodyState> too_many(2);
  EXPECT_THROW(world->read_bodies(too_many), std::invalid_argument);
}

}  // namespace
}  // namespace tegotae
