// SPDX-License-Identifier: Apache-2.0
#include <tegotae/model/near_object_search.hpp>

#include <tegotae/contact/penetration.hpp>

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

// Moving bodies of so many pieces or more have a tree: of fewer each has a box of its own, cheaper than a walk.
constexpr size_t kPiecesOfTree = 8;

// Greatest distance of a point of the piece from `p_B`, m.
double radius_of(const Shape& piece, const Vector3& p_B) {
  const double own = piece.polytope ? piece.polytope->radius : 0.0;
  return (piece.X_BS.p - p_B).norm() + own + piece.polytope_error;
}

}  // namespace

NearObjectSearch::NearObjectSearch(const SceneGeometry& geometry) : geometry_(geometry) {
  for (size_t b = 0; b < geometry.bodies.size(); ++b) {
    const Body& body = geometry.bodies[b];
    if (body.moving_index >= 0 && body.pieces.size() >= kPiecesOfTree) {
      add_whole(b);
    } else {
      for (size_t p = 0; p < body.pieces.size(); ++p) add_piece(b, p);
    }
  }
}

void NearObjectSearch::add_piece(size_t body, size_t piece) {
  const Body& owner = geometry_.bodies[body];
  const BoundingBox box = bounding_box(owner.pieces[piece], owner.X_WB);
  const bool moves = owner.moving_index >= 0;
  const int handle = moves ? sweep_and_prune_.add_moving(box) : sweep_and_prune_.add_static(box);
  if (moves) moving_handles_.push_back(handle);
  boxed_.push_back({static_cast<int>(body), static_cast<int>(piece), {}, radius_of(owner.pieces[piece], owner.p_BC)});
}

void NearObjectSearch::add_whole(size_t body) {
  const Body& owner = geometry_.bodies[body];
  std::vector<BoundingBox> boxes;
  double radius = 0.0;
  for (const Shape& piece : owner.pieces) {
    boxes.push_back(bounding_box(piece, Pose{}));
    radius = std::max(radius, radius_of(piece, owner.p_BC));
  }
  BoxTree tree(boxes);
  moving_handles_.push_back(sweep_and_prune_.add_moving(turned_box(tree.bounds(), owner.X_WB)));
  boxed_.push_back({static_cast<int>(body), -1, std::move(tree), radius});
}

const Pose& NearObjectSearch::pose_of(const Body& body, std::span<const BodyState> bodies) const {
  return body.moving_index >= 0 ? bodies[static_cast<size_t>(body.moving_index)].X_WB : body.X_WB;
}

// Greatest speed of a point at most `radius` (m) from the body's centre of mass, m/s.
double NearObjectSearch::speed_of(const Body& body, double radius, std::span<const BodyState> bodies) const {
  if (body.moving_index < 0) return 0.0;
  const Twist& V_WB = bodies[static_cast<size_t>(body.moving_index)].V_WB;
  const double speed = V_WB.linear.norm() + V_WB.angular.norm() * radius;
  return std::isfinite(speed) ? speed : 0.0;
}

// A moving body's box is enlarged by its own way, the tool's box by the rest of the reach.
void NearObjectSearch::move_boxes(std::span<const BodyState> bodies, const Reach& reach) {
  for (const int handle : moving_handles_) {
    const Boxed& boxed = boxed_[static_cast<size_t>(handle)];
    const Body& body = geometry_.bodies[static_cast<size_t>(boxed.body)];
    const Pose& X_WB = pose_of(body, bodies);
    const BoundingBox box = boxed.tree ? turned_box(boxed.tree->bounds(), X_WB)
                                       : bounding_box(body.pieces[static_cast<size_t>(boxed.body_piece)], X_WB);
    sweep_and_prune_.update(handle, box.enlarged(reach.horizon * speed_of(body, boxed.radius, bodies)));
  }
}

// Fills `pieces_` with those whose boxes are within reach of a piece of the tool.
void NearObjectSearch::find_pieces(const Shape& tool_shape, const Pose& X_WT, std::span<const BodyState> bodies,
                                   const Reach& reach) {
  pieces_.clear();
  for (const int handle : sweep_and_prune_.candidates(bounding_box(tool_shape, X_WT).enlarged(reach.at(0.0)))) {
    const Boxed& boxed = boxed_[static_cast<size_t>(handle)];
    if (!boxed.tree) {
      pieces_.push_back({boxed.body, boxed.body_piece});
      continue;
    }
    const Body& body = geometry_.bodies[static_cast<size_t>(boxed.body)];
    const Pose X_BT = pose_of(body, bodies).inverse() * X_WT;
    const double most = reach.at(speed_of(body, boxed.radius, bodies));
    const auto first = static_cast<std::ptrdiff_t>(pieces_.size());
    boxed.tree->visit_overlapping(bounding_box(tool_shape, X_BT).enlarged(most), [&](int piece) {
      pieces_.push_back({boxed.body, piece});
    });
    std::sort(pieces_.begin() + first, pieces_.end(),
              [](const Piece& a, const Piece& b) { return a.body_piece < b.body_piece; });
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
    find_pieces(tool_shape, X_WT, bodies, reach);
    const PlacedShape tool(tool_shape, X_WT);
    for (const Piece& piece : pieces_) add_pair(static_cast<int>(t), tool, piece, bodies, reach);
  }
  forget_distant_pairs();
  std::stable_sort(pairs_.begin(), pairs_.end(),
                   [](const NearPair& a, const NearPair& b) { return a.distance < b.distance; });
  return pairs_;
}

void NearObjectSearch::add_pair(int tool_piece, const PlacedShape& tool, const Piece& piece,
                                std::span<const BodyState> bodies, const Reach& reach) {
  const Body& body = geometry_.bodies[static_cast<size_t>(piece.body)];
  const Shape& object_shape = body.pieces[static_cast<size_t>(piece.body_piece)];
  if (!may_touch(*tool.shape, object_shape)) return;
  Memory& memory = memories_[{tool_piece, piece.body, piece.body_piece}];
  memory.last_seen = step_;
  NearPair pair{tool_piece, piece.body, piece.body_piece};
  pair.reach = reach.at(speed_of(body, radius_of(object_shape, body.p_BC), bodies));
  if (measure(tool, PlacedShape(object_shape, pose_of(body, bodies)), memory, pair)) pairs_.push_back(pair);
}

// A pair that left the enlarged box comes back as a new one: its old normal means nothing any more.
void NearObjectSearch::forget_distant_pairs() {
  for (auto it = memories_.begin(); it != memories_.end();) {
    it = it->second.last_seen == step_ ? std::next(it) : memories_.erase(it);
  }
}

}  // namespace tegotae
