// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/shape/shape.hpp>

#include <string>
#include <vector>

struct mjModel_;

namespace tegotae {

/// The shape of a geom, placed on its body, with the geom's friction and contact bits. A mesh is its hull; where the
/// mesh is not convex a sentence about it is added to `warnings`. Throws SceneError for a kind that no convex shape
/// stands for (height fields) and for lengths or poses that are not finite.
Shape shape_of_geom(const mjModel_& model, int geom, const std::string& file, std::vector<std::string>& warnings);

}  // namespace tegotae
