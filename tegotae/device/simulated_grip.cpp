// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/simulated_grip.hpp>

#include <tegotae/math/rotation.hpp>

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <stdexcept>
#include <string>

namespace tegotae {
namespace {

void require(bool fine, const char* what, double value) {
  if (!fine || !std::isfinite(value)) {
    throw std::invalid_argument("the simulated grip's " + std::string(what) +
                                " is out of range: " + std::to_string(value));
  }
}

struct NamedValue {
  const char* name;
  double value;
};

void check(const GripMechanics& grip, const HandImpedance& hand, double substep) {
  require(grip.mass > 0.0, "mass (kg, above 0)", grip.mass);
  require(grip.inertia > 0.0, "inertia (kg m^2, above 0)", grip.inertia);
  require(substep > 0.0, "sub-step (s, above 0)", substep);
  for (const NamedValue& each : {NamedValue{"damping (N s/m)", grip.damping},
                                 {"rotational damping (N m s/rad)", grip.rotational_damping},
                                 {"friction force (N)", grip.friction_force},
                                 {"friction torque (N m)", grip.friction_torque},
                                 {"hand's mass (kg)", hand.mass},
                                 {"hand's inertia (kg m^2)", hand.inertia},
                                 {"hand's damping (N s/m)", hand.damping},
                                 {"hand's rotational damping (N m s/rad)", hand.rotational_damping},
                                 {"hand's stiffness (N/m)", hand.stiffness},
                                 {"hand's rotational stiffness (N m/rad)", hand.rotational_stiffness}}) {
    require(each.value >= 0.0, each.name, each.value);
  }
}

}  // namespace

SimulatedGrip::SimulatedGrip(const GripMechanics& mechanics, const HandImpedance& hand, double substep)
    : translation_{mechanics.mass + hand.mass, mechanics.damping + hand.damping, hand.damping, hand.stiffness,
                   mechanics.friction_force},
      rotation_{mechanics.inertia + hand.inertia, mechanics.rotational_damping + hand.rotational_damping,
                hand.rotational_damping, hand.rotational_stiffness, mechanics.friction_torque},
      substep_(substep) {
  check(mechanics, hand, substep);
}

// The midpoint rule solved for the velocity v' at the end of the sub-step: the displacement to the hand at its middle
// is to_hand - h/4 (v + v'), `to_hand` from the grip at the beginning to the hand at the middle.
Vector3 SimulatedGrip::Axes::next_velocity(double h, const Vector3& velocity, const Vector3& push,
                                           const Vector3& to_hand, const Vector3& hand_velocity) const noexcept {
  const double resistance = 0.5 * damping + 0.25 * h * stiffness;
  const Vector3 drive =
      (inertia / h - resistance) * velocity + push + stiffness * to_hand + hand_damping * hand_velocity;
  double sliding = 1.0;
  if (friction > 0.0) {
    const double size = drive.norm();
    sliding = size > friction ? 1.0 - friction / size : 0.0;
  }
  return sliding / (inertia / h + resistance) * drive;
}

void SimulatedGrip::integrate(double duration, const Wrench& wrench, const Pose& X_WH_begin,
                              const Twist& V_WH) noexcept {
  if (!(duration > 0.0)) return;
  // A whole number of sub-steps, of equal length, none longer than the one set (but for rounding).
  constexpr double kRounding = 1e-6;
  const long count = std::max(1L, static_cast<long>(std::ceil(duration / substep_ - kRounding)));
  const double h = duration / static_cast<double>(count);
  const Quaternion turn = rotation_from_vector(h * V_WH.angular);
  Pose X_WH = X_WH_begin;  // at the middle of the sub-step
  X_WH.p += 0.5 * h * V_WH.linear;
  X_WH.q = rotation_from_vector(0.5 * h * V_WH.angular) * X_WH.q;
  auto& [X_WG, V_WG] = state_;
  for (long i = 0; i < count; ++i) {
    const Vector3 v = translation_.next_velocity(h, V_WG.linear, wrench.force, X_WH.p - X_WG.p, V_WH.linear);
    const Vector3 to_hand =
        rotation_.stiffness > 0.0 ? rotation_vector(X_WH.q * X_WG.q.conjugate()) : Vector3(Vector3::Zero());
    const Vector3 w = rotation_.next_velocity(h, V_WG.angular, wrench.torque, to_hand, V_WH.angular);
    X_WG.p += 0.5 * h * (V_WG.linear + v);
    X_WG.q = (rotation_from_vector(0.5 * h * (V_WG.angular + w)) * X_WG.q).normalized();
    V_WG = {v, w};
    X_WH.p += h * V_WH.linear;
    X_WH.q = turn * X_WH.q;
  }
}

}  // namespace tegotae
