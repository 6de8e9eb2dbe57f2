// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/render/contact_rows.hpp>

namespace tegotae {

/// One point and one plane, force only (3-DoF): the first intermediate representation.
///
/// Source: Y. Adachi, T. Kumano and K. Ogino, "Intermediate representation for stiff virtual objects", Proc. IEEE
/// Virtual Reality Annual International Symposium (1995). The slow process sends the plane that touches the object
/// nearest to the hand; the fast one pushes the hand out of it, and keeps the plane until the next one comes:
///
///     f = max(0, k delta + d delta')  n,    tau = 0        while delta > 0
///
/// with delta the depth of the point below the plane of normal n.
///
/// Parameters: stiffness k and damping d of the coupling, as of every method here (the source tunes them to its
/// interface). The metric length has no meaning for a force alone.
///
/// Ours: the source's hand is a point. The tool's point is the contact point that is deepest, on the nearest plane,
/// when a model arrives; both are kept until the next model. The force acts as through the tool's centre of mass: no
/// torque is displayed. There is no proxy: X_WP is the interface's pose.
/// Left out: the source's device. What it has no answer to stays: the force steps when the plane is exchanged, objects
/// but the nearest are not felt, and a tool feels no torque.
/// Construction and `render` do not allocate; linear in contact points.
class AdachiMethod {
 public:
  /// The model is rendered as it was received, not interpolated.
  static constexpr bool kHoldsModel = true;

  /// `p_TCm`: the tool's centre of mass in its frame, m.
  AdachiMethod(const Coupling& coupling, const Vector3& p_TCm) : coupling_(coupling), p_TCm_(p_TCm) {}

  void render(const RenderInput& input, RenderOutput& output) noexcept;

  /// Forgets the point, the plane and the damper's past.
  void reset() noexcept;

  /// Takes the settings of `other`, and goes on as it is.
  void adopt(const AdachiMethod& other) noexcept { coupling_ = other.coupling_; }

  /// Starts anew: it knows no pose but the interface's.
  void start_at(const Pose& /*X_WP*/, const Pose& /*X_WT*/) noexcept { reset(); }

  /// What the last `render`, of `input`, worked with.
  void view(const RenderInput& input, const RenderOutput& output, ContactView& view) const noexcept;

 private:
  void choose(const IntermediateRepresentation& model, const Pose& X_WT) noexcept;

  Coupling coupling_;
  Vector3 p_TCm_;
  std::uint64_t sequence_ = 0;  ///< of the model that the choice was made from
  int plane_ = -1;              ///< index in the model, -1: nothing is near
  int point_ = -1;
  double penetration_before_ = 0.0;  ///< of the point in the last tick, m, >= 0
};

}  // namespace tegotae
