// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/constraint_newton.hpp>
#include <tegotae/render/constraint_solver.hpp>
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

template <int N>
bool solve_compliant(const ConstraintProblem<N>& problem, const Unknowns<N>& x_start, ConstraintWorkspace<N>& workspace,
                     ConstraintSolution<N>& solution) noexcept {
  for (int f = 0; f < problem.friction_count(); ++f) workspace.friction[f].compliance = problem.friction(f).compliance;
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
  for (int f = 0; f < problem.friction_count(); ++f) {
    const FrictionBlock<N>& block = problem.friction(f);
    for (int j = 0; j < 3; ++j) {
      const Unknowns<N> J = block.J.row(j).transpose();
      const double own = J.dot(problem.K_inverse() * J);
      workspace.friction[f].compliance[j] = std::max(block.compliance[j], sigma * own);
    }
  }
}

// Takes the stage's multipliers as the next stage's proximal centre. Returns the greatest remaining violation of the
// law 0 <= lambda complementary to J x + c lambda - b >= 0, which is (sigma - c) times the change of lambda.
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
  for (int f = 0; f < problem.friction_count(); ++f) {
    auto& state = workspace.friction[f];
    const Vector3 added = state.compliance - problem.friction(f).compliance;
    const Vector3 change = added.cwiseProduct(state.force - state.previous);
    const Vector3 lever = added.cwiseSqrt() / std::sqrt(std::max(added.maxCoeff(), 1e-300));
    if (added.maxCoeff() > 0.0)
      for (int j = 0; j < 3; ++j)
        if (added[j] > 0.0) violation = std::max(violation, std::abs(change[j]) / lever[j]);
    state.previous = state.force;
  }
  return violation;
}

template <int N>
double greatest_violation(const ConstraintProblem<N>& problem, const ConstraintWorkspace<N>& workspace) noexcept {
  double greatest = 0.0;
  for (int g = 0; g < problem.group_count(); ++g) greatest = std::max(greatest, workspace.violation[g].maxCoeff());
  for (int f = 0; f < problem.friction_count(); ++f)
    greatest = std::max(greatest, workspace.friction[f].s.cwiseAbs().maxCoeff());
  return greatest;
}

template <int N>
ConstraintStatus solve_nearly_hard(const ConstraintProblem<N>& problem, ConstraintWorkspace<N>& workspace,
                                   ConstraintSolution<N>& solution) noexcept {
  for (int g = 0; g < problem.group_count(); ++g) workspace.previous[g].setZero();
  for (int f = 0; f < problem.friction_count(); ++f) workspace.friction[f].previous.setZero();
  Unknowns<N> z = Unknowns<N>::Zero();
  double sigma = kFirstSigma, scale = 0.0, violation = 0.0;
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
    if (without_progress >= 2 && violation > tolerance::kClearlyInfeasibleViolation * scale) break;
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
