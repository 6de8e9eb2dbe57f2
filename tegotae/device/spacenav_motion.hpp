// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/axis_map.hpp>
#include <tegotae/math/pose.hpp>
#include <tegotae/math/twist.hpp>

#include <array>

namespace tegotae {

/// How far a 3-D mouse is pushed and turned, as libspnav tells: x to the right, y up, z away from the person, and turns
/// about them, a left-handed frame; kFull counts at its stops.
struct SpacenavDeflection {
  static constexpr int kFull = 350;

  std::array<int, 3> push{}, turn{};
};

/// What the tool does with a deflection.
struct SpacenavSettings {
  enum class Mode {
    kRate,    ///< moves as fast as the mouse is deflected, and stays where it was brought
    kOffset,  ///< is as far from the start as the mouse is deflected, and returns when it is let go
  };
  Mode mode = Mode::kRate;
  double speed = 0.1, turning_speed = 1.0;  ///< m/s and rad/s at full deflection, kRate
  double reach = 0.05, tilt = 0.5;          ///< m and rad at full deflection, kOffset
  double dead_zone = 0.05;                  ///< part of the full deflection that counts as none, each axis by itself
  /// From libspnav's frame made right-handed: x to the right, y up, z towards the person. The world's x is to the
  /// right, y away, z up, as the page shows the scenes.
  AxisMap axes{"x-zy"};
};

/// The tool in the hand of a 3-D mouse: from deflections, which come some ten times a second and in steps, to a motion
/// without steps. A deflection is approached with a time constant of 20 ms. Begins unrotated at the origin.
class SpacenavMotion {
 public:
  static constexpr double kTimeConstant = 0.02;  ///< s
  static constexpr double kLongestStep = 0.1;    ///< s that the tool moves at most between two calls

  explicit SpacenavMotion(const SpacenavSettings& settings) : settings_(settings) {}

  /// Goes on to `time` (s) with this deflection. Does not allocate.
  void advance(double time, const SpacenavDeflection& deflection) noexcept;

  const Pose& X_WT() const noexcept { return X_WT_; }
  /// Of the tool frame's origin, world axes; of the last step.
  const Twist& V_WT() const noexcept { return V_WT_; }

 private:
  Vector6 wanted(const SpacenavDeflection& deflection) const noexcept;

  SpacenavSettings settings_;
  Pose X_WT_;
  Twist V_WT_;
  Vector6 deflection_ = Vector6::Zero();  ///< smooth, -1 to 1: push, then turn, world axes
  double time_ = 0.0;
  bool has_begun_ = false;
};

}  // namespace tegotae
