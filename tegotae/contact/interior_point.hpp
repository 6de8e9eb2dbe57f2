// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/contact/placed_shape.hpp>

namespace tegotae {

/// A point inside a tool and a dilated object.
struct InteriorPoint {
  bool exists = false;            ///< the two share more than kOnPlane of thickness
  Vector3 p_W = Vector3::Zero();  ///< m
  double slack = 0.0;             ///< m, least distance to a face plane of either
};

/// The centre of the greatest ball inside both the tool (bounded) and the object dilated along `dilation_W` (as in
/// intersection.hpp; the object may be a plane): the point p whose least distance r to the face planes n_i.p <= d_i of
/// both is greatest, the linear program  max r : n_i.p + r <= d_i.  Curved shapes are taken as their stand-in
/// polytopes. For shapes that are apart by a gap, dilate by the gap plus a margin: where the midpoint of the closest
/// pair may lie on the tool's boundary, this point is inside by half the margin wherever the shapes are wide enough for
/// that. Solved by the simplex method on the dual program, whose basis is four planes. Bounded, does not allocate. Not
/// existing for a tool that is a plane or invalid input.
InteriorPoint interior_point(const PlacedShape& tool, const PlacedShape& object, const Vector3& dilation_W) noexcept;

}  // namespace tegotae
