// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/passivity.hpp>

#include <tegotae/lab/tolerances.hpp>

#include <algorithm>

namespace tegotae {

PassivityObserver::Tick PassivityObserver::tick_of(const TickRecord& record) const noexcept {
  Tick tick;
  tick.X_WT = record.X_WT;
  const Wrench displayed = record.displayed;
  tick.on_grip = displayed.shifted(tick.X_WT.q * p_TCm_);
  const double torque_as_force = displayed.torque.norm() / coupling_.metric_length;
  tick.touches = displayed.force.norm() + torque_as_force > tolerance::kFreeWrench;
  return tick;
}

void PassivityObserver::add(const TickRecord& record) noexcept {
  const Tick now = tick_of(record);
  if (now.touches && !(started_ && before_.touches)) ++contacts_;
  if (now.touches) ++ticks_;
  // The tick that enters a contact counts: what it moved is what the spring will display.
  if (started_ && (before_.touches || now.touches)) add_step(now);
  if (!now.touches) {
    excess_ += episode_excess_;
    worst_ = worst_contact();
    episode_given_ = episode_allowed_ = episode_excess_ = 0.0;
  }
  before_ = now;
  started_ = true;
}

void PassivityObserver::add_step(const Tick& now) noexcept {
  const Vector6 at_grip = displacement(before_.X_WT, now.X_WT, Vector3::Zero());
  const Vector6 at_centre = displacement(before_.X_WT, now.X_WT, p_TCm_);
  const double work = before_.on_grip.force.dot(at_grip.head<3>()) + before_.on_grip.torque.dot(at_grip.tail<3>());
  const double l2 = coupling_.metric_length * coupling_.metric_length;
  const double own =
      0.5 * coupling_.stiffness * (at_centre.head<3>().squaredNorm() + l2 * at_centre.tail<3>().squaredNorm());
  given_ += work;
  allowed_ += own;
  episode_given_ += work;
  episode_allowed_ += own;
  episode_excess_ = std::max(episode_excess_, episode_given_ - episode_allowed_);
}

double PassivityObserver::worst_contact() const noexcept { return std::max(worst_, episode_excess_); }

}  // namespace tegotae
