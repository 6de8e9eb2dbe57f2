// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/berkelman_method.hpp>

#include <algorithm>

namespace tegotae {

void BerkelmanMethod::render(const RenderInput& input, RenderOutput& output) noexcept {
  if (!begin_render(input, output)) return;
  const Vector3 p_WCm = input.X_WT * p_TCm_;
  const Pose X_before = X_WT_before_.value_or(input.X_WT);
  Wrench sum;
  visit_contact_points(input.model, input.X_WT, [&](const PointOnPlane& contact) {
    ++output.constraint_count;
    output.deepest = std::max(output.deepest, contact.depth);
    if (contact.depth <= 0.0) return;
    const auto plane = static_cast<std::size_t>(contact.plane);
    const Vector3 p_before = X_before * input.model.points[static_cast<std::size_t>(contact.point)].p_T.vector();
    // A point has not pressed its spring before it touched.
    const double before = std::max(0.0, contact.depth + contact.n_W.dot(contact.p_WC - p_before));
    const double rate = (contact.depth - before) / input.dt;
    const double push = coupling_.stiffness * contact.depth + coupling_.damping * rate;
    if (push <= 0.0) return;
    const Vector3 force = push * contact.n_W;
    sum = sum + Wrench{force, (contact.p_WC - p_WCm).cross(force)};
    ++output.active_count;
    output.bodies.add(input.model.planes[plane], contact.p_WC, -force);
  });
  X_WT_before_ = input.X_WT;
  if (sum.is_finite()) {
    output.wrench = sum;
    return;
  }
  output.status = RenderStatus::kInvalidInput;
  output.bodies.clear();
}

// The damper's part is left out: it needs the tick before.
void BerkelmanMethod::view(const RenderInput& input, const RenderOutput& /*output*/, ContactView& view) const noexcept {
  const auto force_of = [&](const PointOnPlane& contact) { return std::max(0.0, coupling_.stiffness * contact.depth); };
  view_contact_points(input.model, input.X_WT, force_of, view);
}

}  // namespace tegotae
