// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/contact/facing_surface.hpp>

#include <cstdint>
#include <span>

namespace tegotae {

/// A place where two facing surfaces may meet first.
struct OverlayPoint {
  Vector3 p_WA = Vector3::Zero();  ///< on the tool's surface, m; the object's surface is at p_WA - gap * n_W
  double gap = 0.0;                ///< along n_W from surface to surface, m; negative where they overlap
  std::uint64_t feature = 0;       ///< kind and indices packed: the same features give the same value
};

/// The query: two placed shapes and how they face each other, as `closest_points` or `penetration` found.
struct OverlayQuery {
  const PlacedShape* tool = nullptr;    ///< bounded
  const PlacedShape* object = nullptr;  ///< any shape
  Vector3 p_WA = Vector3::Zero();       ///< closest (or deepest) point of the tool, m
  Vector3 p_WB = Vector3::Zero();       ///< of the object, m
  Vector3 n_W = Vector3::UnitZ();       ///< unit, out of the object
  double distance = 0.0;                ///< m; negative: minus the depth
  double margin = 0.0;                  ///< m
  bool closest_pair = true;             ///< whether the closest pair is added where no point is as near
  int hint_tool = 0;                    ///< where hill climbing starts: any vertex
  int hint_object = 0;
};

/// Memory of the overlay, for polytopes of at most so many vertices. Construction allocates.
struct OverlayWorkspace {
  explicit OverlayWorkspace(int max_vertices) : tool(max_vertices), object(max_vertices) {}

  FacingSurface tool;
  FacingSurface object;
};

/// The contact points of a pair: vertices of the overlay of the two facing surfaces projected along n (tool vertices
/// over the object, object vertices under the tool, crossings of edges), each with its own gap from surface to surface,
/// as many as have gap < distance + margin; unique. For a small motion of the tool that keeps these points apart, the
/// gap being a convex and piecewise linear function of the place, everything between them stays apart too.
/// Where the overlay has no point as near as the closest pair (curved shapes) that pair is added.
///
/// Exact for boxes, hulls and planes. Curved shapes are taken as FacingSurface says; points that it leaves out are
/// found by asking again at the next pose, as their gaps shrink.
/// Writes at most `points.size()`, the first found; returns how many there are: a larger value says that some were left
/// out. 0 if the tool is a plane or a value is not finite. Does not allocate. Linear in the vertices within the margin
/// of the closest pair on the one side times those on the other.
int overlay(const OverlayQuery& query, OverlayWorkspace& workspace, std::span<OverlayPoint> points) noexcept;

}  // namespace tegotae
