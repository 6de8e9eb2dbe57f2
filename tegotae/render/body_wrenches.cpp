// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/body_wrenches.hpp>

namespace tegotae {

void BodyWrenches::clear() noexcept {
  count_ = 0;
  static_bodies_ = {};
}

BodyWrench* BodyWrenches::find_or_add(const ContactPlane& plane) noexcept {
  if (plane.moving_index < 0) return &static_bodies_;
  for (int i = 0; i < count_; ++i) {
    if (bodies_[static_cast<size_t>(i)].moving_index == plane.moving_index) return &bodies_[static_cast<size_t>(i)];
  }
  // There are never more bodies than planes, and as many places as planes.
  BodyWrench& added = bodies_[static_cast<size_t>(count_++)];
  added = {plane.moving_index, plane.p_WC, {}};
  return &added;
}

void BodyWrenches::add(const ContactPlane& plane, const Vector3& p_W, const Vector3& force) noexcept {
  BodyWrench* body = find_or_add(plane);
  body->on_body.force += force;
  body->on_body.torque += (p_W - body->p_WC).cross(force);
}

void BodyWrenches::match(const Wrench& displayed, const Vector3& centre_W) noexcept {
  // About the world's origin, the opposite of what the hand feels, less what the bodies have been given.
  Wrench missing = -displayed.shifted(centre_W) - static_bodies_.on_body;
  double total = static_bodies_.on_body.force.norm();
  for (const BodyWrench& body : moving()) {
    missing = missing - body.on_body.shifted(body.p_WC);
    total += body.on_body.force.norm();
  }
  if (!(total > 0.0)) return;
  for (int i = 0; i < count_; ++i) {
    BodyWrench& body = bodies_[static_cast<size_t>(i)];
    const Wrench share = missing * (body.on_body.force.norm() / total);
    body.on_body = body.on_body + share.shifted(-body.p_WC);
  }
}

}  // namespace tegotae
