// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/otaduy_lin_method.hpp>

#include <tegotae/render/tool_inertia.hpp>

#include <Eigen/LU>

#include <stdexcept>

namespace tegotae {

OtaduyLinMethod::OtaduyLinMethod(const Parameters& parameters, const MassProperties& tool)
    : parameters_(parameters),
      p_TCm_(tool.centre_of_mass),
      inertia_shape_T_(unit_mean_inertia(tool)),
      mean_inertia_(parameters.mass / tool.mass * tool.inertia.trace() / 3.0),
      problem_(kMaxContactPoints, 0),
      workspace_(problem_),
      solution_(problem_) {
  if (!(parameters.mass > 0.0)) throw std::invalid_argument("mass of the simulated tool must be above 0 kg");
  if (!(parameters.contact_stiffness_ratio > 0.0)) throw std::invalid_argument("contact stiffness must be above 0");
  if (!(parameters.contact_damping >= 0.0)) throw std::invalid_argument("contact damping must not be negative");
}

void OtaduyLinMethod::reset() noexcept {
  placed_ = false;
  workspace_.reset();
}

void OtaduyLinMethod::start_at(const Pose& X_WP, const Pose& X_WT) noexcept {
  reset();
  placed_ = true;
  X_WP_ = X_WP;
  momentum_.setZero();
  stretch_before_ = displacement(X_WT, X_WP, p_TCm_);
}

void OtaduyLinMethod::view(const RenderInput& input, const RenderOutput& output, ContactView& view) const noexcept {
  rows_.view(input.model, output.X_WP, solution_, view);
}

void OtaduyLinMethod::render(const RenderInput& input, RenderOutput& output) noexcept {
  if (!begin_render(input, output)) return;
  output.deepest = deepest_penetration(input.model, input.X_WT);
  if (!placed_) {
    X_WP_ = input.X_WT;
    momentum_.setZero();
    stretch_before_.setZero();
    placed_ = true;
  }
  const Vector3 centre_W = X_WP_ * p_TCm_;
  const Matrix6 M = rigid_body_matrix(parameters_.mass, mean_inertia_, inertia_shape_T_, X_WP_.rotation());
  pose_step(input, M, displacement(input.X_WT, X_WP_, p_TCm_));
  add_contacts(input, centre_W);
  output.constraint_count = rows_.count();

  solver_.solve(problem_, workspace_, solution_);
  output.status = status_of(solution_.status);
  if (solution_.status == ConstraintStatus::kInvalidInput) return;

  rows_.push_bodies(input.model, X_WP_, solution_, output.bodies);
  const Vector6& u = solution_.x;
  X_WP_ = displaced(X_WP_, centre_W, u.head<3>(), u.tail<3>());
  momentum_ = M * u / input.dt;
  const Vector6 stretch = displacement(input.X_WT, X_WP_, p_TCm_);
  output.wrench = parameters_.coupling.wrench(stretch, stretch_before_, input.dt);
  stretch_before_ = stretch;
  output.X_WP = X_WP_;
  output.active_count = static_cast<int>(solution_.active_rows.size());
  output.solver_iterations = solution_.newton_iterations;
}

// Without contacts the step solves A u = g with A = M / dt^2 + (k + d / dt) L and g = M v / dt - k L e0 - d L (e0 - e)
// / dt, where e0 is the stretch of last tick's tool against this tick's interface.
void OtaduyLinMethod::pose_step(const RenderInput& input, const Matrix6& M, const Vector6& stretch) noexcept {
  const Coupling& coupling = parameters_.coupling;
  const Matrix6 spring = coupling.stiffness_matrix();
  const double damping = coupling.damping / (coupling.stiffness * input.dt);
  const Matrix6 A = M / (input.dt * input.dt) + (1.0 + damping) * spring;
  const Vector6 pull = stretch + damping * (stretch - stretch_before_);
  const Vector6 g = momentum_ / input.dt - spring.diagonal().cwiseProduct(pull);
  Vector6 u_free;
  u_free.head<3>() = g.head<3>() / A(0, 0);
  const Matrix3 angular = A.bottomRightCorner<3, 3>();
  u_free.tail<3>() = angular.inverse() * g.tail<3>();
  problem_.set_objective(A, u_free);
}

// f = max(0, k_c (delta - J u) - d_c J u / dt) as a compliant row. A damper acts on what is below the plane: a point
// that is still apart has no share of the way to it.
void OtaduyLinMethod::add_contacts(const RenderInput& input, const Vector3& centre_W) noexcept {
  const double spring = parameters_.contact_stiffness_ratio * parameters_.coupling.stiffness;
  const double stiffness = spring + parameters_.contact_damping / input.dt;
  rows_.clear();
  visit_contact_points(input.model, X_WP_, [&](const PointOnPlane& contact) {
    const double b = contact.depth > 0.0 ? spring / stiffness * contact.depth : contact.depth;
    rows_.add(contact, normal_row(contact, centre_W), b, 1.0 / stiffness, problem_);
  });
}

}  // namespace tegotae
