// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/contact/clip_workspace.hpp>
#include <tegotae/contact/intersection_vertex.hpp>
#include <tegotae/contact/placed_shape.hpp>

#include <span>
#include <vector>

namespace tegotae {

// Vertices of the intersection of a tool and an object, the object dilated along `dilation_W` (m, zero: not at all):
// each of its face planes with outward normal n moves outward by max(0, n . dilation_W). That contains every translate
// of the object along the way, and leaves the faces that the way runs along where they are: an object dilated along its
// contact normal grows towards the tool, not sideways. The tool is bounded; the object may be a plane (a half-space).
// Curved shapes are taken as their stand-in polytopes. Vertices are unique (to tolerances::kSameVertex), in the world
// frame, and do not lose precision far from the world's origin.
//
// Shapes that do not overlap yet: Muller and Preparata need a point strictly inside both, and the paper does not say
// where it comes from while the shapes are apart. Here the caller dilates the object by the gap plus a margin, so that
// the two overlap by the margin at the closest points, and `interior_point` gives the point: the midpoint of the
// closest pair may lie on the tool's boundary, the centre of the greatest ball inside both never does.

/// The dual form (Muller and Preparata 1978): with `origin_W`, a point strictly inside both, as origin each face plane
/// n.p <= d becomes the dual point n / d; Qhull takes the hull of the dual points; each of its facets is, dualised
/// back, a vertex. Names no features. Appends to `vertices`; returns false, and appends nothing, if `origin_W` is not
/// inside both by more than tolerances::kOnPlane, if the tool is a plane, a pose or the dilation is not finite or Qhull
/// fails. Allocates: for the physics thread and for tests.
bool intersection_by_duality(const PlacedShape& tool, const PlacedShape& object, const Vector3& dilation_W,
                             const Vector3& origin_W, std::vector<IntersectionVertex>& vertices);

/// The same about an origin of its own, from `interior_point`; false also if the shapes share no volume.
bool intersection_by_duality(const PlacedShape& tool, const PlacedShape& object, const Vector3& dilation_W,
                             std::vector<IntersectionVertex>& vertices);

inline constexpr int kClipWorkspaceTooSmall = -1;

/// The clip form: vertices of each shape inside the other, and edges of each cut by the other's faces (Cyrus and
/// Beck 1978). Needs no interior point. Whatever lies within tolerances::kOnPlane of a plane lies on it, for both
/// shapes alike, and points that coincide are one: coplanar faces and coincident shapes lose no vertex and give none
/// twice. Of coincident features the one named is a tool vertex before an object vertex before a tool edge before an
/// object edge, and of faces the one of the lowest index.
/// Shapes that only touch give the vertices of the point, segment or polygon that they share.
/// Writes at most `vertices.size()` and returns how many there are (more than that: the rest was left out); 0 if the
/// tool is a plane or a pose or the dilation is not finite; kClipWorkspaceTooSmall if the workspace does not hold the
/// shapes. Does not allocate.
int intersection_by_clipping(const PlacedShape& tool, const PlacedShape& object, const Vector3& dilation_W,
                             ClipWorkspace& workspace, std::span<IntersectionVertex> vertices) noexcept;

}  // namespace tegotae
