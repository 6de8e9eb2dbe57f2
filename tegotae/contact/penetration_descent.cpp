// SPDX-License-Identifier: Apache-2.0
#include <tegotae/contact/gjk_warm_start.hpp>
#include <tegotae/contact/penetration_descent.hpp>
#include <tegotae/contact/tolerances.hpp>

#include <algorithm>

namespace tegotae::gjk {
namespace {

constexpr int kMaxPasses = 64;

}  // namespace

Descent descend(Pair& pair, const Vector3& n) noexcept {
  const double rounding = tolerances::kRounding * pair.extent;
  const Vector3 p_start = pair.p_OT;
  Descent best;
  best.n = n;
  const MinkowskiPoint deepest = pair.support(n);
  best.depth = -n.dot(deepest.w);
  best.p_tool = deepest.tool;
  for (int pass = 0; pass < kMaxPasses; ++pass) {
    const Vector3 shift = std::max(best.depth, 0.0) * best.n;
    pair.p_OT = p_start + shift;
    Simplex simplex;
    start_along(pair, best.n, simplex);
    const Result found = run(pair, simplex);
    best.iterations += found.iterations;
    const double depth = shift.dot(found.n) - found.lower;
    const bool better = found.verdict == Verdict::kApart && depth < best.depth - rounding;
    if (found.verdict != Verdict::kUndecided) best.p_tool = found.p_tool - shift;
    if (!better) break;
    best.n = found.n;
    best.depth = depth;
  }
  pair.p_OT = p_start;
  return best;
}

}  // namespace tegotae::gjk
