// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace tegotae::tolerances {

// Every tolerance of the contact layer, with its unit and its reason. Lengths are at haptic scale: at a stiffness of
// 9000 N/m, 4.4e-6 m is the smallest force that a hand feels (0.04 N).

/// Dimensionless. A distance is reported only if the support planes prove at least this part of it.
inline constexpr double kCertificate = 0.999;

/// Dimensionless, times the extent of a pair (the greatest coordinate that enters a Minkowski difference): what
/// rounding leaves in one coordinate of it, 16 ulp. Iterations stop at it: nothing below it has a meaning.
inline constexpr double kRounding = 16.0 * 2.220446049250313e-16;

/// Dimensionless, times the extent of a pair: no shorter distance is reported. 64 roundings, so that the certificate
/// proves a distance and not its rounding: 2e-13 m for bodies of 1 m.
inline constexpr double kLeastDistance = 64.0 * kRounding;

/// Sine of the angle below which a triangle is a sliver, and likewise for the volume of a flat tetrahedron: its normal
/// is noise.
inline constexpr double kSliver = 1e-13;

/// Dimensionless: the part of a triangle's area that rounding leaves in a barycentric coordinate, 64 ulp.
inline constexpr double kBarycentric = 64.0 * 2.220446049250313e-16;

/// Dimensionless, times the extent of a pair: where the expanding polytope stops on curved shapes. Between local minima
/// that differ by less either may be found; the descent that follows makes the one found exact.
inline constexpr double kCurvedDepth = 1e-6;

/// Dimensionless, times the extent of a pair: a pass of the descent that gains less ends it on curved shapes. The
/// gains fall geometrically, by the square of depth over radius of curvature, so what is left is of the same order.
inline constexpr double kCurvedDescent = 1e-12;

/// m. Shapes that are apart by less count as touching for a penetration query: its depth is then 0. Ten thousand times
/// finer than what a hand feels (4.4e-6 m), and well above what a curved pair leaves uncertified.
inline constexpr double kTouching = 1e-9;

/// m. A point so near to a plane lies on it. Far above the rounding of coordinates (1e-13 m at 1 km from the world's
/// origin), far below kSameVertex: faces that were meant to be coplanar are taken as such in every place and pose.
inline constexpr double kOnPlane = 1e-11;

/// m. Vertices of an intersection nearer to each other than this are one. At 9000 N/m it is 9e-6 N.
inline constexpr double kSameVertex = 1e-9;

/// Sine of the angle to the direction of projection below which a face stands upright and has no surface to be seen:
/// over a margin of 20 mm it would be 2e-8 m wide.
inline constexpr double kUpright = 1e-6;

/// m. A point so little outside a surface's outline, seen along the direction of projection, is still over it;
/// crossings of edges nearer than half of it to a vertex are that vertex.
inline constexpr double kOutline = 2e-9;

}  // namespace tegotae::tolerances
