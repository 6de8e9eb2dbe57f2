// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/render/coupling.hpp>
#include <tegotae/runtime/tick_record.hpp>

namespace tegotae {

/// Watches the energy that a rendering gives to the hand, tick by tick (Hannaford and Ryu, "Time-domain passivity
/// control of haptic interfaces", IEEE Trans. Robotics and Automation 18 (2002)), and how much of it is more than a
/// sampled spring gives.
///
/// The wrench of a tick is held until the next one, so over it the hand receives F_k . dp + tau_k . dtheta. A passive
/// spring of stiffness k, sampled and held, gives back at most what it took and k/2 |dx|^2 a tick besides, |dx|^2 =
/// |dp|^2 + l^2 |dtheta|^2: over a motion of speed v that is the integral of k T v^2/2. Only ticks in contact count
/// for that, and each contact, from touching to leaving, is judged by itself: what friction takes in one is no credit
/// in another. No spring stores anything between contacts, so
///
///     excess = sum over contacts of max(0, greatest of (energy given - own energy of the sampled spring) so far)
///
/// is zero for a rendering that is passive but for being sampled. Does not allocate.
class PassivityObserver {
 public:
  /// `p_TCm`: the tool's centre of mass in its frame, m.
  PassivityObserver(const Coupling& coupling, const Vector3& p_TCm) noexcept : coupling_(coupling), p_TCm_(p_TCm) {}

  /// In order of time, one record a tick. What is displayed counts.
  void add(const TickRecord& record) noexcept;

  /// Another spring from the next tick on. What the one before took and did not give back stays with the contact.
  void change(const Coupling& coupling) noexcept { coupling_ = coupling; }

  double given() const noexcept { return given_; }      ///< J, energy given to the hand; negative: taken from it
  double allowed() const noexcept { return allowed_; }  ///< J, the sampled spring's own
  double excess() const noexcept { return excess_ + episode_excess_; }  ///< J, as defined above
  double worst_contact() const noexcept;                                ///< J, the greatest excess of one contact
  int contacts() const noexcept { return contacts_; }
  long ticks_in_contact() const noexcept { return ticks_; }

 private:
  struct Tick {
    Pose X_WT;
    Wrench on_grip;  ///< about the tool frame's origin, where it is held
    bool touches = false;
  };
  Tick tick_of(const TickRecord& record) const noexcept;
  void add_step(const Tick& now) noexcept;

  Coupling coupling_;
  Vector3 p_TCm_;
  bool started_ = false;
  Tick before_;
  double given_ = 0.0, allowed_ = 0.0, excess_ = 0.0, worst_ = 0.0;
  double episode_given_ = 0.0, episode_allowed_ = 0.0, episode_excess_ = 0.0;
  int contacts_ = 0;
  long ticks_ = 0;
};

}  // namespace tegotae
