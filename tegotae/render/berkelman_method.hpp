// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/render/contact_rows.hpp>

#include <optional>

namespace tegotae {

/// A spring and a damper at every contact point, summed.
///
/// Source: P. J. Berkelman and R. L. Hollis, "Lorentz magnetic levitation for haptic interaction: device design,
/// performance, and integration with physical simulations", Int. J. Robotics Research 19(7) (2000). The simulation
/// sends the contact points and their normals; the controller of the interface sums their pushes at its own rate:
///
///     f_j = max(0, k delta_j + d delta_j')  n_j  where delta_j > 0,    f = sum f_j,    tau = sum r_j x f_j
///
/// with delta_j the depth of contact point j below its plane and r_j the vector to it from the tool's centre of mass.
///
/// Parameters: stiffness k and damping d of the coupling, here of each point. The metric length has no meaning: the
/// torque is that of the forces. So the stiffness that is felt grows with the number of points: 4 k on a cube's face.
///
/// Ours: a point never pulls. The speed of a point is that of the tool against the plane as received. There is no
/// proxy: X_WP is the interface's pose.
/// Left out: the coupling by position and force with a free tool of the simulation, in motion without contact (here
/// the interface holds the tool), and friction.
/// Construction and `render` do not allocate; linear in contact points.
class BerkelmanMethod {
 public:
  /// The model is rendered as it was received, not interpolated.
  static constexpr bool kHoldsModel = true;

  /// `p_TCm`: the tool's centre of mass in its frame, m.
  BerkelmanMethod(const Coupling& coupling, const Vector3& p_TCm) : coupling_(coupling), p_TCm_(p_TCm) {}

  void render(const RenderInput& input, RenderOutput& output) noexcept;

  /// Forgets the past: the dampers start from rest.
  void reset() noexcept { X_WT_before_.reset(); }

  /// Takes the settings of `other`, and goes on as it is.
  void adopt(const BerkelmanMethod& other) noexcept { coupling_ = other.coupling_; }

  /// Starts anew: it knows no pose but the interface's.
  void start_at(const Pose& /*X_WP*/, const Pose& /*X_WT*/) noexcept { reset(); }

  /// What the last `render`, of `input`, worked with.
  void view(const RenderInput& input, const RenderOutput& output, ContactView& view) const noexcept;

 private:
  Coupling coupling_;
  Vector3 p_TCm_;
  std::optional<Pose> X_WT_before_;
};

}  // namespace tegotae
