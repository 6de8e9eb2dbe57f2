// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/simulated_hand_interface.hpp>

namespace tegotae {

/// What a bound is computed for: a coupling of stiffness k and damping B in translation, k l^2 and B l^2 in rotation.
struct StiffnessBoundInput {
  SimulatedDevice device;
  HandImpedance hand;
  double period = 1e-3;        ///< T, of the haptic ticks, s
  double damping = 0.0;        ///< B, of the coupling, N s/m
  double metric_length = 1.0;  ///< l, m
};

/// Stiffnesses k (N/m) of the coupling up to which a held interface is stable or passive; each the least of what
/// translation and rotation (divided by l^2) permit. Infinite where nothing limits.
struct StiffnessBounds {
  /// Linear stability with the whole delay, T/2 of the hold and t_d of the device: (b + B)/(T/2 + t_d), b the damping
  /// of interface and hand. First order in the natural frequency times the delay.
  double linear_translation = 0.0;
  double linear_rotation = 0.0;  ///< (b_r/l^2 + B)/(T/2 + t_d)
  double linear = 0.0;           ///< the least of both

  /// Passivity against any passive hand, without delay: 2 (b - |B|)/T, b of the interface alone (Colgate and Schenkel,
  /// "Passivity of a class of sampled-data systems", J. Robotic Systems 14 (1997)). Not negative.
  double colgate_schenkel = 0.0;

  /// Passivity with encoder step D and Coulomb friction f_c, without delay: min(2 b/T, 2 f_c/D) (Abbott and Okamura,
  /// "Effects of position quantization and sampling rate on virtual-wall passivity", IEEE Trans. Robotics 21 (2005)).
  double abbott_okamura = 0.0;
};

StiffnessBounds stiffness_bounds(const StiffnessBoundInput& input) noexcept;

}  // namespace tegotae
