// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/contact/placed_shape.hpp>

#include <cstdint>
#include <span>
#include <vector>

namespace tegotae {

/// Which features of the two shapes meet in a vertex of their intersection; the same features give the same value
/// while the shapes move, so it matches contact points from one step to the next. For curved shapes features are
/// those of the stand-in polytope.
enum class IntersectionVertexKind : std::uint8_t {
  kToolVertex,
  kObjectVertex,
  kToolEdgeObjectFace,
  kObjectEdgeToolFace
};

struct IntersectionVertex {
  Vector3 p_W = Vector3::Zero();  ///< m
  std::uint64_t feature = 0;      ///< kind and indices packed; 0 = unknown (the dual form does not name features)
};

/// Vertices of the intersection of the tool and the object, the object dilated along `dilation_W` (m, zero: not at
/// all): each of its face planes with outward normal n moves outward by max(0, n . dilation_W). That contains every
/// translate of the object along the way, and leaves the faces that the way runs along where they are: an object
/// dilated along its contact normal grows towards the tool, not sideways. After Muller and Preparata (1978): with
/// `origin_W`, a point strictly inside both, as origin each face plane n.p <= d becomes the dual point n / d; Qhull
/// takes the hull of the dual points; each of its facets is, dualised back, a vertex. Vertices are unique. Appends to
/// `vertices`; returns false if `origin_W` is not strictly inside both (nothing is appended). Allocates: for the
/// physics thread and for tests.
bool intersection_by_duality(const PlacedShape& tool, const PlacedShape& object, const Vector3& dilation_W,
                             const Vector3& origin_W, std::vector<IntersectionVertex>& vertices);

/// Memory of the clip form, sized at construction for polytopes of at most so many vertices, faces and edges.
class ClipWorkspace;

/// The same set of vertices by clipping each polytope's edges with the other's faces (Cyrus and Beck 1978); needs no
/// interior point. Vertices are unique; ties are settled consistently, so coplanar faces and coincident
/// shapes lose none. Writes at most `capacity.size()` vertices and returns how many there are (a larger return value
/// says that some were left out). Does not allocate.
int intersection_by_clipping(const PlacedShape& tool, const PlacedShape& object, const Vector3& dilation_W,
                             ClipWorkspace& workspace, std::span<IntersectionVertex> vertices) noexcept;

}  // namespace tegotae
