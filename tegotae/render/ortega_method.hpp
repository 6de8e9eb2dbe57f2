// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/render/contact_rows.hpp>
#include <tegotae/shape/mass_properties.hpp>

namespace tegotae {

/// The six-degree-of-freedom god-object: constrained minus unconstrained acceleration.
///
/// Source: M. Ortega, S. Redon and S. Coquillart, "A six degree-of-freedom god-object method for haptic display of
/// rigid bodies", Proc. IEEE Virtual Reality (2006), and "... with surface properties", IEEE Trans. Visualization and
/// Computer Graphics 13(3) (2007). A copy of the tool that never enters anything is pulled to the interface's pose. Its
/// unconstrained acceleration a_u is in proportion to the way there; Gauss's principle of least constraint gives the
/// constrained one, the nearest that the contacts permit in the metric of the kinetic energy; what the contacts took
/// away is displayed:
///
///     a_c = arg min 1/2 (a - a_u)^T M (a - a_u)   subject to   J a >= 0,     displayed:  k_h M (a_c - a_u)
///
/// The motion is quasi-static: each step starts at rest.
///
/// As written here in displacements of one tick (x = a dt^2 / 2, the pull strong enough to arrive within the tick):
///
///     x_c = arg min 1/2 (x - x_u)^T K (x - x_u)   subject to   J_j x >= delta_j,    displayed:  K (x_c - x_u)
///
/// with x_u = [dr; dtheta] from the god-object to the interface, delta_j the depth of contact point j at the god-object
/// (negative while apart) and K = k M / m, R I R^T / m having its mean scaled to l^2: with l the tool's gyration length
/// K is k / m times the mass matrix. At rest that is the paper's least displacement, in the kinetic metric.
///
/// Parameters: stiffness k and metric length l of the coupling. Its damping d, K d / k on the change of x_c - x_u, is
/// ours, and 0 unless set: the source has none.
///
/// Ours: the planes and points as received stand in for the source's continuous collision detection between triangle
/// meshes, so the god-object keeps out of the planes to first order of its step; the rest of the step is undone in the
/// next. Points still apart are constraints too, so that no step passes them. Rows have `kRowCompliance` of the
/// coupling's compliance where the source's are hard: the god-object sinks in by that part of its stretch.
/// Left out: the god-object's own slower process (here both run in the tick), force shading, textures and friction.
/// Construction allocates; `render` does not, nor throws; linear in contact points.
class OrtegaMethod {
 public:
  /// The model is rendered as it was received, not interpolated.
  static constexpr bool kHoldsModel = true;

  /// `tool`: in the tool's frame. Throws std::invalid_argument unless it has a positive definite inertia.
  OrtegaMethod(const Coupling& coupling, const MassProperties& tool);

  void render(const RenderInput& input, RenderOutput& output) noexcept;

  /// Forgets the god-object: it starts where the hand holds the tool.
  void reset() noexcept;

  /// Takes the settings of `other`, and goes on as it is.
  void adopt(const OrtegaMethod& other) noexcept { coupling_ = other.coupling_; }

  /// Starts with the tool where the hand holds it, `X_WT`, and where the world let it be, `X_WP`.
  void start_at(const Pose& X_WP, const Pose& X_WT) noexcept;

  /// What the last `render`, of `input`, worked with.
  void view(const RenderInput& input, const RenderOutput& output, ContactView& view) const noexcept;

 private:
  void add_contacts(const RenderInput& input, const Vector3& centre_W) noexcept;

  Coupling coupling_;
  Vector3 p_TCm_;
  Matrix3 inertia_shape_T_;
  ConstraintProblem<6> problem_;
  ConstraintWorkspace<6> workspace_;
  ConstraintSolution<6> solution_;
  ConstraintSolver<6> solver_;
  ContactRows rows_;

  bool placed_ = false;
  Pose X_WP_;                                 ///< the god-object
  Vector6 stretch_before_ = Vector6::Zero();  ///< x_c - x_u of the last tick
};

}  // namespace tegotae
