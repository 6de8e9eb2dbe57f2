// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/contact/gjk.hpp>

namespace tegotae::gjk {

/// A local minimum of the depth of the cores over directions, object's frame.
struct Descent {
  Vector3 n = Vector3::UnitZ();      ///< unit, from object to tool
  double depth = 0.0;                ///< m; moving the tool by depth * n parts the cores; negative when they are apart
  Vector3 p_tool = Vector3::Zero();  ///< deepest point of the tool's core; p_tool + depth * n lies on the object's, m
  int iterations = 0;                ///< of all GJK runs together
};

/// Descends from the unit direction `n`. One pass: move the tool out by its depth along n, so that the cores just touch
/// the plane normal to n; find the closest points there. Where they coincide, n is normal to the facing surfaces and
/// the depth a local minimum. Else the direction n' of the closest points is better: the plane normal to n' supports
/// the Minkowski difference and parts it from the moved origin by g > 0, so depth(n') <= depth(n) - g. On a polytope
/// pair the passes walk from face to face of the difference and end exactly. On a smooth one each pass shrinks the
/// error of n by the ratio of depth to the difference's radius of curvature. Where n already parts the cores, the tool
/// is left where it is, and the closest points are the answer. Does not allocate; bounded.
Descent descend(Pair& pair, const Vector3& n) noexcept;

}  // namespace tegotae::gjk
