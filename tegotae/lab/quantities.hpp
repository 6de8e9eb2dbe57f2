// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/figure.hpp>

namespace tegotae {

// What figures draw of a tick. `axis` is a unit vector in the world.

/// Coordinate of the tool frame's origin along `axis`, m.
Quantity position_along(const Vector3& axis);

/// Angle by which the tool is turned, from unturned, about `axis`, degrees in (-180, 180]. For motions that turn about
/// this axis only.
Quantity angle_about(const Vector3& axis);

/// Force of the method along `axis`, N.
Quantity force_along(const Vector3& axis);

/// Torque of the method about the tool's centre of mass along `axis`, N m.
Quantity torque_along(const Vector3& axis);

}  // namespace tegotae
