// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/paper_method.hpp>

#include <tegotae/render/tolerances.hpp>

#include <algorithm>

namespace tegotae {

PaperMethod::PaperMethod(const Parameters& parameters, const Vector3& p_TCm)
    : parameters_(parameters),
      p_TCm_(p_TCm),
      problem_(kMaxContactPoints, 0),
      workspace_(problem_),
      solution_(problem_) {}

void PaperMethod::reset() noexcept {
  workspace_.reset();
  displacement_before_.setZero();
  started_ = false;
}

void PaperMethod::render(const RenderInput& input, RenderOutput& output) noexcept {
  if (!begin_render(input, output)) return;
  const Vector3 p_WCm = input.X_WT * p_TCm_;
  add_constraints(input, p_WCm, output);

  solver_.solve(problem_, displacement_before_, workspace_, solution_);
  output.status = status_of(solution_.status);
  if (solution_.status == ConstraintStatus::kInvalidInput) return;

  const Vector6& displacement = solution_.displacement;
  // A start in contact is no motion.
  if (!started_) displacement_before_ = displacement;
  started_ = true;
  output.wrench = parameters_.coupling.wrench(displacement, displacement_before_, input.dt);
  output.X_WP = displaced(input.X_WT, p_WCm, displacement.head<3>(), displacement.tail<3>());
  if (rows_.greatest_violation(problem_, solution_) > tolerance::kCompromise * output.deepest) {
    output.status = RenderStatus::kInfeasible;
  }
  output.active_count = static_cast<int>(solution_.active_rows.size());
  output.solver_iterations = solution_.newton_iterations;
  rows_.push_bodies(input.model, input.X_WT, solution_, output.bodies);
  displacement_before_ = displacement;
}

void PaperMethod::view(const RenderInput& input, const RenderOutput& /*output*/, ContactView& view) const noexcept {
  rows_.view(input.model, input.X_WT, solution_, view);
}

// Equation (1), one row a contact point: J = [n, r x n], b = -d.n, positive while it penetrates.
void PaperMethod::add_constraints(const RenderInput& input, const Vector3& p_WCm, RenderOutput& output) noexcept {
  const Coupling& coupling = parameters_.coupling;
  problem_.set_objective(coupling.stiffness_matrix(), Vector6::Zero());
  rows_.clear();
  visit_contact_points(input.model, input.X_WT, [&](const PointOnPlane& contact) {
    output.deepest = std::max(output.deepest, contact.depth);
    if (parameters_.constraint_set == ConstraintSet::kPenetratingPoints && contact.depth <= 0.0) return;
    const Vector6 J = normal_row(contact, p_WCm);
    rows_.add(contact, J, contact.depth, row_compliance(coupling, J), problem_);
  });
  output.constraint_count = rows_.count();
}

}  // namespace tegotae
