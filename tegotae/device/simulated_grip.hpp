// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/pose.hpp>
#include <tegotae/math/twist.hpp>
#include <tegotae/math/wrench.hpp>

namespace tegotae {

/// Mechanics of an interface at its grip, alike in all directions.
struct GripMechanics {
  double mass = 0.2;                ///< kg, apparent at the grip
  double inertia = 1e-3;            ///< kg m^2, apparent, about the grip
  double damping = 0.0;             ///< N s/m
  double rotational_damping = 0.0;  ///< N m s/rad
  double friction_force = 0.0;      ///< N, Coulomb
  double friction_torque = 0.0;     ///< N m, Coulomb
};

/// A hand as it is felt at the grip, alike in all directions: its mass moves with the grip, a spring and a damper pull
/// the grip to where the person means it to be.
struct HandImpedance {
  double mass = 0.0;                  ///< kg
  double inertia = 0.0;               ///< kg m^2
  double damping = 0.0;               ///< N s/m
  double rotational_damping = 0.0;    ///< N m s/rad
  double stiffness = 0.0;             ///< N/m
  double rotational_stiffness = 0.0;  ///< N m/rad
};

/// Pose and velocity of the grip; the velocity is that of its frame's origin, in world axes.
struct GripState {
  Pose X_WG;
  Twist V_WG;
};

/// A rigid grip in a hand: m dv/dt = f + k (p_hand - p) + b_hand (v_hand - v) - b v - friction, and likewise in
/// rotation, with the rotation vector from the grip to the hand's orientation as displacement. The inertia is alike in
/// all directions, so there is no gyroscopic torque; the centre of mass is the grip frame's origin.
///
/// Integration: the implicit midpoint rule at a fixed sub-step h, Coulomb friction along the velocity at the end of the
/// sub-step, so that it sticks without chatter. Error: none for a constant wrench on a free mass; for spring and damper
/// of second order, a natural frequency w comes out low by (w h)^2/12 of itself (at h = 20 us and 1255 N/m on 50 g:
/// 8e-7); where friction reverses, the instant is wrong by up to h. Does not allocate.
class SimulatedGrip {
 public:
  /// `substep` in s. Throws std::invalid_argument where mass, inertia or sub-step is not positive or another value is
  /// negative or not finite.
  SimulatedGrip(const GripMechanics& mechanics, const HandImpedance& hand, double substep);

  /// Integrates `duration` (s, not negative) under the constant `wrench` of the motors, on the grip, about its origin,
  /// world axes. The hand means to be at `X_WH_begin` at its beginning and moves from there with the constant `V_WH`.
  void integrate(double duration, const Wrench& wrench, const Pose& X_WH_begin, const Twist& V_WH) noexcept;

  const GripState& state() const noexcept { return state_; }
  void set_state(const GripState& state) noexcept { state_ = state; }

  double mass() const noexcept { return translation_.inertia; }             ///< kg, of grip and hand
  double inertia() const noexcept { return rotation_.inertia; }             ///< kg m^2, of grip and hand
  double damping() const noexcept { return translation_.damping; }          ///< N s/m, of grip and hand
  double rotational_damping() const noexcept { return rotation_.damping; }  ///< N m s/rad, of grip and hand

 private:
  /// Translation or rotation: the same law in its own units.
  struct Axes {
    double inertia, damping, hand_damping, stiffness, friction;
    Vector3 next_velocity(double h, const Vector3& velocity, const Vector3& push, const Vector3& to_hand,
                          const Vector3& hand_velocity) const noexcept;
  };

  Axes translation_, rotation_;
  double substep_;
  GripState state_;
};

}  // namespace tegotae
