// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/shape/polytope.hpp>

namespace tegotae {

/// A polytope inscribed in a curved shape and how far the shape's surface stands out from it, m.
struct StandIn {
  Polytope polytope;
  double error = 0.0;
};

/// Stand-ins, in the shape's frame with the axes of `Shape`. Lengths in m, positive. All allocate.
StandIn sphere_stand_in(double radius);
StandIn capsule_stand_in(double radius, double half_length);
StandIn cylinder_stand_in(double radius, double half_height);
StandIn ellipsoid_stand_in(const Vector3& semi_axes);

}  // namespace tegotae
