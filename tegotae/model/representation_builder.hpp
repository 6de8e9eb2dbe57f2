// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/contact/clip_workspace.hpp>
#include <tegotae/contact/intersection.hpp>
#include <tegotae/model/intermediate_representation.hpp>
#include <tegotae/model/near_object_search.hpp>

#include <span>
#include <vector>

namespace tegotae {

/// Makes the intermediate representation from the near pairs (paper, sections 4.2.2 and 4.2.3): each near object
/// becomes a plane; the tool becomes the vertices of its intersection with the object, without those on the object's
/// plane, in the tool's frame.
///
/// Where the paper is silent: pieces that do not overlap yet have no intersection, and a model must serve until the
/// next one has come. So the object is dilated towards the tool, by the gap plus the pair's reach: what would touch on
/// a way of that length becomes a contact point. A vertex on the dilated object's own boundary towards the tool is left
/// out. For curved pieces vertices are those of the inscribed stand-in, and the closest point itself is a contact point
/// too. For the physics rate: may allocate. Keeps a reference to the geometry.
class RepresentationBuilder {
 public:
  explicit RepresentationBuilder(const SceneGeometry& geometry);

  /// Fills planes and points of `model` (`sequence`, `time` and `period` are the caller's) from `pairs`, nearest first,
  /// with the tool at `X_WT`. `bodies[i]` is the state of moving_index i.
  void build(std::span<const NearPair> pairs, const Pose& X_WT, std::span<const BodyState> bodies,
             IntermediateRepresentation& model);

 private:
  RepresentationBuilder(const SceneGeometry& geometry, int vertices, int faces);

  void add_plane(const NearPair& pair, std::span<const BodyState> bodies, IntermediateRepresentation& model) const;
  void find_points(const NearPair& pair, const Pose& X_WT, std::span<const BodyState> bodies);
  void add_points(int room, IntermediateRepresentation& model);

  const SceneGeometry& geometry_;
  ClipWorkspace workspace_;
  std::vector<IntersectionVertex> vertices_;
  std::vector<ContactPoint> points_;
};

}  // namespace tegotae
