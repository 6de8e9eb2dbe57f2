// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/types.hpp>

#include <optional>
#include <span>
#include <vector>

namespace tegotae {

/// The facets of the convex hull of `points` by Qhull, coplanar ones merged, each as the indices of its vertices.
/// Nothing if Qhull fails (the points span no volume, are not finite ...): it then frees its memory and prints
/// nothing. Allocates.
std::optional<std::vector<std::vector<int>>> hull_facets(std::span<const Vector3> points);

}  // namespace tegotae
