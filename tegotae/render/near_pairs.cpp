// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/near_pairs.hpp>

#include <tegotae/math/rotation.hpp>
#include <tegotae/render/facing.hpp>

#include <algorithm>

namespace tegotae {
namespace {

constexpr int kTableSize = 2 * kMaxNearPieces;

size_t slot_of(const TrackedPair& pair) noexcept {
  const auto mixed = static_cast<std::uint64_t>(pair.tool_piece) * 0x9e3779b97f4a7c15u +
                     static_cast<std::uint64_t>(pair.body) * 0xc2b2ae3d27d4eb4fu +
                     static_cast<std::uint64_t>(pair.body_piece) * 0x165667b19e3779f9u;
  return static_cast<size_t>((mixed ^ (mixed >> 29)) % kTableSize);
}

}  // namespace

double radius_about(const Shape& piece, const Vector3& p_B) noexcept {
  const double own = piece.polytope ? piece.polytope->radius + piece.polytope_error : 0.0;
  return (piece.X_BS.p - p_B).norm() + own;
}

NearPairs::NearPairs(const SceneGeometry& geometry)
    : geometry_(geometry),
      pairs_(kMaxNearPieces),
      former_(kMaxNearPieces),
      due_(kMaxNearPieces),
      former_due_(kMaxNearPieces),
      near_body_(kMaxNearPieces),
      renamed_(kMaxNearPieces),
      table_(kTableSize, -1) {
  for (const Body& body : geometry.bodies) {
    double radius = 0.0;
    for (const Shape& piece : body.pieces) radius = std::max(radius, radius_about(piece, body.p_BC));
    radii_.push_back(radius);
  }
}

void NearPairs::reset() noexcept {
  count_ = body_count_ = 0;
  sequence_ = 0;
}

bool NearPairs::take(const IntermediateRepresentation& model, const Pose& X_WT) noexcept {
  const bool fresh = model.sequence != sequence_;
  if (fresh) name(model, X_WT);
  sequence_ = model.sequence;
  move_bodies(model);
  return fresh;
}

void NearPairs::index_former() noexcept {
  std::fill(table_.begin(), table_.end(), -1);
  for (int i = 0; i < former_count_; ++i) {
    size_t slot = slot_of(former_[static_cast<size_t>(i)]);
    while (table_[slot] >= 0) slot = (slot + 1) % kTableSize;
    table_[slot] = i;
  }
}

int NearPairs::find_former(const TrackedPair& wanted) const noexcept {
  for (size_t slot = slot_of(wanted); table_[slot] >= 0; slot = (slot + 1) % kTableSize) {
    if (former_[static_cast<size_t>(table_[slot])].is_same_pair(wanted)) return table_[slot];
  }
  return -1;
}

// Bodies that were near before stand where the last tick saw them, until `move_bodies`.
void NearPairs::name_bodies(const IntermediateRepresentation& model) noexcept {
  bodies_.swap(former_bodies_);
  former_body_count_ = body_count_;
  body_count_ = model.body_count;
  for (int i = 0; i < body_count_; ++i) {
    const NearBody& near = model.bodies[static_cast<size_t>(i)];
    TrackedBody& body = bodies_[static_cast<size_t>(i)];
    body = {};
    body.moving_index = near.moving_index;
    body.X_WB = near.X_WB;
    body.p_WC = near.p_WC;
    for (int k = 0; k < former_body_count_; ++k) {
      const TrackedBody& former = former_bodies_[static_cast<size_t>(k)];
      if (former.moving_index == body.moving_index) body.X_WB = former.X_WB;
    }
  }
}

void NearPairs::name(const IntermediateRepresentation& model, const Pose& X_WT) noexcept {
  // Rooms as they are now, before odometers and bodies are changed.
  for (int i = 0; i < count_; ++i) {
    double& due = due_[static_cast<size_t>(i)];
    if (due < kFar) due = room_of(i);
  }
  pairs_.swap(former_);
  due_.swap(former_due_);
  former_count_ = count_;
  tool_travelled_ = travelled_ = 0.0;
  next_look_ = -kFar;
  name_bodies(model);
  index_former();
  std::fill_n(renamed_.begin(), former_count_, -1);
  count_ = 0;
  for (const NearPieces& near : model.used_pairs()) {
    const auto i = static_cast<size_t>(count_++);
    TrackedPair& pair = pairs_[i];
    pair = {};
    pair.tool_piece = near.tool_piece;
    pair.body = near.body;
    pair.body_piece = near.body_piece;
    pair.near_body = near.near_body;
    near_body_[i] = near.near_body;
    const int known = find_former(pair);
    if (near.near_body >= 0) {
      TrackedBody& body = bodies_[static_cast<size_t>(near.near_body)];
      body.radius = radii_[static_cast<size_t>(near.body)];
      body.p_BC = geometry_.bodies[static_cast<size_t>(near.body)].p_BC;
    }
    if (known >= 0) {
      renamed_[static_cast<size_t>(known)] = static_cast<int>(i);
      pair = former_[static_cast<size_t>(known)];
      pair.near_body = near.near_body;
      due_[i] = former_due_[static_cast<size_t>(known)];
    } else {
      pair.n_B = near.n_B;
      due_[i] = room_by_plane(pair, X_WT);
    }
  }
}

Pose NearPairs::pose_of(const TrackedPair& pair) const noexcept {
  return pair.near_body < 0 ? geometry_.bodies[static_cast<size_t>(pair.body)].X_WB : moving(pair.near_body).X_WB;
}

double NearPairs::room_by_plane(TrackedPair& pair, const Pose& X_WT) const noexcept {
  const Body& body = geometry_.bodies[static_cast<size_t>(pair.body)];
  const Pose X_WB = pose_of(pair);
  const PlacedShape tool(geometry_.tool.pieces[static_cast<size_t>(pair.tool_piece)], X_WT);
  const PlacedShape object(body.pieces[static_cast<size_t>(pair.body_piece)], X_WB);
  return facing_along(tool, object, X_WB.q * pair.n_B, pair.cache).gap;
}

void NearPairs::move_bodies(const IntermediateRepresentation& model) noexcept {
  bodies_way_ = 0.0;
  for (int i = 0; i < body_count_; ++i) {
    const NearBody& near = model.bodies[static_cast<size_t>(i)];
    TrackedBody& body = bodies_[static_cast<size_t>(i)];
    const Pose X_WB = near.X_WB;
    const Vector6 way = displacement(body.X_WB, X_WB, body.p_BC);
    body.linear = way.head<3>().norm();
    body.angular = way.tail<3>().norm();
    body.X_WB = X_WB;
    body.p_WC = near.p_WC;
    const double most = body.linear + body.angular * body.radius;
    body.travelled += most;
    bodies_way_ = std::max(bodies_way_, most);
  }
  travelled_ += bodies_way_;
}

int NearPairs::nearest_below(double room) noexcept {
  if (room + travelled_ < next_look_) return -1;
  double least = kFar;
  int nearest = -1;
  for (int i = 0; i < count_; ++i) {
    const double own = room_of(i);
    if (own >= least) continue;
    least = own;
    nearest = i;
  }
  next_look_ = least + travelled_;
  return least < room ? nearest : -1;
}

double NearPairs::take_out(int pair, int contact) noexcept {
  const double room = room_of(pair);
  due_[static_cast<size_t>(pair)] = 2.0 * kFar;
  pairs_[static_cast<size_t>(pair)].contact = contact;
  return room;
}

void NearPairs::put_back(int pair, double room, const Vector3& n_W, const ClosestPointsCache& cache) noexcept {
  TrackedPair& tracked = pairs_[static_cast<size_t>(pair)];
  tracked.contact = -1;
  tracked.n_B = pose_of(tracked).q.conjugate() * n_W;
  tracked.cache = cache;
  due_[static_cast<size_t>(pair)] = room + travelled_of(tracked.near_body);
  next_look_ = std::min(next_look_, room + travelled_);
}

}  // namespace tegotae
