// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/contact/clip_dilation.hpp>
#include <tegotae/contact/clip_locator.hpp>
#include <tegotae/contact/clip_polygon.hpp>
#include <tegotae/contact/clip_side.hpp>
#include <tegotae/contact/clip_vertex_set.hpp>
#include <tegotae/shape/shape.hpp>

#include <vector>

namespace tegotae {

/// Memory of the clip form, sized at construction for two polytopes of at most so many vertices and faces each.
/// One for each thread; nothing in it outlives a query.
class ClipWorkspace {
 public:
  /// Allocates. Throws std::invalid_argument unless 0 < vertices, faces < IntersectionFeature::kIndexLimit.
  ClipWorkspace(int max_vertices, int max_faces);

  /// Whether shapes of this size can be given.
  bool holds(const Shape& shape) const noexcept;

 private:
  friend class IntersectionClipper;

  int max_vertices_, max_faces_;
  ClipSide tool_, object_;
  ClipDilation dilation_;
  std::vector<ClipPlane> tool_planes_, object_planes_;
  ClipPolygon polygon_;
  ClipVertexSet vertices_;
};

}  // namespace tegotae
