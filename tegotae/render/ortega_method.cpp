// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/ortega_method.hpp>

#include <tegotae/render/tool_inertia.hpp>

namespace tegotae {

OrtegaMethod::OrtegaMethod(const Coupling& coupling, const MassProperties& tool)
    : coupling_(coupling),
      p_TCm_(tool.centre_of_mass),
      inertia_shape_T_(unit_mean_inertia(tool)),
      problem_(kMaxContactPoints, 0),
      workspace_(problem_),
      solution_(problem_) {}

void OrtegaMethod::reset() noexcept {
  placed_ = false;
  workspace_.reset();
}

void OrtegaMethod::start_at(const Pose& X_WP, const Pose& X_WT) noexcept {
  reset();
  placed_ = true;
  X_WP_ = X_WP;
  stretch_before_ = displacement(X_WT, X_WP, p_TCm_);
}

void OrtegaMethod::view(const RenderInput& input, const RenderOutput& output, ContactView& view) const noexcept {
  rows_.view(input.model, output.X_WP, solution_, view);
}

void OrtegaMethod::render(const RenderInput& input, RenderOutput& output) noexcept {
  if (!begin_render(input, output)) return;
  output.deepest = deepest_penetration(input.model, input.X_WT);
  if (!placed_) {
    X_WP_ = input.X_WT;
    stretch_before_.setZero();
    placed_ = true;
  }
  const Vector3 centre_W = X_WP_ * p_TCm_;
  const double rotational = coupling_.stiffness * coupling_.metric_length * coupling_.metric_length;
  const Matrix6 K = rigid_body_matrix(coupling_.stiffness, rotational, inertia_shape_T_, X_WP_.rotation());
  problem_.set_objective(K, displacement(X_WP_, input.X_WT, p_TCm_));
  add_contacts(input, centre_W);
  output.constraint_count = rows_.count();

  solver_.solve(problem_, Vector6::Zero(), workspace_, solution_);
  output.status = status_of(solution_.status);
  if (solution_.status == ConstraintStatus::kInvalidInput) return;

  rows_.push_bodies(input.model, X_WP_, solution_, output.bodies);
  X_WP_ = displaced(X_WP_, centre_W, solution_.x.head<3>(), solution_.x.tail<3>());
  const Vector6& stretch = solution_.displacement;
  const double damping = coupling_.damping / (coupling_.stiffness * input.dt);
  const Vector6 felt = solution_.force + K * (damping * (stretch - stretch_before_));
  stretch_before_ = stretch;
  output.wrench = {felt.head<3>(), felt.tail<3>()};
  output.X_WP = X_WP_;
  output.active_count = static_cast<int>(solution_.active_rows.size());
  output.solver_iterations = solution_.newton_iterations;
}

void OrtegaMethod::add_contacts(const RenderInput& input, const Vector3& centre_W) noexcept {
  rows_.clear();
  visit_contact_points(input.model, X_WP_, [&](const PointOnPlane& contact) {
    const Vector6 J = normal_row(contact, centre_W);
    rows_.add(contact, J, contact.depth, row_compliance(coupling_, J), problem_);
  });
}

}  // namespace tegotae
