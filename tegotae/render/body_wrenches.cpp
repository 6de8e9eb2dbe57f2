// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/body_wrenches.hpp>

#include <algorithm>
#include <cmath>

namespace tegotae {
namespace {

struct BodyMass {
  double mass = 0.0;             // kg; 0: unknown
  double gyration_length = 0.0;  // m
};

BodyMass mass_of(std::span<const NearBody> near, int moving_index) noexcept {
  for (const NearBody& body : near) {
    if (body.moving_index == moving_index) return {body.mass, body.gyration_length};
  }
  return {};
}

// The push with no more force than may be given to the body where the hand feels `shown` (N), nor more torque than that
// force could have.
Wrench held(const Wrench& push, double shown, const BodyMass& body, double period) noexcept {
  const double amplified = BodyWrenches::kGreatestAmplification * shown;
  const bool known = body.mass > 0.0 && body.gyration_length > 0.0 && period > 0.0;
  const double thrown = known ? body.mass * BodyWrenches::kFastestThrow / period : amplified;
  const double most = std::clamp(thrown, shown, amplified);
  const double force = push.force.norm();
  double part = force > most ? most / force : 1.0;
  const double torque = push.torque.norm(), most_torque = BodyWrenches::kLongestArm * body.gyration_length * most;
  if (known && part * torque > most_torque) part = most_torque / torque;
  return push * part;
}

}  // namespace

void BodyWrenches::clear() noexcept {
  count_ = 0;
  static_bodies_ = {};
}

BodyWrench* BodyWrenches::find_or_add(int moving_index, const Vector3& p_WC) noexcept {
  if (moving_index < 0) return &static_bodies_;
  for (int i = 0; i < count_; ++i) {
    if (bodies_[static_cast<size_t>(i)].moving_index == moving_index) return &bodies_[static_cast<size_t>(i)];
  }
  // There are never more bodies than planes or near bodies, and as many places.
  static_assert(kMaxNearBodies <= kMaxPlanes);
  BodyWrench& added = bodies_[static_cast<size_t>(count_++)];
  added = {moving_index, p_WC, {}};
  return &added;
}

void BodyWrenches::add(const ContactPlane& plane, const Vector3& p_W, const Vector3& force) noexcept {
  add(plane.moving_index, plane.p_WC, p_W, force, Vector3::Zero());
}

void BodyWrenches::add(int moving_index, const Vector3& p_WC, const Vector3& p_W, const Vector3& force,
                       const Vector3& torque) noexcept {
  BodyWrench* body = find_or_add(moving_index, p_WC);
  body->on_body.force += force;
  body->on_body.torque += (p_W - body->p_WC).cross(force) + torque;
}

void BodyWrenches::share(const Wrench& displayed, const Vector3& centre_W, double length,
                         std::span<const NearBody> near, double period) noexcept {
  Wrench felt = -static_bodies_.on_body.shifted(-centre_W);
  for (const BodyWrench& body : moving()) felt = felt - body.on_body.shifted(body.p_WC - centre_W);
  const double per_arm = 1.0 / (length * length);
  const auto product = [per_arm](const Wrench& a, const Wrench& b) {
    return a.force.dot(b.force) + per_arm * a.torque.dot(b.torque);
  };
  const double felt_squared = product(felt, felt);
  // Damping may add to the elastic push, but does not turn it round.
  constexpr double kGreatestFactor = 2.0;
  const double factor =
      felt_squared > 0.0 ? std::clamp(product(displayed, felt) / felt_squared, 0.0, kGreatestFactor) : 0.0;
  const double shown = std::sqrt(product(displayed, displayed));
  for (int i = 0; i < count_; ++i) {
    BodyWrench& body = bodies_[static_cast<size_t>(i)];
    body.on_body = held(body.on_body * factor, shown, mass_of(near, body.moving_index), period);
  }
}

}  // namespace tegotae
