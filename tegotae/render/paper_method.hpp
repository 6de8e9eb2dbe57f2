// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/render/contact_rows.hpp>

namespace tegotae {

/// Which contact points become constraints.
enum class ConstraintSet : std::uint8_t {
  kPenetratingPoints,  ///< those below their plane at the interface's pose: the paper, equation (1)
  kNearPoints,         ///< all of the model, the right-hand side negative while apart: the wrench is continuous
};

/// The method of Susu and Hasegawa: the tool is held directly by the interface; the wrench is that of a spring on the
/// least displacement [dr; dtheta] of the tool, in the coupling's metric, that undoes every penetration:
///
///     minimise 1/2 (|dr|^2 + l^2 |dtheta|^2)   subject to   n_i . (dtheta x r_ij + dr) >= -d_ij . n_i        (1)
///     f = k dr + d (dr - dr_before) / dt,   tau = l^2 (k dtheta + d (dtheta - dtheta_before) / dt)          (2), (3)
///
/// with plane i's normal n_i, contact point j, d_ij from the plane's point to the contact point and r_ij from the
/// tool's centre of mass to it. The paper's constraints are hard; here each has `kRowCompliance` of the coupling's, so
/// that multipliers are unique, which biases the force by that part.
/// Construction allocates; `render` does not, nor throws; linear in contact points.
class PaperMethod {
 public:
  struct Parameters {
    Coupling coupling;
    ConstraintSet constraint_set = ConstraintSet::kPenetratingPoints;
  };

  /// `p_TCm`: the tool's centre of mass in its frame, m.
  PaperMethod(const Parameters& parameters, const Vector3& p_TCm);

  void render(const RenderInput& input, RenderOutput& output) noexcept;

  /// Forgets the past: the damper starts from rest.
  void reset() noexcept;

  /// Takes the settings of `other`, and goes on as it is.
  void adopt(const PaperMethod& other) noexcept { parameters_ = other.parameters_; }

  /// Starts anew: it knows no pose but the interface's.
  void start_at(const Pose& /*X_WP*/, const Pose& /*X_WT*/) noexcept { reset(); }

  /// What the last `render`, of `input`, worked with.
  void view(const RenderInput& input, const RenderOutput& output, ContactView& view) const noexcept;

 private:
  void add_constraints(const RenderInput& input, const Vector3& p_WCm, RenderOutput& output) noexcept;

  Parameters parameters_;
  Vector3 p_TCm_;
  ConstraintProblem<6> problem_;
  ConstraintWorkspace<6> workspace_;
  ConstraintSolution<6> solution_;
  ConstraintSolver<6> solver_;
  ContactRows rows_;
  Vector6 displacement_before_ = Vector6::Zero();
  bool started_ = false;  ///< there is a displacement before
};

}  // namespace tegotae
