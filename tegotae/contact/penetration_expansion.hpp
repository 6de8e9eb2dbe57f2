// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/contact/gjk.hpp>

namespace tegotae::gjk {

/// Depth of the cores along a direction n (object's frame): moving the tool by depth * n parts the cores.
struct CoreDepth {
  Vector3 n = Vector3::UnitZ();  ///< unit, from object to tool
  double depth = 1e300;          ///< m; negative when the plane normal to n parts them as they are
  int iterations = 0;
};

/// The direction of least depth over the whole sphere, by the expanding polytope (van den Bergen 2001) on the Minkowski
/// difference object - tool: a polytope inside it grows by the support point of the face nearest the origin until that
/// face is one of the difference itself; distances to faces carry a sign, so the origin may lie outside (touching).
/// Ends within rounding for polytopes and within 1e-6 of the extent for curved shapes, or where the fixed capacity is
/// full; the depth returned always holds for the n returned. A flat difference gives the normal of its plane. Does not
/// allocate (about 40 kB of stack); bounded.
CoreDepth least_depth(Pair& pair) noexcept;

}  // namespace tegotae::gjk
