// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/stability_search.hpp>

#include <cmath>
#include <limits>

namespace tegotae {

StabilityLimit find_stability_limit(const std::function<bool(double)>& is_stable, double guess, double relative_width) {
  constexpr int kMaxDoublings = 7;
  StabilityLimit limit;
  limit.smallest_unstable = std::numeric_limits<double>::infinity();
  const auto run = [&](double stiffness) {
    ++limit.runs;
    const bool stable = is_stable(stiffness);
    (stable ? limit.largest_stable : limit.smallest_unstable) = stiffness;
    return stable;
  };

  const bool up = run(guess);
  double stiffness = guess;
  for (int i = 0; i < kMaxDoublings; ++i) {
    stiffness *= up ? 2.0 : 0.5;
    if (run(stiffness) != up) break;
  }
  if (limit.largest_stable == 0.0 || !std::isfinite(limit.smallest_unstable)) return limit;
  while (limit.smallest_unstable > limit.largest_stable * (1.0 + relative_width)) {
    run(std::sqrt(limit.largest_stable * limit.smallest_unstable));
  }
  return limit;
}

}  // namespace tegotae
