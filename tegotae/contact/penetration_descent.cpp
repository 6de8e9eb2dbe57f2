// SPDX-License-Identifier: Apache-2.0
#include <tegotae/contact/penetration_descent.hpp>

#include <tegotae/contact/gjk_warm_start.hpp>
#include <tegotae/contact/tolerances.hpp>

#include <algorithm>

namespace tegotae::gjk {
namespace {

// Polytopes end after a few passes, the number of faces on the way; curved shapes that overlap by most of their radius
// converge slowly.
constexpr int kMaxPasses = 48;

// The points of a simplex after the tool moved by `by`.
void translate(Simplex& simplex, const Vector3& by) noexcept {
  for (size_t k = 0; k < static_cast<size_t>(simplex.count); ++k) {
    simplex.point[k].w += by;
    simplex.point[k].tool += by;
  }
}

}  // namespace

Descent descend(Pair& pair, const Vector3& n) noexcept {
  const double least_gain = (pair.has_vertices() ? tolerances::kRounding : tolerances::kCurvedDescent) * pair.extent;
  const Vector3 p_start = pair.p_OT;
  Simplex simplex;
  start_along(pair, n, simplex);
  Descent best;
  best.n = n;
  best.depth = -n.dot(simplex.point[0].w);
  best.p_tool = simplex.point[0].tool;
  Vector3 shift = Vector3::Zero();
  for (int pass = 0; pass < kMaxPasses; ++pass) {
    const Vector3 next_shift = std::max(best.depth, 0.0) * best.n;
    translate(simplex, next_shift - shift);
    shift = next_shift;
    pair.p_OT = p_start + shift;
    const Result found = run(pair, simplex);
    best.iterations += found.iterations;
    if (found.verdict != Verdict::kUndecided) best.p_tool = found.p_tool - shift;
    const double depth = shift.dot(found.n) - found.lower;
    if (found.verdict != Verdict::kApart || !(depth < best.depth)) break;
    const bool converged = depth > best.depth - least_gain;
    best.n = found.n;
    best.depth = depth;
    if (converged) break;
  }
  pair.p_OT = p_start;
  return best;
}

}  // namespace tegotae::gjk
