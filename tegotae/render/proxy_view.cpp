// SPDX-License-Identifier: Apache-2.0
// What people may see of the proxy's contacts.
#include <tegotae/render/proxy_method.hpp>

namespace tegotae {

void ProxyMethod::view(const RenderInput& /*input*/, const RenderOutput& /*output*/, ContactView& view) const noexcept {
  for (const NearContact& contact : tracker_.contacts()) {
    if (!contact.measured) continue;
    const Facing& facing = contact.now;
    view.add(ViewedPlane{facing.p_WB, facing.n_W, facing.gap, contact.tool_piece, contact.body, contact.body_piece});
    if (!contact.bristle.is_loaded() || !contact.friction.rubs()) continue;
    const Vector3 stretch_W = contact.bristle.stretch(contact.X_WB);
    const Vector3 anchor_W = contact.bristle.centre(X_WP_) - stretch_W;
    view.add(ViewedAnchor{anchor_W, stretch_W, contact.bristle.normal_force(), contact.bristle.is_slipping()});
  }
  // Gaps as they were before the step that the last linearisation made, less than a settled step ago.
  for (std::size_t i = 0; i < rows_.size(); ++i) {
    const bool is_solved = static_cast<int>(i) < problem_.contact_count();
    view.add(ViewedPoint{rows_[i].p_W, rows_[i].gap, is_solved ? solution_.multipliers[i] : 0.0});
  }
}

}  // namespace tegotae
