// SPDX-License-Identifier: Apache-2.0
#include <tegotae/contact/penetration.hpp>
#include <tegotae/model/near_object_search.hpp>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace tegotae {
namespace {

// The plane along `n_W` that just touches the object, for pairs whose penetration query found no answer (degenerate
// overlap): a pair that is not separated is never dropped.
void set_plane_along(const PlacedShape& tool, const PlacedShape& object, const Vector3& n_W, NearPair& pair) {
  const Vector3 d_tool = -(tool.R_WS.transpose() * n_W);
  pair.n_W = n_W;
  pair.p_WA = tool.to_world(support(*tool.shape, d_tool).p);
  pair.p_WB = object.shape->is_bounded() ? object.to_world(support(*object.shape, object.R_WS.transpose() * n_W).p)
                                         : object.p_WS;
  pair.distance = n_W.dot(pair.p_WA - pair.p_WB);
}

}  // namespace

NearObjectSearch::NearObjectSearch(const SceneGeometry& geometry) : geometry_(geometry) {
  for (size_t b = 0; b < geometry.bodies.size(); ++b) {
    const Body& body = geometry.bodies[b];
    for (size_t p = 0; p < body.pieces.size(); ++p) {
      const BoundingBox box = bounding_box(body.pieces[p], body.X_WB);
      const bool moves = body.moving_index >= 0;
      const int handle = moves ? sweep_and_prune_.add_moving(box) : sweep_and_prune_.add_static(box);
      if (moves) moving_handles_.push_back(handle);
      pieces_.resize(std::max(pieces_.size(), static_cast<size_t>(handle) + 1));
      pieces_[static_cast<size_t>(handle)] = {static_cast<int>(b), static_cast<int>(p)};
    }
  }
}

const Pose& NearObjectSearch::pose_of(const Body& body, std::span<const BodyState> bodies) const {
  return body.moving_index >= 0 ? bodies[static_cast<size_t>(body.moving_index)].X_WB : body.X_WB;
}

// Greatest speed of a point of the piece, m/s.
double NearObjectSearch::speed_of(const Body& body, const Shape& piece, std::span<const BodyState> bodies) const {
  if (body.moving_index < 0) return 0.0;
  const Twist& V_WB = bodies[static_cast<size_t>(body.moving_index)].V_WB;
  const double size = piece.polytope ? piece.polytope->radius : 0.0;
  const double arm = (piece.X_BS.p - body.p_BC).norm() + size + piece.polytope_error;
  const double speed = V_WB.linear.norm() + V_WB.angular.norm() * arm;
  return std::isfinite(speed) ? speed : 0.0;
}

// A moving body's box is enlarged by its own way, the tool's box by the rest of the reach.
void NearObjectSearch::move_boxes(std::span<const BodyState> bodies, const Reach& reach) {
  for (const int handle : moving_handles_) {
    const Piece& piece = pieces_[static_cast<size_t>(handle)];
    const Body& body = geometry_.bodies[static_cast<size_t>(piece.body)];
    const Shape& shape = body.pieces[static_cast<size_t>(piece.body_piece)];
    const double way = reach.horizon * speed_of(body, shape, bodies);
    sweep_and_prune_.update(handle, bounding_box(shape, pose_of(body, bodies)).enlarged(way));
  }
}

bool NearObjectSearch::measure(const PlacedShape& tool, const PlacedShape& object, Memory& memory, NearPair& pair) {
  const ClosestPoints closest = closest_points(tool, object, memory.cache);
  if (closest.separation == Separation::kSeparated) {
    pair.distance = closest.distance;
    pair.p_WA = closest.p_WA;
    pair.p_WB = closest.p_WB;
    pair.n_W = closest.n_W;
  } else {
    const bool known = memory.n_W != Vector3::Zero();
    const Penetration depth =
        known ? penetration_from(tool, object, memory.n_W, memory.cache) : penetration(tool, object, memory.cache);
    if (depth.valid) {
      pair.distance = -depth.depth;
      pair.p_WA = depth.p_WA;
      pair.p_WB = depth.p_WB;
      pair.n_W = depth.n_W;
    } else {
      set_plane_along(tool, object, known ? memory.n_W : closest.n_W, pair);
    }
  }
  memory.n_W = pair.n_W;
  return pair.distance < pair.reach;
}

std::span<const NearPair> NearObjectSearch::find(const Pose& X_WT, std::span<const BodyState> bodies,
                                                 const Reach& reach) {
  ++step_;
  pairs_.clear();
  move_boxes(bodies, reach);
  for (size_t t = 0; t < geometry_.tool.pieces.size(); ++t) {
    const Shape& tool_shape = geometry_.tool.pieces[t];
    const PlacedShape tool(tool_shape, X_WT);
    for (const int handle : sweep_and_prune_.candidates(bounding_box(tool_shape, X_WT).enlarged(reach.at(0.0)))) {
      const Piece& piece = pieces_[static_cast<size_t>(handle)];
      const Body& body = geometry_.bodies[static_cast<size_t>(piece.body)];
      const Shape& object_shape = body.pieces[static_cast<size_t>(piece.body_piece)];
      if (!may_touch(tool_shape, object_shape)) continue;
      Memory& memory = memories_[{static_cast<int>(t), handle}];
      memory.last_seen = step_;
      NearPair pair{static_cast<int>(t), piece.body, piece.body_piece};
      pair.reach = reach.at(speed_of(body, object_shape, bodies));
      if (measure(tool, PlacedShape(object_shape, pose_of(body, bodies)), memory, pair)) pairs_.push_back(pair);
    }
  }
  forget_distant_pairs();
  std::stable_sort(pairs_.begin(), pairs_.end(),
                   [](const NearPair& a, const NearPair& b) { return a.distance < b.distance; });
  return pairs_;
}

// A pair that left the enlarged box comes back as a new one: its old normal means nothing any more.
void NearObjectSearch::forget_distant_pairs() {
  for (auto it = memories_.begin(); it != memories_.end();) {
    it = it->second.last_seen == step_ ? std::next(it) : memories_.erase(it);
  }
}

}  // namespace tegotae
