// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/contact/clip_workspace.hpp>
#include <tegotae/contact/intersection_frame.hpp>

#include <span>

namespace tegotae {

/// One query of the clip form, in the object's frame: `intersection_by_clipping` is its interface. Valid inputs only.
class IntersectionClipper {
 public:
  IntersectionClipper(const PlacedShape& tool, const PlacedShape& object, const IntersectionFrame& frame,
                      ClipWorkspace& workspace) noexcept;

  /// The vertices, in the object's frame; they stand in the workspace until the next query.
  const ClipVertexSet& run() noexcept;

 private:
  /// One of the two bodies as the other's vertices and edges see it.
  struct Body {
    const Polytope* polytope = nullptr;  ///< null: a half-space
    std::span<const ClipPlane> planes;   ///< those that may matter; none: walk over the faces
  };

  void collect() noexcept;
  bool list_object_planes() noexcept;
  void list_tool_planes() noexcept;
  template <class Function>
  static void with_locator(const Body& body, const Function& function) noexcept;
  bool place_tool() noexcept;
  bool place_object() noexcept;
  static bool classify(const Body& body, const Polytope& polytope, ClipSide& side) noexcept;
  void add_tool_vertices() noexcept;
  void add_object_vertices() noexcept;
  void add_tool_edges() noexcept;
  void add_object_edges() noexcept;
  void add_broken_faces() noexcept;
  void cut_face_polygon(const ClipPlane& plane) noexcept;
  void cut_by_tool() noexcept;
  void add_corners(int face) noexcept;

  IntersectionFrame frame_;
  ClipWorkspace& memory_;
  Body tool_, object_;
};

}  // namespace tegotae
