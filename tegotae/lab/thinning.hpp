// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace tegotae {

struct PlotPoint {
  double x = 0.0, y = 0.0;
};

/// At most about `most` of the points, in their order, that draw the same curve: the points are taken in equal groups,
/// and of each the lowest and the highest stay, and the first and the last of all. Points that are not finite are left
/// out.
std::vector<PlotPoint> thinned(std::span<const PlotPoint> points, std::size_t most);

}  // namespace tegotae
