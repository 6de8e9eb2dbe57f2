// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/constraint_solver.hpp>

#include <tegotae/render/constraint_newton.hpp>
#include <tegotae/render/tolerances.hpp>

#include <algorithm>
#include <cmath>

namespace tegotae {
namespace {

constexpr int kProximalStages = 12;
constexpr double kFirstSigma = 1e-3, kSigmaRatio = 1e-2, kLastSigma = 1e-11;  // relative to row_norm()^2

template <int N>
void clear(const ConstraintProblem<N>& problem, ConstraintSolution<N>& solution) noexcept {
  for (const int row : solution.active_rows) solution.multipliers[row] = 0.0;
  solution.active_rows.clear();
  std::fill_n(solution.friction_forces.begin(), problem.friction_count(), Vector3::Zero());
  solution.x = problem.x_free();
  solution.displacement.setZero();
  solution.force.setZero();
  solution.newton_iterations = solution.line_search_steps = solution.proximal_stages = 0;
}

// Multipliers and the guess for the next solve, from the violations in the workspace.
template <int N>
void store(const ConstraintProblem<N>& problem, const RowCompliance* compliances, const Unknowns<N>& z,
           ConstraintWorkspace<N>& workspace, ConstraintSolution<N>& solution) noexcept {
  workspace.guess_groups.clear();
  workspace.guess_active.clear();
  for (const int g : workspace.near_groups) {
    if (workspace.violated[g] == 0) continue;
    workspace.guess_groups.push_back(g);
    workspace.guess_active.push_back(workspace.violated[g]);
    const RowLanes lambda = workspace.violation[g].max(0.0) * compliances[g].stiffness;
    for (int lane = 0; lane < kRowLanes; ++lane)
      if (lambda[lane] > 0.0) {
        solution.multipliers[g * kRowLanes + lane] = lambda[lane];
        solution.active_rows.push_back(g * kRowLanes + lane);
      }
  }
  workspace.guess_friction_count = problem.friction_count();
  for (int f = 0; f < problem.friction_count(); ++f) solution.friction_forces[f] = workspace.friction[f].force;
  solution.displacement = z;
  solution.x = problem.x_free() + z;
  solution.force = problem.K() * z;
}

// sqrt(J K^-1 J^T) of a friction component that can carry force, 0 of others.
template <int N>
double component_norm(const ConstraintProblem<N>& problem, int block, int component) noexcept {
  const FrictionBlock<N>& friction = problem.friction(block);
  if (!(friction.radius[component] > 0.0)) return 0.0;
  const Unknowns<N> J = friction.J.row(component).transpose();
  return std::sqrt(J.dot(problem.K_inverse() * J));
}

// A hard component that moves with no unknown, or carries no force, must not divide by zero.
double usable_compliance(double c) noexcept { return c > 0.0 ? c : 1.0; }

template <int N>
bool solve_compliant(const ConstraintProblem<N>& problem, const Unknowns<N>& x_start, ConstraintWorkspace<N>& workspace,
                     ConstraintSolution<N>& solution) noexcept {
  for (int f = 0; f < problem.friction_count(); ++f)
    workspace.friction[f].compliance = problem.friction(f).compliance.unaryExpr(&usable_compliance);
  Unknowns<N> z = x_start - problem.x_free();
  internal::ConstraintNewton<N, double> newton(problem, problem.compliances(), workspace);
  if (!workspace.guess_groups.empty()) newton.step_on_guess(z);
  newton.scan(z, false);
  const bool converged = newton.minimise(z);
  solution.newton_iterations = newton.iterations();
  solution.line_search_steps = newton.line_search_steps();
  store(problem, problem.compliances(), z, workspace, solution);
  return converged;
}

// Compliances of the next stage, at least sigma times the coupling's own.
template <int N>
void regularise(const ConstraintProblem<N>& problem, double sigma, ConstraintWorkspace<N>& workspace) noexcept {
  const double row_sigma = sigma * problem.row_norm() * problem.row_norm();
  for (int g = 0; g < problem.group_count(); ++g) {
    RowCompliance& regularised = workspace.regularised[g];
    regularised.c = problem.compliances()[g].c.max(row_sigma);
    regularised.stiffness = regularised.c.inverse();
  }
  for (int f = 0; f < problem.friction_count(); ++f)
    for (int j = 0; j < 3; ++j) {
      const double norm = component_norm(problem, f, j);
      const double compliance = std::max(problem.friction(f).compliance[j], sigma * norm * norm);
      workspace.friction[f].compliance[j] = usable_compliance(compliance);
    }
}

// Takes the stage's multipliers as the next stage's proximal centre. Returns the greatest remaining violation of the
// law 0 <= lambda complementary to J x + c lambda - b >= 0, which is (sigma - c) times the change of lambda, divided by
// the row's norm.
template <int N>
double advance_centre(const ConstraintProblem<N>& problem, ConstraintWorkspace<N>& workspace) noexcept {
  double violation = 0.0;
  for (int g = 0; g < problem.group_count(); ++g) {
    const RowCompliance& regularised = workspace.regularised[g];
    const RowLanes lambda = workspace.violation[g].max(0.0) * regularised.stiffness;
    const RowLanes added = regularised.c - problem.compliances()[g].c;
    violation = std::max(violation, (added * (lambda - workspace.previous[g])).abs().maxCoeff());
    workspace.previous[g] = lambda;
  }
  if (violation > 0.0) violation /= problem.row_norm();
  for (int f = 0; f < problem.friction_count(); ++f) {
    auto& state = workspace.friction[f];
    for (int j = 0; j < 3; ++j) {
      const double norm = component_norm(problem, f, j);
      const double added = state.compliance[j] - problem.friction(f).compliance[j];
      if (norm > 0.0) violation = std::max(violation, std::abs(added * (state.force[j] - state.previous[j])) / norm);
    }
    state.previous = state.force;
  }
  return violation;
}

// Greatest violation of the hard limits in the workspace, divided by the rows' norms.
template <int N>
double greatest_violation(const ConstraintProblem<N>& problem, const ConstraintWorkspace<N>& workspace) noexcept {
  double greatest = 0.0;
  for (int g = 0; g < problem.group_count(); ++g) greatest = std::max(greatest, workspace.violation[g].maxCoeff());
  if (greatest > 0.0) greatest /= problem.row_norm();
  for (int f = 0; f < problem.friction_count(); ++f)
    for (int j = 0; j < 3; ++j) {
      const double norm = component_norm(problem, f, j);
      if (norm > 0.0) greatest = std::max(greatest, std::abs(workspace.friction[f].s[j]) / norm);
    }
  return greatest;
}

template <int N>
ConstraintStatus solve_nearly_hard(const ConstraintProblem<N>& problem, ConstraintWorkspace<N>& workspace,
                                   ConstraintSolution<N>& solution) noexcept {
  for (int g = 0; g < problem.group_count(); ++g) workspace.previous[g].setZero();
  for (int f = 0; f < problem.friction_count(); ++f) workspace.friction[f].previous.setZero();
  Unknowns<N> z = Unknowns<N>::Zero();
  double sigma = kFirstSigma, scale = 0.0, violation = 0.0;
  const bool hard = problem.least_relative_compliance() < kLastSigma;
  int without_progress = 0;
  bool converged = false;
  ConstraintStatus status = ConstraintStatus::kIterationLimit;
  for (int stage = 0; stage < kProximalStages; ++stage) {
    regularise(problem, sigma, workspace);
    internal::ConstraintNewton<N, long double> newton(problem, workspace.regularised.data(), workspace);
    newton.scan(z, true);
    if (stage == 0) scale = greatest_violation(problem, workspace);
    converged = newton.minimise(z);
    solution.newton_iterations += newton.iterations();
    solution.line_search_steps += newton.line_search_steps();
    ++solution.proximal_stages;
    const double before = violation;
    violation = advance_centre(problem, workspace);
    if (violation <= tolerance::kHardRowViolation * scale) break;
    without_progress = stage > 0 && violation > 0.5 * before ? without_progress + 1 : 0;
    // Not for rows that have some compliance: a later stage reaches it, and then nothing is left.
    if (hard && without_progress >= 2 && violation > tolerance::kClearlyInfeasibleViolation * scale) break;
    sigma = std::max(kLastSigma, sigma * kSigmaRatio);
  }
  if (violation > tolerance::kInfeasibleViolation * scale)
    status = ConstraintStatus::kInfeasible;
  else if (converged)
    status = ConstraintStatus::kConverged;
  store(problem, workspace.regularised.data(), z, workspace, solution);
  return status;
}

}  // namespace

template <int N>
void ConstraintSolver<N>::solve(const ConstraintProblem<N>& problem, const Unknowns<N>& x_start,
                                ConstraintWorkspace<N>& workspace, ConstraintSolution<N>& solution) const noexcept {
  clear(problem, solution);
  if (!problem.is_valid()) {
    solution.status = ConstraintStatus::kInvalidInput;
    workspace.reset();
    return;
  }
  const bool compliant = problem.least_relative_compliance() >= tolerance::kDirectCompliance;
  if (compliant && solve_compliant(problem, x_start.allFinite() ? x_start : problem.x_free(), workspace, solution)) {
    solution.status = ConstraintStatus::kConverged;
    return;
  }
  if (compliant) clear(problem, solution);
  solution.status = solve_nearly_hard(problem, workspace, solution);
}

template class ConstraintSolver<6>;
template class ConstraintSolver<12>;

}  // namespace tegotae
