// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/types.hpp>
#include <tegotae/math/wrench.hpp>

#include <array>
#include <cstddef>

namespace tegotae {

/// What the energy bound knows of the interface and of the spring that is displayed on it, as felt at the grip.
struct EnergyBoundSettings {
  bool on = true;
  double stiffness = 9000.0;   ///< k, N/m, of the spring as it is felt
  double metric_length = 0.1;  ///< l, m: k l^2 in rotation
  double delay = 0.0;          ///< s, from writing a command to its being displayed, as far as it is known

  /// N s/m and N m s/rad: damping that the interface's rating vouches for. An interface that is rated for a stiffness
  /// K at its own period T swallows what a sampled spring of K gives, so has at least K T/2 (Colgate and Schenkel,
  /// "Passivity of a class of sampled-data systems", J. Robotic Systems 14 (1997)).
  double own_damping = 0.0;
  double own_rotational_damping = 0.0;

  /// m, of the measured position; 0: none. A damper on it is noise of so many metres a tick times its strength: it is
  /// made no stronger than `noise` (N) of that permits.
  double encoder_step = 0.0;
  double noise = 0.06;

  /// J, of what was dissipated, that may be given back later. Small: an hour of rubbing is no credit for a vibration.
  /// A tenth of a millijoule lifts a hand of 0.4 kg by 25 um.
  double carried = 1e-4;
  /// J that the controller still tries to take back: what a motion of 0.5 kg at 0.2 m/s holds. Bodies of the world may
  /// give more (a weight that is let down); that is theirs to give.
  double debt = 1e-2;
};

/// What the hand did since the last call, and what is to be displayed.
struct EnergyBoundInput {
  Vector6 moved = Vector6::Zero();  ///< displacement of the grip since the last call: [m; rad], world axes
  /// The part of `moved` that changed the spring's stretch, which a tool that slides along does not: what is braked.
  Vector6 stretched = Vector6::Zero();
  Wrench target;            ///< on the hand, torque about the grip
  double stretch = 0.0;     ///< m, of the spring now, as felt at the grip, about the centre of the coupling
  double turn = 0.0;        ///< rad
  double part = 1.0;        ///< of the spring's wrench that `target` is, in [0, 1]
  double max_force = 15.0;  ///< N and N m: where the display will be cut
  double max_torque = 1.0;
  double dt = 1e-3;  ///< s since the last call
};

/// Passivity observer and controller at the port to the hand, in six degrees of freedom (after Hannaford and Ryu,
/// "Time-domain passivity control of haptic interfaces", IEEE Trans. Robotics and Automation 18 (2002)).
///
/// Observer. The wrench that was displayed over the last call's period was held, so it gave the hand exactly
/// W . [dp; dtheta] (a displacement and a rotation vector; with the interface's known delay, the wrench that it showed
/// then). The spring between hand and tool stores H, known from its stretch; the interface swallows b ds.dx/dt of its
/// own, ds the part of dx that stretches the spring. What is left,
///
///     level += - W . dx - (H_now - H_before) + b ds . dx / dt,
///
/// is what was dissipated; a sampled spring alone makes it fall by k |dx|^2/2 a tick. Classical observers compare the
/// energy absorbed with zero, and so let a vibration about a steady press live on the energy that the press has stored:
/// here what is stored cannot be spent. `level` stays between -debt and carried, and forgets where nothing is
/// displayed.
///
/// Controller. Below zero, a damper that takes the deficit back in one period at the present speed: -a v, -a l^2 w, of
/// the part of the motion that stretches the spring (braking all of it would pay for a vibration by holding back the
/// slide that it rides on), with a at most four times what a spring of k sampled at dt and delayed by t_d gives away,
/// 4 k (dt/2 + t_d), and never more than the target itself (it brakes, it does not pull). A pure function of its
/// arguments; does not allocate.
class EnergyBound {
 public:
  /// The target, with the damper's wrench where it acts. `before`: the wrench that was commanded last.
  Wrench apply(const EnergyBoundSettings& settings, const EnergyBoundInput& input, const Wrench& before) noexcept;

  /// Forgets: nothing is displayed.
  void reset() noexcept { *this = EnergyBound(); }

  double level() const noexcept { return level_; }      ///< J, see above
  double damping() const noexcept { return damping_; }  ///< N s/m, of the last call

 private:
  static constexpr std::size_t kMostDelay = 15;  // calls

  const Wrench& shown(const EnergyBoundSettings& settings, double dt, const Wrench& before) noexcept;
  void observe(const EnergyBoundSettings& settings, const EnergyBoundInput& input, const Wrench& shown) noexcept;

  std::array<Wrench, kMostDelay + 1> commanded_{};  ///< a ring
  std::size_t newest_ = 0;
  double level_ = 0.0;
  double stretch_ = 0.0, turn_ = 0.0;  ///< of the last call
  double damping_ = 0.0;
};

}  // namespace tegotae
