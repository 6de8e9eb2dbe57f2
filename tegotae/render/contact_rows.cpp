// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/contact_rows.hpp>

#include <tegotae/render/tolerances.hpp>

#include <algorithm>

namespace tegotae {

bool begin_render(const RenderInput& input, RenderOutput& output) noexcept {
  output.bodies.clear();
  output.wrench = {};
  output.X_WP = input.X_WT;
  output.constraint_count = output.active_count = output.solver_iterations = 0;
  output.deepest = 0.0;
  output.pushing_out = false;
  output.status = input.model.sequence == 0 ? RenderStatus::kNoModel : RenderStatus::kOk;
  if (!input.X_WT.is_finite()) output.status = RenderStatus::kInvalidInput;
  return output.status == RenderStatus::kOk;
}

double deepest_penetration(const IntermediateRepresentation& model, const Pose& X_WT) noexcept {
  double deepest = 0.0;
  visit_contact_points(model, X_WT,
                       [&deepest](const PointOnPlane& contact) { deepest = std::max(deepest, contact.depth); });
  return deepest;
}

Vector6 normal_row(const PointOnPlane& contact, const Vector3& centre_W) noexcept {
  Vector6 J;
  J.head<3>() = contact.n_W;
  J.tail<3>() = (contact.p_WC - centre_W).cross(contact.n_W);
  return J;
}

double row_compliance(const Coupling& coupling, const Vector6& J) noexcept {
  const double per_arm = 1.0 / (coupling.metric_length * coupling.metric_length);
  return tolerance::kRowCompliance * (1.0 + per_arm * J.tail<3>().squaredNorm()) / coupling.stiffness;
}

RenderStatus status_of(ConstraintStatus status) noexcept {
  switch (status) {
    case ConstraintStatus::kConverged:
      return RenderStatus::kOk;
    case ConstraintStatus::kIterationLimit:
      return RenderStatus::kIterationLimit;
    case ConstraintStatus::kInfeasible:
      return RenderStatus::kInfeasible;
    case ConstraintStatus::kInvalidInput:
      break;
  }
  return RenderStatus::kInvalidInput;
}

void ContactRows::add(const PointOnPlane& contact, const Vector6& J, double b, double c,
                      ConstraintProblem<6>& problem) noexcept {
  if (count_ == kMaxContactPoints || !problem.add_contact(J, b, c)) return;
  sources_[static_cast<std::size_t>(count_++)] = {contact.plane, contact.point};
}

double ContactRows::greatest_violation(const ConstraintProblem<6>& problem,
                                       const ConstraintSolution<6>& solution) const noexcept {
  double greatest = 0.0;
  // Violation of a compliant row is its compliance times its force.
  for (const int row : solution.active_rows) {
    greatest = std::max(greatest, problem.c(row) * solution.multipliers[static_cast<std::size_t>(row)]);
  }
  return greatest;
}

// Rows stand in the order in which the points are visited.
void ContactRows::view(const IntermediateRepresentation& model, const Pose& X_WT, const ConstraintSolution<6>& solution,
                       ContactView& view) const noexcept {
  int row = 0;
  const auto force_of = [&](const PointOnPlane& contact) {
    if (row == count_) return 0.0;
    const auto at = static_cast<std::size_t>(row);
    if (sources_[at].plane != contact.plane || sources_[at].point != contact.point) return 0.0;
    ++row;
    return solution.multipliers[at];
  };
  view_contact_points(model, X_WT, force_of, view);
}

void ContactRows::push_bodies(const IntermediateRepresentation& model, const Pose& X_WT,
                              const ConstraintSolution<6>& solution, BodyWrenches& bodies) const noexcept {
  for (const int row : solution.active_rows) {
    const Source source = sources_[static_cast<std::size_t>(row)];
    const ContactPlane& plane = model.planes[static_cast<std::size_t>(source.plane)];
    const ContactPoint& point = model.points[static_cast<std::size_t>(source.point)];
    const Vector3 p_WC = X_WT * point.p_T.vector() - point.radius * plane.n_W.vector();
    bodies.add(plane, p_WC, -solution.multipliers[static_cast<std::size_t>(row)] * plane.n_W.vector());
  }
}

}  // namespace tegotae
