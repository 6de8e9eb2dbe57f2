// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>

namespace tegotae {

/// Where stability ends.
struct StabilityLimit {
  double largest_stable = 0.0;     ///< N/m; 0: none was stable
  double smallest_unstable = 0.0;  ///< N/m; infinite: all that was tried was stable
  int runs = 0;
};

/// The largest stable stiffness, by bisection: first doubled or halved from `guess` (N/m, > 0) until it lies between a
/// stable and an unstable one, at most 2^7 away, then halved in the logarithm until the two are within
/// `relative_width` of each other. Takes for granted that all that is softer is stable too.
StabilityLimit find_stability_limit(const std::function<bool(double)>& is_stable, double guess, double relative_width);

}  // namespace tegotae
