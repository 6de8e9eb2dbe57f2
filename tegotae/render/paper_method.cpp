// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/paper_method.hpp>
#include <tegotae/render/tolerances.hpp>

#include <algorithm>

namespace tegotae {
namespace {

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

}  // namespace

PaperMethod::PaperMethod(const Parameters& parameters, const Vector3& p_TCm)
    : parameters_(parameters),
      p_TCm_(p_TCm),
      problem_(kMaxContactPoints, 0),
      workspace_(problem_),
      solution_(problem_) {}

void PaperMethod::reset() noexcept {
  workspace_.reset();
  displacement_before_.setZero();
}

void PaperMethod::render(const RenderInput& input, RenderOutput& output) noexcept {
  output.bodies.clear();
  output.wrench = {};
  output.X_WP = input.X_WT;
  output.active_count = output.solver_iterations = 0;
  const Vector3 p_WCm = input.X_WT * p_TCm_;
  if (!add_constraints(input, p_WCm, output)) return;

  solver_.solve(problem_, displacement_before_, workspace_, solution_);
  output.status = status_of(solution_.status);
  if (solution_.status == ConstraintStatus::kInvalidInput) return;

  const Vector6& displacement = solution_.displacement;
  output.wrench = parameters_.coupling.wrench(displacement, displacement_before_, input.dt);
  output.X_WP = displaced(input.X_WT, p_WCm, displacement.head<3>(), displacement.tail<3>());
  output.active_count = static_cast<int>(solution_.active_rows.size());
  output.solver_iterations = solution_.newton_iterations;
  push_bodies(input, output);
  displacement_before_ = displacement;
}

// Equation (1), one row a contact point: J = [n, r x n], b = -d.n, positive while it penetrates.
bool PaperMethod::add_constraints(const RenderInput& input, const Vector3& p_WCm, RenderOutput& output) noexcept {
  const IntermediateRepresentation& model = input.model;
  output.constraint_count = 0;
  output.deepest = 0.0;
  output.status = model.sequence == 0 ? RenderStatus::kNoModel : RenderStatus::kOk;
  if (!input.X_WT.is_finite()) output.status = RenderStatus::kInvalidInput;
  if (output.status != RenderStatus::kOk) return false;

  problem_.set_objective(parameters_.coupling.stiffness_matrix(), Vector6::Zero());
  const Coupling& coupling = parameters_.coupling;
  const double per_arm = 1.0 / (coupling.metric_length * coupling.metric_length);
  const Matrix3 R_WT = input.X_WT.rotation();
  for (int i = 0; i < model.plane_count; ++i) {
    const ContactPlane& plane = model.planes[static_cast<size_t>(i)];
    const Vector3 n_W = plane.n_W, p_W = plane.p_W;
    for (int j = plane.first_point; j < plane.first_point + plane.point_count; ++j) {
      const Vector3 p_WC = R_WT * model.points[static_cast<size_t>(j)].p_T.vector() + input.X_WT.p;
      const double depth = -n_W.dot(p_WC - p_W);
      output.deepest = std::max(output.deepest, depth);
      if (parameters_.constraint_set == ConstraintSet::kPenetratingPoints && depth <= 0.0) continue;
      Vector6 J;
      J.head<3>() = n_W;
      J.tail<3>() = (p_WC - p_WCm).cross(n_W);
      // A part of the coupling's own compliance at this point, (1 + (r x n)^2 / l^2) / k.
      const double compliance =
          tolerance::kRowCompliance * (1.0 + per_arm * J.tail<3>().squaredNorm()) / coupling.stiffness;
      row_sources_[static_cast<size_t>(output.constraint_count)] = {i, j};
      if (problem_.add_contact(J, depth, compliance)) ++output.constraint_count;
    }
  }
  return true;
}

void PaperMethod::push_bodies(const RenderInput& input, RenderOutput& output) const noexcept {
  for (const int row : solution_.active_rows) {
    const RowSource source = row_sources_[static_cast<size_t>(row)];
    const ContactPlane& plane = input.model.planes[static_cast<size_t>(source.plane)];
    const Vector3 p_WC = input.X_WT * input.model.points[static_cast<size_t>(source.point)].p_T.vector();
    output.bodies.add(plane, p_WC, -solution_.multipliers[static_cast<size_t>(row)] * plane.n_W.vector());
  }
}

}  // namespace tegotae
