// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/runtime/haptic_interface.hpp>

namespace tegotae {

/// How the interface's workspace, D, lies in the world, W.
struct WorkspaceSettings {
  double translation_scale = 1.0;  ///< s_t: the tool moves s_t times as far as the grip
  double rotation_scale = 1.0;     ///< s_r: and turns s_r times as far
  double force_scale = 1.0;        ///< N displayed for a newton of the world
  int clutch_button = -1;          ///< button (its number, from 0) that clutches while it is held down; negative: none
  /// The first pose that the interface reports holds the tool where the scene has it. False: both workspaces coincide
  /// there, so that without scales the interface's poses are the world's.
  bool from_first_pose = false;

  /// c: power at the interface over power in the world.
  double power_scale() const noexcept { return force_scale / translation_scale; }
  /// N m displayed for a newton metre of the world.
  double torque_scale() const noexcept { return power_scale() * rotation_scale; }
  /// Stiffness (N/m) as felt, of one of the world's: c s_t^2.
  double felt_stiffness(double stiffness) const noexcept { return force_scale * translation_scale * stiffness; }
  /// Rotational stiffness (N m/rad) as felt, of one of the world's: c s_r^2. Damping likewise.
  double felt_rotational_stiffness(double stiffness) const noexcept {
    return torque_scale() * rotation_scale * stiffness;
  }
  /// A length (m) at which rotation is weighed against translation, or an arm, as felt.
  double felt_arm(double arm) const noexcept { return rotation_scale / translation_scale * arm; }
};

/// Clutching, indexing and scaling between the interface's workspace and the world, both with the world's axes. With
/// v the velocity of the grip, w its angular velocity, and the wrench of the world (f, t) about the grip:
///
///     v_W = s_t v_D    w_W = s_r w_D    f_D = c s_t f_W    t_D = c s_r t_W,    c = force_scale / s_t
///
/// so f_D . v_D + t_D . w_D = c (f_W . v_W + t_W . w_W): what is passive on one side is passive on the other.
///
/// A pair of poses that belong together, one in D and one in W, is kept. Translation is scaled about it, so that a
/// motion and its reverse end where they began. Rotation is s_r times each small rotation of the grip, about the axis
/// it really turns about (for s_r = 1 simply the rotation since the pair): the tool always turns the way the hand does,
/// there is no orientation at which it leaps, and torque scales by one number; but for s_r other than 1 a closed motion
/// of the hand about several axes may leave the tool turned, as relative mappings do (Poupyrev, Weghorst and Fels,
/// "Non-isomorphic 3D rotational techniques", CHI 2000). Clutching re-bases the pair.
///
/// With scales of 1 and never clutched poses pass bit for bit. Does not allocate.
class WorkspaceMapping {
 public:
  /// The poses coincide at `X_W`, the fixed point of the scaling.
  WorkspaceMapping(const WorkspaceSettings& settings, const Pose& X_W) noexcept;

  /// The tool, where the grip is at `state`. While `clutched` it stays, at rest.
  InterfaceState to_world(const InterfaceState& state, bool clutched) noexcept;
  /// Where `to_world` would put the tool now, for looking only.
  Pose world_pose(const Pose& X_D) const noexcept;
  /// Where the grip is for a tool at `X_W`, near the present pair.
  Pose device_pose(const Pose& X_W) const noexcept;

  /// From now on a grip at `X_D` holds the tool at `X_W`.
  void rebase(const Pose& X_D, const Pose& X_W) noexcept;

  Wrench to_device(const Wrench& on_tool) const noexcept;
  Wrench to_world(const Wrench& on_grip) const noexcept;

  const WorkspaceSettings& settings() const noexcept { return settings_; }

 private:
  WorkspaceSettings settings_;
  Pose X_D_, X_W_;  ///< the pair
  Pose held_;       ///< the tool, as `to_world` put it last
  bool identical_;  ///< scales of 1, and the pair's poses are one
};

}  // namespace tegotae
