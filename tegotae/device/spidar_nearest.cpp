// SPDX-License-Identifier: Apache-2.0
#include <tegotae/device/spidar_nearest.hpp>

#include <tegotae/device/tolerances.hpp>

#include <Eigen/Cholesky>

#include <algorithm>
#include <array>

namespace tegotae {
namespace {

/// The tensions, and s |w|: all in newtons.
constexpr int kUnknowns = kSpidarStrings + 1;
using Unknowns = Eigen::Matrix<double, kUnknowns, 1>;
using Hessian = Eigen::Matrix<double, kUnknowns, kUnknowns>;

enum class Bound : std::uint8_t { kFree, kLow, kHigh };

/// minimise 1/2 x^T H x - g^T x within low <= x <= high; H positive definite.
struct BoundedProblem {
  Hessian H;
  Unknowns g, low, high;
};

struct ActiveSet {
  Unknowns x;
  std::array<Bound, kUnknowns> bounds;
};

/// The minimiser over the free unknowns, the others held.
Unknowns free_minimiser(const BoundedProblem& problem, const ActiveSet& set) noexcept {
  Hessian H = Hessian::Identity();
  Unknowns right = set.x;
  for (int i = 0; i < kUnknowns; ++i) {
    if (set.bounds[static_cast<std::size_t>(i)] != Bound::kFree) continue;
    right[i] = problem.g[i];
    for (int j = 0; j < kUnknowns; ++j) {
      const bool is_free = set.bounds[static_cast<std::size_t>(j)] == Bound::kFree;
      H(i, j) = is_free ? problem.H(i, j) : 0.0;
      if (!is_free) right[i] -= problem.H(i, j) * set.x[j];
    }
  }
  return H.ldlt().solve(right);
}

/// Goes towards `goal`, up to the first bound in the way, which then holds. True where it got there.
bool advance(const BoundedProblem& problem, const Unknowns& goal, ActiveSet& set) noexcept {
  double share = 1.0;
  int first = -1;
  for (int i = 0; i < kUnknowns; ++i) {
    if (set.bounds[static_cast<std::size_t>(i)] != Bound::kFree) continue;
    const double limit = std::clamp(goal[i], problem.low[i], problem.high[i]);
    if (limit == goal[i]) continue;
    const double reach = (limit - set.x[i]) / (goal[i] - set.x[i]);
    if (reach <= share) {
      share = reach;
      first = i;
    }
  }
  set.x = (set.x + share * (goal - set.x)).cwiseMax(problem.low).cwiseMin(problem.high);
  if (first < 0) return true;
  const bool is_low = goal[first] < set.x[first];
  set.x[first] = is_low ? problem.low[first] : problem.high[first];
  set.bounds[static_cast<std::size_t>(first)] = is_low ? Bound::kLow : Bound::kHigh;
  return false;
}

/// Frees the bound away from which the objective falls fastest. False where there is none: this is the minimum.
bool release(const BoundedProblem& problem, ActiveSet& set) noexcept {
  const Unknowns slope = problem.H * set.x - problem.g;
  int hardest = -1;
  double pull = tolerance::kSpidarPull;
  for (int i = 0; i < kUnknowns; ++i) {
    const Bound bound = set.bounds[static_cast<std::size_t>(i)];
    if (bound == Bound::kFree || !(problem.low[i] < problem.high[i])) continue;
    const double inward = bound == Bound::kLow ? -slope[i] : slope[i];
    if (inward > pull) {
      pull = inward;
      hardest = i;
    }
  }
  if (hardest < 0) return false;
  set.bounds[static_cast<std::size_t>(hardest)] = Bound::kFree;
  return true;
}

BoundedProblem problem_of(const SpidarWrenchMatrix& W, const Vector6& w, const SpidarVector& min,
                          const SpidarVector& max) noexcept {
  const double size = w.norm();
  Eigen::Matrix<double, 6, kUnknowns> A;
  A.leftCols<kSpidarStrings>() = W;
  A.col(kSpidarStrings) = size > 0.0 ? Vector6(-w / size) : Vector6(Vector6::Zero());
  BoundedProblem problem;
  problem.low << min, 0.0;
  problem.high << max, size;
  Unknowns preferred;
  preferred << min, size;
  Unknowns weights = Unknowns::Constant(tolerance::kSpidarPreferSmall);
  weights[kSpidarStrings] = tolerance::kSpidarPreferGreat;
  problem.H = A.transpose() * A;
  problem.H.diagonal() += weights;
  problem.g = weights.cwiseProduct(preferred);
  return problem;
}

}  // namespace

SpidarNearest nearest_tensions(const SpidarWrenchMatrix& W, double radius, const SpidarVector& min,
                               const SpidarVector& max, const Wrench& wrench) noexcept {
  SpidarWrenchMatrix scaled = W;
  scaled.bottomRows<3>() /= radius;
  Vector6 w;
  w << wrench.force, wrench.torque / radius;
  const BoundedProblem problem = problem_of(scaled, w, min, max);
  ActiveSet set;
  set.x = problem.low;
  set.bounds.fill(Bound::kLow);
  SpidarNearest result;
  while (result.steps < tolerance::kSpidarActiveSteps && release(problem, set)) {
    do ++result.steps;
    while (!advance(problem, free_minimiser(problem, set), set) && result.steps < tolerance::kSpidarActiveSteps);
  }
  result.tensions = set.x.head<kSpidarStrings>();
  const double size = problem.high[kSpidarStrings];
  result.scale = size > 0.0 ? set.x[kSpidarStrings] / size : 0.0;
  return result;
}

}  // namespace tegotae
