// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/thinning.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace tegotae {

std::vector<PlotPoint> thinned(std::span<const PlotPoint> points, std::size_t most) {
  std::vector<PlotPoint> finite;
  std::copy_if(points.begin(), points.end(), std::back_inserter(finite),
               [](const PlotPoint& point) { return std::isfinite(point.x) && std::isfinite(point.y); });
  if (finite.size() <= most) return finite;

  const std::size_t groups = std::max<std::size_t>(1, most / 2);
  std::vector<PlotPoint> kept = {finite.front()};
  for (std::size_t group = 0; group < groups; ++group) {
    const auto begin = finite.begin() + static_cast<std::ptrdiff_t>(group * finite.size() / groups);
    const auto end = finite.begin() + static_cast<std::ptrdiff_t>((group + 1) * finite.size() / groups);
    const auto [lowest, highest] =
        std::minmax_element(begin, end, [](const PlotPoint& a, const PlotPoint& b) { return a.y < b.y; });
    kept.push_back(*std::min(lowest, highest));
    if (lowest != highest) kept.push_back(*std::max(lowest, highest));
  }
  kept.push_back(finite.back());
  return kept;
}

}  // namespace tegotae
