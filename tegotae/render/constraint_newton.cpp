// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/constraint_newton.hpp>

#include <tegotae/render/force_ellipsoid.hpp>
#include <tegotae/render/row_lanes.hpp>
#include <tegotae/render/tolerances.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace tegotae::internal {
namespace {

constexpr int kIterationLimit = 100;
constexpr int kLineSearchLimit = 40;
constexpr int kRescanLimit = 3;
constexpr double kReachFactor = 2.0;  // room for the steps that follow

// Solves A y = g by the square-root-free factorisation A = L D L^T, A's lower triangle given. A pivot lost to rounding
// is replaced by its share of the diagonal: the direction is then no longer Newton's, but still one of descent.
template <int N, class Scalar>
Unknowns<N> solve_positive(Eigen::Matrix<Scalar, N, N, Eigen::DontAlign>& A, const Unknowns<N>& g) noexcept {
  Scalar inverse_pivot[N], y[N];
  for (int j = 0; j < N; ++j) {
    Scalar pivot = A(j, j);
    const Scalar floor = pivot * (4 * std::numeric_limits<Scalar>::epsilon());
    Scalar scaled[N];
    for (int k = 0; k < j; ++k) {
      scaled[k] = A(j, k);
      A(j, k) *= inverse_pivot[k];
      pivot -= scaled[k] * A(j, k);
    }
    inverse_pivot[j] = 1 / std::max(pivot, floor);
    for (int i = j + 1; i < N; ++i)
      for (int k = 0; k < j; ++k) A(i, j) -= A(i, k) * A(j, k);
  }
  for (int i = 0; i < N; ++i) {
    y[i] = static_cast<Scalar>(g[i]);
    for (int k = 0; k < i; ++k) y[i] -= A(i, k) * y[k];
  }
  Unknowns<N> result;
  for (int i = N - 1; i >= 0; --i) {
    y[i] *= inverse_pivot[i];
    for (int k = i + 1; k < N; ++k) y[i] -= A(k, i) * y[k];
    result[i] = static_cast<double>(y[i]);
  }
  return result;
}

}  // namespace

template <int N, class Scalar>
void ConstraintNewton<N, Scalar>::add_group_to_matrix(int group, const Lanes& weight) noexcept {
  const RowGroup<N>& rows = problem_.groups()[group];
  if constexpr (std::is_same_v<Scalar, double>) {
    for (int i = 0; i < N; ++i) {
      const Lanes weighted = weight * Lanes::load(rows.J.data() + i * kRowLanes);
      for (int j = 0; j <= i; ++j)
        contact_matrix_[i][j] += (weighted * Lanes::load(rows.J.data() + j * kRowLanes)).fold();
    }
  } else {
    RowLanes weights;
    weight.store(weights);
    for (int lane = 0; lane < kRowLanes; ++lane)
      for (int i = 0; weights[lane] != 0.0 && i < N; ++i) {
        const Scalar weighted = static_cast<Scalar>(weights[lane]) * static_cast<Scalar>(rows.J(lane, i));
        for (int j = 0; j <= i; ++j) contact_matrix_[i][j] += weighted * static_cast<Scalar>(rows.J(lane, j));
      }
  }
}

template <int N, class Scalar>
ConstraintNewton<N, Scalar>::ConstraintNewton(const ConstraintProblem<N>& problem, const RowCompliance* compliances,
                                              ConstraintWorkspace<N>& workspace) noexcept
    : problem_(problem), compliances_(compliances), workspace_(workspace) {
  std::fill_n(workspace_.active.begin(), problem.group_count(), std::uint8_t{0});
  for (auto& row : contact_matrix_)
    for (MatrixSum& entry : row) entry = MatrixSum{};
}

template <int N, class Scalar>
void ConstraintNewton<N, Scalar>::scan(const Unknowns<N>& z, bool shifted) noexcept {
  shifted_ = shifted;
  const Unknowns<N> x = problem_.x_free() + z;
  const double threshold = -reach_ * problem_.row_norm();
  auto& near = workspace_.near_groups;
  near.clear();
  begin_gradient();
  for (int g = 0; g < problem_.group_count(); ++g) {
    const RowGroup<N>& rows = problem_.groups()[g];
    Lanes v = Lanes::load(rows.b) - rows_times<N>(rows, x);
    if (shifted) {
      const Lanes added = Lanes::load(compliances_[g].c) - Lanes::load(problem_.compliances()[g].c);
      v = v + added * Lanes::load(workspace_.previous[g]);
    }
    v.store(workspace_.violation[g]);
    if (v.above(threshold) == 0 && workspace_.active[g] == 0) continue;
    near.push_back(g);
    add_group_to_gradient(g, v);
  }
  scan_friction(x, shifted);
  finish_gradient(z);
}

template <int N, class Scalar>
void ConstraintNewton<N, Scalar>::scan_friction(const Unknowns<N>& x, bool shifted) noexcept {
  for (int f = 0; f < problem_.friction_count(); ++f) {
    auto& state = workspace_.friction[f];
    const FrictionBlock<N>& block = problem_.friction(f);
    state.s = block.b - block.J * x;
    if (shifted) state.s += (state.compliance - block.compliance).cwiseProduct(state.previous);
  }
}

template <int N, class Scalar>
void ConstraintNewton<N, Scalar>::evaluate_friction() noexcept {
  for (int f = 0; f < problem_.friction_count(); ++f) {
    auto& state = workspace_.friction[f];
    const EllipsoidForce response = ellipsoid_force(state.s, state.compliance, problem_.friction(f).radius);
    state.force = response.force;
    state.stiffness = response.stiffness;
    state.sticks = !response.on_boundary;
  }
}

// The gradient and the sets of violated rows at z are found in one pass with what changes the violations.
template <int N, class Scalar>
void ConstraintNewton<N, Scalar>::begin_gradient() noexcept {
  for (Pair& push : push_) push = Pair{};
  push_sum_ = Pair{};
}

template <int N, class Scalar>
[[gnu::always_inline]] inline void ConstraintNewton<N, Scalar>::add_group_to_gradient(int group,
                                                                                      const Lanes& v) noexcept {
  const unsigned bits = v.above(0.0);
  workspace_.violated[group] = static_cast<std::uint8_t>(bits);
  if (bits == 0) return;
  const Lanes lambda = v.positive() * Lanes::load(compliances_[group].stiffness);
  const RowGroup<N>& rows = problem_.groups()[group];
  for (int j = 0; j < N; ++j) push_[j] += (Lanes::load(rows.J.data() + j * kRowLanes) * lambda).fold();
  push_sum_ += lambda.fold();
}

template <int N, class Scalar>
void ConstraintNewton<N, Scalar>::finish_gradient(const Unknowns<N>& z) noexcept {
  gradient_ = problem_.K() * z;
  for (int j = 0; j < N; ++j) gradient_[j] -= sum(push_[j]);
  force_sum_ = sum(push_sum_) * problem_.row_norm();
  evaluate_friction();
  for (int f = 0; f < problem_.friction_count(); ++f) {
    const Unknowns<N> push = problem_.friction(f).J.transpose() * workspace_.friction[f].force;
    gradient_ -= push;
    force_sum_ += std::sqrt(push.dot(problem_.K_inverse() * push));
  }
}

template <int N, class Scalar>
void ConstraintNewton<N, Scalar>::update_active_set() noexcept {
  for (const int g : workspace_.near_groups) {
    const unsigned now = workspace_.violated[g], before = workspace_.active[g];
    if (now == before) continue;
    add_group_to_matrix(g, (Lanes::of(now) - Lanes::of(before)) * Lanes::load(compliances_[g].stiffness));
    workspace_.active[g] = static_cast<std::uint8_t>(now);
  }
}

template <int N, class Scalar>
void ConstraintNewton<N, Scalar>::find_direction() noexcept {
  Matrix A = problem_.K().template cast<Scalar>();
  for (int i = 0; i < N; ++i)
    for (int j = 0; j <= i; ++j) A(i, j) += sum(contact_matrix_[i][j]);
  for (int f = 0; f < problem_.friction_count(); ++f) {
    // Lazy products: Eigen's general ones may allocate.
    const auto J = problem_.friction(f).J.template cast<Scalar>().eval();
    const auto stiff = workspace_.friction[f].stiffness.template cast<Scalar>().lazyProduct(J).eval();
    A += J.transpose().lazyProduct(stiff);
  }
  direction_ = solve_positive<N, Scalar>(A, -gradient_);
}

template <int N, class Scalar>
void ConstraintNewton<N, Scalar>::step(Unknowns<N>& z) noexcept {
  z += direction_;
  begin_gradient();
  for (const int g : workspace_.near_groups) {
    const Lanes change = rows_times<N>(problem_.groups()[g], direction_);
    const Lanes v = Lanes::load(workspace_.violation[g]) - change;
    change.store(workspace_.change[g]);
    v.store(workspace_.violation[g]);
    add_group_to_gradient(g, v);
  }
  for (int f = 0; f < problem_.friction_count(); ++f) {
    workspace_.friction[f].change = problem_.friction(f).J * direction_;
    workspace_.friction[f].s -= workspace_.friction[f].change;
  }
  finish_gradient(z);
}

template <int N, class Scalar>
void ConstraintNewton<N, Scalar>::step_back(Unknowns<N>& z, double back) noexcept {
  z -= back * direction_;
  begin_gradient();
  for (const int g : workspace_.near_groups) {
    const Lanes v = Lanes::load(workspace_.violation[g]) + Lanes::load(workspace_.change[g]) * back;
    v.store(workspace_.violation[g]);
    add_group_to_gradient(g, v);
  }
  for (int f = 0; f < problem_.friction_count(); ++f) workspace_.friction[f].s += back * workspace_.friction[f].change;
  finish_gradient(z);
}

// First and second derivative of the objective along the direction, `back` before z.
template <int N, class Scalar>
auto ConstraintNewton<N, Scalar>::slope_before(const Unknowns<N>& z, double back) const noexcept -> Slope {
  const Unknowns<N> K_direction = problem_.K() * direction_;
  Slope slope{K_direction.dot(z) - back * K_direction.dot(direction_), K_direction.dot(direction_)};
  Pair first{}, second{};
  for (const int g : workspace_.near_groups) {
    const Lanes change = Lanes::load(workspace_.change[g]);
    const Lanes v = Lanes::load(workspace_.violation[g]) + change * back;
    const unsigned bits = v.above(0.0);
    if (bits == 0) continue;
    const Lanes weighted = change * Lanes::load(compliances_[g].stiffness);
    first += (weighted * v.positive()).fold();
    second += (weighted * change * Lanes::of(bits)).fold();
  }
  slope.first -= sum(first);
  slope.second += sum(second);
  for (int f = 0; f < problem_.friction_count(); ++f) {
    const auto& state = workspace_.friction[f];
    const EllipsoidForce response =
        ellipsoid_force(state.s + back * state.change, state.compliance, problem_.friction(f).radius);
    slope.first -= state.change.dot(response.force);
    slope.second += state.change.dot(response.stiffness * state.change);
  }
  return slope;
}

// How far back from z, the end of a full step, the minimum along the direction lies. The slope grows monotonically;
// Newton's method on it, kept inside the bracket.
template <int N, class Scalar>
double ConstraintNewton<N, Scalar>::search_back(const Unknowns<N>& z, double initial_slope) noexcept {
  double low = 0.0, high = 1.0;  // slope positive at `low` back, negative at `high` back
  double back = 0.0;
  for (int i = 0; i < kLineSearchLimit; ++i) {
    ++line_search_steps_;
    const Slope slope = slope_before(z, back);
    if (std::abs(slope.first) <= tolerance::kLineSearchSlope * std::abs(initial_slope)) break;
    (slope.first > 0.0 ? low : high) = back;
    back += slope.first / slope.second;
    if (!(back > low && back < high)) back = 0.5 * (low + high);
  }
  return back;
}

template <int N, class Scalar>
double ConstraintNewton<N, Scalar>::stationarity() const noexcept {
  return std::sqrt(gradient_.dot(problem_.K_inverse() * gradient_));
}

template <int N, class Scalar>
double ConstraintNewton<N, Scalar>::stationarity_bound(const Unknowns<N>& z, double relative) const noexcept {
  return relative * std::sqrt(z.dot(problem_.K() * z)) + tolerance::kStationarityRounding * force_sum_;
}

template <int N, class Scalar>
void ConstraintNewton<N, Scalar>::step_on_guess(Unknowns<N>& z) noexcept {
  const Unknowns<N> x = problem_.x_free() + z;
  begin_gradient();
  for (std::size_t i = 0; i < workspace_.guess_groups.size(); ++i) {
    const int g = workspace_.guess_groups[i];
    if (g >= problem_.group_count()) break;
    const RowGroup<N>& rows = problem_.groups()[g];
    const Lanes weight = Lanes::of(workspace_.guess_active[i]) * Lanes::load(compliances_[g].stiffness);
    const Lanes force = (Lanes::load(rows.b) - rows_times<N>(rows, x)) * weight;
    for (int j = 0; j < N; ++j) push_[j] += (Lanes::load(rows.J.data() + j * kRowLanes) * force).fold();
    add_group_to_matrix(g, weight);
    workspace_.active[g] = workspace_.guess_active[i];
  }
  gradient_ = problem_.K() * z;
  for (int j = 0; j < N; ++j) gradient_[j] -= sum(push_[j]);
  for (int f = 0; f < problem_.friction_count(); ++f)
    workspace_.friction[f].previous[0] = f < workspace_.guess_friction_count && workspace_.friction[f].sticks;
  scan_friction(x, false);
  evaluate_friction();
  for (int f = 0; f < problem_.friction_count(); ++f) {
    auto& state = workspace_.friction[f];
    const FrictionBlock<N>& block = problem_.friction(f);
    if (state.previous[0] != 0.0) {
      const EllipsoidForce unbounded = ellipsoid_force(Vector3::Zero(), state.compliance, block.radius);
      state.stiffness = unbounded.stiffness;
      state.force = unbounded.stiffness * state.s;
    }
    gradient_ -= block.J.transpose() * state.force;
  }
  start_residual_ = stationarity();
  find_direction();
  z += direction_;
  reach_ = 0.5 * std::sqrt(direction_.dot(problem_.K() * direction_));
}

template <int N, class Scalar>
bool ConstraintNewton<N, Scalar>::minimise(Unknowns<N>& z) noexcept {
  constexpr double kAcceptable = 100.0;    // of the bound, where rounding stops progress
  constexpr double kFreeResidual = 1e-14;  // of that at the start
  double residual = stationarity();
  const double start = std::max(residual, start_residual_);
  int rescans = 0;
  for (int i = 0; i < kIterationLimit; ++i) {
    if (force_sum_ == 0.0 && residual <= kFreeResidual * start)
      z.setZero();  // free: without the rounding of the way here
    if (z.isZero(0.0) && force_sum_ == 0.0) return true;
    if (residual <= stationarity_bound(z, tolerance::kStationarity)) return true;
    ++iterations_;
    update_active_set();
    find_direction();
    const double initial_slope = gradient_.dot(direction_);
    const double length = std::sqrt(direction_.dot(problem_.K() * direction_));
    if (length > reach_) {
      // The step may touch rows that were set aside: look again, further; after a few times at all of them.
      reach_ = rescans++ < kRescanLimit ? kReachFactor * length : std::numeric_limits<double>::infinity();
      scan(z, shifted_);
    }
    reach_ -= length;
    step(z);
    if (gradient_.dot(direction_) > tolerance::kLineSearchSlope * std::abs(initial_slope))
      step_back(z, search_back(z, initial_slope));
    const double before = residual;
    residual = stationarity();
    // Where only rounding is left the residual no longer falls.
    if (residual > 0.5 * before && residual <= stationarity_bound(z, kAcceptable * tolerance::kStationarity))
      return true;
  }
  return false;
}

template class ConstraintNewton<6, double>;
template class ConstraintNewton<6, long double>;
template class ConstraintNewton<12, double>;
template class ConstraintNewton<12, long double>;

}  // namespace tegotae::internal
