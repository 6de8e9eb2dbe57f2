// SPDX-License-Identifier: Apache-2.0
#include <tegotae/runtime/workspace_mapping.hpp>

#include <tegotae/math/rotation.hpp>

namespace tegotae {
namespace {

bool is_unscaled(const WorkspaceSettings& settings) noexcept {
  return settings.translation_scale == 1.0 && settings.rotation_scale == 1.0;
}

// The rotation from `from` to `to` (the shorter way), `scale` times, after `base`.
Quaternion turned(const Quaternion& base, const Quaternion& from, const Quaternion& to, double scale) noexcept {
  const Quaternion turn = to * from.conjugate();
  if (scale == 1.0) return (turn * base).normalized();
  return (rotation_from_vector(scale * rotation_vector(turn)) * base).normalized();
}

}  // namespace

WorkspaceMapping::WorkspaceMapping(const WorkspaceSettings& settings, const Pose& X_W) noexcept
    : settings_(settings), X_D_(X_W), X_W_(X_W), held_(X_W), identical_(is_unscaled(settings)) {}

void WorkspaceMapping::rebase(const Pose& X_D, const Pose& X_W) noexcept {
  X_D_ = X_D;
  X_W_ = X_W;
  identical_ = is_unscaled(settings_) && X_D.p == X_W.p && X_D.q.coeffs() == X_W.q.coeffs();
}

Pose WorkspaceMapping::world_pose(const Pose& X_D) const noexcept {
  if (identical_) return X_D;
  return {X_W_.p + settings_.translation_scale * (X_D.p - X_D_.p),
          turned(X_W_.q, X_D_.q, X_D.q, settings_.rotation_scale)};
}

Pose WorkspaceMapping::device_pose(const Pose& X_W) const noexcept {
  if (identical_) return X_W;
  return {X_D_.p + (X_W.p - X_W_.p) / settings_.translation_scale,
          turned(X_D_.q, X_W_.q, X_W.q, 1.0 / settings_.rotation_scale)};
}

InterfaceState WorkspaceMapping::to_world(const InterfaceState& state, bool clutched) noexcept {
  InterfaceState result = state;
  if (clutched) {
    result.X_WT = held_;
    result.V_WT = {};
    rebase(state.X_WT, held_);
    return result;
  }
  result.X_WT = world_pose(state.X_WT);
  result.V_WT = {settings_.translation_scale * state.V_WT.linear, settings_.rotation_scale * state.V_WT.angular};
  held_ = result.X_WT;
  // The rotation goes on from here; the point that translation is scaled about stays.
  if (settings_.rotation_scale != 1.0) {
    X_D_.q = state.X_WT.q;
    X_W_.q = result.X_WT.q;
  }
  return result;
}

Wrench WorkspaceMapping::to_device(const Wrench& on_tool) const noexcept {
  return {settings_.force_scale * on_tool.force, settings_.torque_scale() * on_tool.torque};
}

Wrench WorkspaceMapping::to_world(const Wrench& on_grip) const noexcept {
  return {on_grip.force / settings_.force_scale, on_grip.torque / settings_.torque_scale()};
}

}  // namespace tegotae
