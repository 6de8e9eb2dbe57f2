// SPDX-License-Identifier: Apache-2.0
#include <tegotae/runtime/impulse_sums.hpp>

#include <algorithm>

namespace tegotae {

void ImpulseAccumulator::add(CompensatedSum& sum, const Vector3& term) noexcept {
  // Knuth's two-sum: `total` and the rounding error together are sum.sum + addend exactly.
  const Vector3 addend = term + sum.error;
  const Vector3 total = sum.sum + addend;
  const Vector3 addend_part = total - sum.sum;
  const Vector3 sum_part = total - addend_part;
  sum.error = (sum.sum - sum_part) + (addend - addend_part);
  sum.sum = total;
}

void ImpulseAccumulator::add(int moving_index, const Wrench& wrench, double dt) noexcept {
  const Wrench impulse = wrench * dt;
  if (moving_index < 0 || moving_index >= kMaxMovingBodies || !impulse.is_finite()) {
    ++dropped_;
    return;
  }
  BodySum& body = bodies_[static_cast<std::size_t>(moving_index)];
  add(body.linear, impulse.force);
  add(body.angular, impulse.torque);
}

void ImpulseAccumulator::fill(ImpulseSums& message, int body_count) const noexcept {
  message.body_count = std::clamp(body_count, 0, kMaxMovingBodies);
  for (std::size_t i = 0; i < static_cast<std::size_t>(message.body_count); ++i) {
    message.bodies[i] = {bodies_[i].linear.sum, bodies_[i].angular.sum};
  }
}

bool ImpulseDifferences::take(const ImpulseSums& message, std::span<BodyImpulse> impulses) noexcept {
  std::fill(impulses.begin(), impulses.end(), BodyImpulse());
  if (message.sequence <= last_sequence_) return false;
  last_sequence_ = message.sequence;
  const auto held = static_cast<std::size_t>(std::clamp(message.body_count, 0, kMaxMovingBodies));
  const std::size_t count = std::min(held, impulses.size());
  for (std::size_t i = 0; i < count; ++i) {
    const ImpulseSum& now = message.bodies[i];
    impulses[i] = {now.linear.vector() - last_[i].linear.vector(), now.angular.vector() - last_[i].angular.vector()};
    last_[i] = now;
  }
  return true;
}

}  // namespace tegotae
