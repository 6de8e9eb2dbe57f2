// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/render/contact_rows.hpp>
#include <tegotae/shape/mass_properties.hpp>

namespace tegotae {

/// A simulated tool between the interface and the world: penalty contact, implicit integration, virtual coupling.
///
/// Source: M. A. Otaduy and M. C. Lin, "A modular haptic rendering algorithm for stable and transparent 6-DOF
/// manipulation", IEEE Trans. Robotics 22(4) (2006). The tool has a mass matrix M and moves by backward Euler at the
/// haptic rate, in one linear step u = dt v' of its six degrees of freedom:
///
///     M (v' - v) / dt = -k L e' - d L (e' - e) / dt + sum_j J_j^T f_j
///     f_j = max(0, k_c (delta_j - J_j u) - d_c J_j u / dt),    J_j = [n_j, r_j x n_j]
///     displayed:  k L e' + d L (e' - e) / dt                                       (the coupling's wrench)
///
/// with e = [dr; dtheta] from the interface to the tool, L = diag(1, 1, 1, l^2, l^2, l^2), delta_j the depth of contact
/// point j of the tool below its plane, and primes at the end of the tick. At rest the hand feels the coupling and the
/// contact springs in series: k N k_c / (k + N k_c) per metre on N points under the centre of mass.
///
/// Parameters: k, d, l of the coupling, as of every method here. The rest has defaults of ours, for we could not verify
/// those of the source: it asks for a small mass and contacts stiffer than the coupling, and gives its values for its
/// own interface and units.
///
/// Ours: which contacts push at the end of the step is solved together with the step (the same linear system with
/// f_j >= 0, by ConstraintSolver); the source takes those of the last collision query. Its linearised contact model is
/// the planes and points as received. The rotational coupling acts on the rotation vector, its Jacobian taken at small
/// stretch. Angular momentum is carried from tick to tick, which contains the gyroscopic term.
/// Left out: multiresolution collision detection and contact clustering (which bounds the stiffness of many contacts;
/// the implicit step is stable without), friction, the tool's weight.
/// Construction allocates; `render` does not, nor throws; linear in contact points.
class OtaduyLinMethod {
 public:
  /// The model is rendered as it was received, not interpolated.
  static constexpr bool kHoldsModel = true;

  struct Parameters {
    Coupling coupling;
    double mass = 0.01;  ///< of the simulated tool, kg, > 0; its inertia is the tool's, scaled alike. Ours.
    double contact_stiffness_ratio = 10.0;  ///< k_c / k of each contact point, > 0. Ours.
    double contact_damping = 0.0;           ///< d_c of each contact point, N s/m, >= 0. Ours.
  };

  /// `tool`: in the tool's frame. Throws std::invalid_argument where a parameter is out of range or the tool has no
  /// positive definite inertia.
  OtaduyLinMethod(const Parameters& parameters, const MassProperties& tool);

  void render(const RenderInput& input, RenderOutput& output) noexcept;

  /// Forgets the tool: it starts where the hand holds it, at rest.
  void reset() noexcept;

  /// Takes the settings of `other`, and goes on as it is.
  void adopt(const OtaduyLinMethod& other) noexcept { parameters_.coupling = other.parameters_.coupling; }

  /// Starts with the tool where the hand holds it, `X_WT`, and where the world let it be, `X_WP`, at rest.
  void start_at(const Pose& X_WP, const Pose& X_WT) noexcept;

  /// What the last `render`, of `input`, worked with.
  void view(const RenderInput& input, const RenderOutput& output, ContactView& view) const noexcept;

 private:
  void pose_step(const RenderInput& input, const Matrix6& M, const Vector6& stretch) noexcept;
  void add_contacts(const RenderInput& input, const Vector3& centre_W) noexcept;

  Parameters parameters_;
  Vector3 p_TCm_;
  Matrix3 inertia_shape_T_;
  double mean_inertia_;  ///< of the simulated tool, kg m^2
  ConstraintProblem<6> problem_;
  ConstraintWorkspace<6> workspace_;
  ConstraintSolution<6> solution_;
  ConstraintSolver<6> solver_;
  ContactRows rows_;

  bool placed_ = false;
  Pose X_WP_;                                 ///< the simulated tool
  Vector6 momentum_ = Vector6::Zero();        ///< M v: kg m/s; kg m^2/s about the centre of mass, world axes
  Vector6 stretch_before_ = Vector6::Zero();  ///< e at the end of the last tick
};

}  // namespace tegotae
