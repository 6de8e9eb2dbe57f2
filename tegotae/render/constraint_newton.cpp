// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/constraint_newton.hpp>
#include <tegotae/render/force_ellipsoid.hpp>
#include <tegotae/render/tolerances.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace tegotae::internal {
namespace {

constexpr int kIterationLimit = 100;
constexpr int kLineSearchLimit = 40;

// Pairs of lanes: sums over rows are kept in two halves and added at the end, as SSE2 has registers of two.
using Pair = Eigen::Array<double, 2, 1>;

Pair pair_product(const double* a, const double* b) noexcept {
  using ConstMap = Eigen::Map<const Pair>;
  return (ConstMap(a) * ConstMap(b) + ConstMap(a + 2) * ConstMap(b + 2)) +
         (ConstMap(a + 4) * ConstMap(b + 4) + ConstMap(a + 6) * ConstMap(b + 6));
}

template <int N>
RowLanes rows_times(const RowGroup<N>& rows, const Unknowns<N>& d) noexcept {
  RowLanes sum = rows.J.col(0) * d[0];
  for (int j = 1; j < N; ++j) sum += rows.J.col(j) * d[j];
  return sum;
}

unsigned positive_lanes(const RowLanes& v) noexcept {
  unsigned bits = 0;
  for (int i = 0; i < kRowLanes; ++i) bits |= static_cast<unsigned>(v[i] > 0.0) << i;
  return bits;
}

RowLanes lanes_of(unsigned bits) noexcept {
  RowLanes lanes;
  for (int i = 0; i < kRowLanes; ++i) lanes[i] = static_cast<double>((bits >> i) & 1u);
  return lanes;
}

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
void ConstraintNewton<N, Scalar>::add_group_to_matrix(int group, const RowLanes& weight) noexcept {
  const RowGroup<N>& rows = problem_.groups()[group];
  if constexpr (std::is_same_v<Scalar, double>) {
    for (int i = 0; i < N; ++i) {
      const RowLanes weighted = weight * rows.J.col(i);
      for (int j = 0; j <= i; ++j) contact_matrix_(i, j) += pair_product(weighted.data(), &rows.J(0, j)).sum();
    }
  } else {
    for (int lane = 0; lane < kRowLanes; ++lane)
      for (int i = 0; weight[lane] != 0.0 && i < N; ++i) {
        const Scalar weighted = static_cast<Scalar>(weight[lane]) * static_cast<Scalar>(rows.J(lane, i));
        for (int j = 0; j <= i; ++j) contact_matrix_(i, j) += weighted * static_cast<Scalar>(rows.J(lane, j));
      }
  }
}

template <int N, class Scalar>
ConstraintNewton<N, Scalar>::ConstraintNewton(const ConstraintProblem<N>& problem, const RowCompliance* compliances,
                                              ConstraintWorkspace<N>& workspace) noexcept
    : problem_(problem),
      compliances_(compliances),
      workspace_(workspace),
      reach_(std::numeric_limits<double>::infinity()) {
  std::fill_n(workspace_.active.begin(), problem.group_count(), std::uint8_t{0});
}

template <int N, class Scalar>
void ConstraintNewton<N, Scalar>::scan(const Unknowns<N>& z, bool shifted) noexcept {
  shifted_ = shifted;
  const Unknowns<N> x = problem_.x_free() + z;
  const double threshold = -reach_ * problem_.row_norm();
  auto& near = workspace_.near_groups;
  near.clear();
  for (int g = 0; g < problem_.group_count(); ++g) {
    const RowGroup<N>& rows = problem_.groups()[g];
    RowLanes v = rows.b - rows_times<N>(rows, x);
    if (shifted) v += (compliances_[g].c - problem_.compliances()[g].c) * workspace_.previous[g];
    workspace_.violation[g] = v;
    if (!(v.maxCoeff() <= threshold) || workspace_.active[g] != 0) near.push_back(g);
  }
  scan_friction(x, shifted);
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

// Gradient, friction forces and the sets of violated rows at z.
template <int N, class Scalar>
void ConstraintNewton<N, Scalar>::evaluate(const Unknowns<N>& z) noexcept {
  Pair sums[N];
  for (Pair& sum : sums) sum.setZero();
  Pair forces = Pair::Zero();
  for (const int g : workspace_.near_groups) {
    const RowLanes& v = workspace_.violation[g];
    const unsigned bits = positive_lanes(v);
    workspace_.violated[g] = static_cast<std::uint8_t>(bits);
    if (bits == 0) continue;
    const RowLanes lambda = v.max(0.0) * compliances_[g].stiffness;
    const RowGroup<N>& rows = problem_.groups()[g];
    for (int j = 0; j < N; ++j) sums[j] += pair_product(&rows.J(0, j), lambda.data());
    for (int i = 0; i < kRowLanes; i += 2) forces += lambda.segment<2>(i);
  }
  gradient_ = problem_.K() * z;
  for (int j = 0; j < N; ++j) gradient_[j] -= sums[j].sum();
  force_sum_ = forces.sum() * problem_.row_norm();
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
    const RowLanes sign = before == 0 ? lanes_of(now) : RowLanes(lanes_of(now) - lanes_of(before));
    add_group_to_matrix(g, sign * compliances_[g].stiffness);
    workspace_.active[g] = static_cast<std::uint8_t>(now);
  }
}

template <int N, class Scalar>
void ConstraintNewton<N, Scalar>::find_direction() noexcept {
  Matrix A = contact_matrix_ + problem_.K().template cast<Scalar>();
  for (int f = 0; f < problem_.friction_count(); ++f) {
    const auto J = problem_.friction(f).J.template cast<Scalar>().eval();
    A += J.transpose() * workspace_.friction[f].stiffness.template cast<Scalar>() * J;
  }
  direction_ = solve_positive<N, Scalar>(A, -gradient_);
}

template <int N, class Scalar>
void ConstraintNewton<N, Scalar>::compute_change() noexcept {
  for (const int g : workspace_.near_groups) workspace_.change[g] = rows_times<N>(problem_.groups()[g], direction_);
  for (int f = 0; f < problem_.friction_count(); ++f)
    workspace_.friction[f].change = problem_.friction(f).J * direction_;
}

template <int N, class Scalar>
void ConstraintNewton<N, Scalar>::move(Unknowns<N>& z, double t) noexcept {
  z += t * direction_;
  for (const int g : workspace_.near_groups) workspace_.violation[g] -= t * workspace_.change[g];
  for (int f = 0; f < problem_.friction_count(); ++f) workspace_.friction[f].s -= t * workspace_.friction[f].change;
}

// First and second derivative of the objective along the direction, `back` before z.
template <int N, class Scalar>
auto ConstraintNewton<N, Scalar>::slope_before(const Unknowns<N>& z, double back) const noexcept -> Slope {
  const Unknowns<N> K_direction = problem_.K() * direction_;
  Slope slope{K_direction.dot(z) - back * K_direction.dot(direction_), K_direction.dot(direction_)};
  RowLanes first = RowLanes::Zero(), second = RowLanes::Zero();
  for (const int g : workspace_.near_groups) {
    const RowLanes& change = workspace_.change[g];
    const RowLanes v = (workspace_.violation[g] + back * change).max(0.0);
    const RowLanes weighted = change * compliances_[g].stiffness;
    first += weighted * v;
    second += (v > 0.0).select(weighted * change, 0.0);
  }
  slope.first -= first.sum();
  slope.second += second.sum();
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
  gradient_ = problem_.K() * z;
  for (std::size_t i = 0; i < workspace_.guess_groups.size(); ++i) {
    const int g = workspace_.guess_groups[i];
    if (g >= problem_.group_count()) break;
    const RowGroup<N>& rows = problem_.groups()[g];
    const RowLanes weight = lanes_of(workspace_.guess_active[i]) * compliances_[g].stiffness;
    const RowLanes force = (rows.b - rows_times<N>(rows, x)) * weight;
    for (int j = 0; j < N; ++j) gradient_[j] -= pair_product(&rows.J(0, j), force.data()).sum();
    add_group_to_matrix(g, weight);
    workspace_.active[g] = workspace_.guess_active[i];
  }
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
  find_direction();
  z += direction_;
  reach_ = 0.5 * std::sqrt(direction_.dot(problem_.K() * direction_));
}

template <int N, class Scalar>
bool ConstraintNewton<N, Scalar>::minimise(Unknowns<N>& z) noexcept {
  constexpr double kAcceptable = 100.0;  // of the bound, where rounding stops progress
  evaluate(z);
  double residual = stationarity();
  for (int i = 0; i < kIterationLimit; ++i) {
    if (residual <= stationarity_bound(z, tolerance::kStationarity)) return true;
    ++iterations_;
    update_active_set();
    find_direction();
    const double initial_slope = gradient_.dot(direction_);
    const double length = std::sqrt(direction_.dot(problem_.K() * direction_));
    if (length > reach_) {
      // The step may reach rows that were set aside: take all into account from here on.
      reach_ = std::numeric_limits<double>::infinity();
      scan(z, shifted_);
      evaluate(z);
      residual = stationarity();
      continue;
    }
    reach_ -= length;
    compute_change();
    move(z, 1.0);
    evaluate(z);
    if (gradient_.dot(direction_) > tolerance::kLineSearchSlope * std::abs(initial_slope)) {
      move(z, -search_back(z, initial_slope));
      evaluate(z);
    }
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
