// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/playback_interface.hpp>
#include <tegotae/math/rotation.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace tegotae {
namespace {

Pose at(double x, double angle) { return {{x, 0.0, 0.0}, rotation_from_vector({0.0, 0.0, angle})}; }

TEST(Trajectory, IsLinearAndSlerpBetweenSamplesAndHeldOutside) {
  const Trajectory trajectory({{1.0, at(0.0, 0.0)}, {2.0, at(1.0, 0.5)}, {4.0, at(1.0, 0.5)}});
  EXPECT_EQ(trajectory.at(0.0).p.x(), 0.0);
  EXPECT_NEAR(trajectory.at(1.25).p.x(), 0.25, 1e-15);
  EXPECT_NEAR(rotation_vector(trajectory.at(1.25).q).z(), 0.125, 1e-14);
  EXPECT_EQ(trajectory.at(2.0).p.x(), 1.0);
  EXPECT_EQ(trajectory.at(9.0).p.x(), 1.0);
}

TEST(Trajectory, TwistIsTheSlopeOfTheSegment) {
  const Trajectory trajectory({{0.0, at(0.0, 0.0)}, {0.5, at(1.0, 0.5)}, {1.0, at(1.0, 0.5)}});
  EXPECT_NEAR(trajectory.twist_at(0.0).linear.x(), 2.0, 1e-14);
  EXPECT_NEAR(trajectory.twist_at(0.25).angular.z(), 1.0, 1e-14);
  EXPECT_EQ(trajectory.twist_at(0.75).linear.norm(), 0.0);
  EXPECT_EQ(trajectory.twist_at(-1.0).linear.norm(), 0.0);
  EXPECT_EQ(trajectory.twist_at(1.0).linear.norm(), 0.0);
}

TEST(Trajectory, RefusesWhatIsNoMotion) {
  EXPECT_THROW(Trajectory({}), std::invalid_argument);
  EXPECT_THROW(Trajectory({{1.0, at(0.0, 0.0)}, {1.0, at(0.0, 0.0)}}), std::invalid_argument);
  EXPECT_THROW(Trajectory({{1.0, at(0.0, 0.0)}, {0.5, at(0.0, 0.0)}}), std::invalid_argument);
  EXPECT_THROW(Trajectory({{std::nan(""), at(0.0, 0.0)}}), std::invalid_argument);
  EXPECT_THROW(Trajectory({{0.0, at(std::numeric_limits<double>::infinity(), 0.0)}}), std::invalid_argument);
}

TEST(PlaybackInterface, PlaysFromTheStartAndKeepsWhatItIsTold) {
  PlaybackInterface interface(Trajectory({{10.0, at(0.0, 0.0)}, {11.0, at(1.0, 0.0)}}));
  InterfaceState state;
  EXPECT_EQ(interface.read(0.5, state), InterfaceStatus::kOk);
  EXPECT_EQ(state.time, 0.5);
  EXPECT_NEAR(state.X_WT.p.x(), 0.5, 1e-15);
  EXPECT_NEAR(state.V_WT.linear.x(), 1.0, 1e-15);
  EXPECT_EQ(interface.write({{Vector3(1.0, 2.0, 3.0), Vector3::Zero()}, 0.0}), InterfaceStatus::kOk);
  EXPECT_EQ(interface.last_command().wrench.force, Vector3(1.0, 2.0, 3.0));
  EXPECT_EQ(interface.capability().name, "playback");
}

}  // namespace
}  // namespace tegotae
