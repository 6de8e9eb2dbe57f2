// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/types.hpp>

namespace tegotae {

// Limits on one vector (a force or a torque), as pure functions of finite arguments below 1e150, so that squares do not
// overflow. Each gives `target` itself, bit for bit, where it is within the limit.

/// The vector nearest to `target` that lies within `step` of the segment from zero to `previous`.
///
/// So the magnitude grows by at most `step`; growth keeps the direction; shrinking along the same direction is free;
/// and a turn or a reversal may put at most `step` off the old direction. It is the projection on a convex set, hence
/// continuous: two targets near each other give results at least as near (no chatter).
Vector3 growth_limited(const Vector3& target, const Vector3& previous, double step) noexcept;

/// `target` if its norm is within `limit`, else the vector of the same direction and norm `limit` (rounded inward by a
/// few units in the last place, so that the norm as computed never exceeds the limit).
Vector3 saturated(const Vector3& target, double limit) noexcept;

}  // namespace tegotae
