// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/contact_transient.hpp>

#include <cmath>
#include <numbers>

namespace tegotae {

void ContactTransient::strike(const Vector3& n_W, double speed) noexcept {
  n_W_ = n_W;
  speed_ = speed;
  elapsed_ = 0.0;
}

Vector3 ContactTransient::advance(double dt) noexcept {
  if (!(parameters_.amplitude * speed_ > 0.0)) return Vector3::Zero();
  const double envelope = parameters_.amplitude * speed_ * std::exp(-parameters_.decay * elapsed_);
  Vector3 force = envelope * std::sin(2.0 * std::numbers::pi * parameters_.frequency * elapsed_) * n_W_;
  elapsed_ += dt;
  return force;
}

}  // namespace tegotae
