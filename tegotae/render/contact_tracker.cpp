// SPDX-License-Identifier: Apache-2.0
#include <tegotae/contact/penetration.hpp>
#include <tegotae/render/contact_tracker.hpp>
#include <tegotae/render/tolerances.hpp>

#include <algorithm>
#include <cmath>

namespace tegotae {
namespace {

constexpr int kTableSize = 2 * kMaxNearPieces;
constexpr int kMaxPointsOfPair = 1024;

size_t slot_of(const NearContact& contact) noexcept {
  const auto mixed = static_cast<std::uint64_t>(contact.tool_piece) * 0x9e3779b97f4a7c15u +
                     static_cast<std::uint64_t>(contact.body) * 0xc2b2ae3d27d4eb4fu +
                     static_cast<std::uint64_t>(contact.body_piece) * 0x165667b19e3779f9u;
  return static_cast<size_t>((mixed ^ (mixed >> 29)) % kTableSize);
}

double radius_about(const Shape& shape, const Vector3& p_B) {
  const double own = shape.polytope ? shape.polytope->radius + shape.polytope_error : 0.0;
  return (shape.X_BS.p - p_B).norm() + own;
}

int most_vertices(const SceneGeometry& geometry) {
  size_t most = 8;
  const auto include = [&most](const std::vector<Shape>& pieces) {
    for (const Shape& piece : pieces) most = std::max(most, piece.polytope ? piece.polytope->vertices.size() : 0);
  };
  include(geometry.tool.pieces);
  for (const Body& body : geometry.bodies) include(body.pieces);
  return static_cast<int>(most);
}

}  // namespace

ContactTracker::ContactTracker(const SceneGeometry& geometry, const FrictionSettings& friction)
    : geometry_(geometry),
      friction_(friction),
      contacts_(kMaxNearPieces),
      former_(kMaxNearPieces),
      table_(kTableSize, -1),
      workspace_(most_vertices(geometry)),
      points_(kMaxPointsOfPair) {
  for (const Shape& piece : geometry.tool.pieces) {
    tool_radius_ = std::max(tool_radius_, radius_about(piece, geometry.tool.mass.centre_of_mass));
  }
}

void ContactTracker::reset() noexcept {
  count_ = 0;
  sequence_ = 0;
}

const Shape& ContactTracker::tool_shape(const NearContact& contact) const noexcept {
  return geometry_.tool.pieces[static_cast<size_t>(contact.tool_piece)];
}

const Shape& ContactTracker::body_shape(const NearContact& contact) const noexcept {
  return geometry_.bodies[static_cast<size_t>(contact.body)].pieces[static_cast<size_t>(contact.body_piece)];
}

// MuJoCo's rules: the greater coefficient, and frictionless only where both ask for it.
FrictionLaw ContactTracker::friction_between(const Shape& a, const Shape& b) const noexcept {
  FrictionLaw law;
  law.compliance = friction_.compliance;
  if (a.frictionless && b.frictionless) return law;
  law.static_coefficient = friction_.coefficient.value_or(friction_.scale * std::max(a.friction, b.friction));
  law.kinetic_coefficient = friction_.kinetic * law.static_coefficient;
  law.viscous = friction_.viscous;
  return law;
}

void ContactTracker::take(const IntermediateRepresentation& model, const Pose& X_WP) noexcept {
  skipped_ = measured_ = 0;
  if (model.sequence != sequence_) take_pairs(model);
  sequence_ = model.sequence;
  move_objects(model, X_WP);
}

int ContactTracker::find(const NearContact& wanted) const noexcept {
  for (size_t slot = slot_of(wanted); table_[slot] >= 0; slot = (slot + 1) % kTableSize) {
    if (former_[static_cast<size_t>(table_[slot])].is_same_pair(wanted)) return table_[slot];
  }
  return -1;
}

void ContactTracker::take_pairs(const IntermediateRepresentation& model) noexcept {
  contacts_.swap(former_);
  former_count_ = count_;
  std::fill(table_.begin(), table_.end(), -1);
  for (int i = 0; i < former_count_; ++i) {
    size_t slot = slot_of(former_[static_cast<size_t>(i)]);
    while (table_[slot] >= 0) slot = (slot + 1) % kTableSize;
    table_[slot] = i;
  }
  count_ = 0;
  for (const NearPieces& pair : model.used_pairs()) {
    NearContact& contact = contacts_[static_cast<size_t>(count_++)];
    contact = {};
    contact.tool_piece = pair.tool_piece;
    contact.body = pair.body;
    contact.body_piece = pair.body_piece;
    const int known = find(contact);
    if (known >= 0) {
      contact = former_[static_cast<size_t>(known)];
      continue;
    }
    const Body& body = geometry_.bodies[static_cast<size_t>(pair.body)];
    contact.moving_index = body.moving_index;
    contact.X_WB = pair.near_body >= 0 ? model.bodies[static_cast<size_t>(pair.near_body)].X_WB.pose() : body.X_WB;
    contact.friction = friction_between(tool_shape(contact), body_shape(contact));
  }
}

void ContactTracker::move_objects(const IntermediateRepresentation& model, const Pose& X_WP) noexcept {
  for (int i = 0; i < count_; ++i) {
    const int near_body = model.pairs[static_cast<size_t>(i)].near_body;
    NearContact& contact = contacts_[static_cast<size_t>(i)];
    contact.deepened = 0.0;
    if (near_body < 0) continue;
    const NearBody& body = model.bodies[static_cast<size_t>(near_body)];
    const Pose X_WB = body.X_WB;
    contact.p_WC = body.p_WC;
    const Vector3 p_BC = geometry_.bodies[static_cast<size_t>(contact.body)].p_BC;
    const Vector6 way = displacement(contact.X_WB, X_WB, p_BC);
    const double most = way.head<3>().norm() + way.tail<3>().norm() * radius_about(body_shape(contact), p_BC);
    if (most == 0.0) continue;
    if (contact.measured) contact.room = contact.now.gap;
    contact.room -= most;
    contact.deepened = most;
    contact.measured = false;
    contact.bristle.follow_object(contact.X_WB, X_WB, X_WP, contact.now.n_W);
    contact.X_WB = X_WB;
  }
}

bool ContactTracker::spend() noexcept {
  if (measured_ >= tolerance::kDistanceBudget) {
    ++skipped_;
    return false;
  }
  ++measured_;
  return true;
}

// A pair that is not separated has the plane of the least way out, followed from the last normal: a tool in a thin
// plate is put back to the side that it came from.
Facing ContactTracker::face(NearContact& contact, const Pose& X_WP) noexcept {
  const PlacedShape tool(tool_shape(contact), X_WP), object(body_shape(contact), contact.X_WB);
  const ClosestPoints closest = closest_points(tool, object, contact.cache);
  if (closest.separation == Separation::kSeparated) {
    return {true, closest.distance, closest.p_WA, closest.p_WB, closest.n_W};
  }
  const bool known = contact.now.n_W.squaredNorm() > 0.5;
  const Penetration depth =
      known ? penetration_from(tool, object, contact.now.n_W, contact.cache) : penetration(tool, object, contact.cache);
  if (depth.valid) return {false, -depth.depth, depth.p_WA, depth.p_WB, depth.n_W};
  // No answer: the plane along the last normal that just touches the object.
  const Vector3 n_W = known ? contact.now.n_W : Vector3(closest.n_W);
  Facing facing{false, 0.0, tool.to_world(support(*tool.shape, -(tool.R_WS.transpose() * n_W)).p), object.p_WS, n_W};
  if (object.shape->is_bounded()) {
    facing.p_WB = object.to_world(support(*object.shape, object.R_WS.transpose() * n_W).p);
  }
  facing.gap = n_W.dot(facing.p_WA - facing.p_WB);
  return facing;
}

double ContactTracker::measure(const Pose& X_WP, double margin) noexcept {
  double least = 1e300;
  for (const NearContact& contact : contacts()) {
    if (contact.measured) least = std::min(least, contact.now.gap);
  }
  for (NearContact& contact : contacts()) {
    if (contact.measured || contact.room > std::max(least, 0.0) + margin || !spend()) continue;
    contact.now = face(contact, X_WP);
    contact.room = contact.now.gap;
    contact.measured = true;
    least = std::min(least, contact.now.gap);
  }
  return least;
}

bool ContactTracker::may_stand(const NearContact& contact, double way, double skin) const noexcept {
  const Facing &before = contact.now, &after = contact.trial;
  // Beyond this a change of normal within one step means that the step jumped over something.
  constexpr double kOtherSide = -0.2;
  if (before.gap < way && before.n_W.dot(after.n_W) < kOtherSide) return false;
  double least = std::min(0.25 * skin, before.gap);
  // Opposed walls that cannot both be kept off are shared as the linear model says.
  const bool squeezed = before.gap < 0.0 || contact.deepened > 0.0;
  if (squeezed && contact.predicted < least) least = contact.predicted - tolerance::kGuardSlack;
  return after.gap >= least - tolerance::kGuardRounding;
}

bool ContactTracker::examine(const Pose& X_WP, double way, double skin) noexcept {
  for (NearContact& contact : contacts()) contact.tried = false;
  for (NearContact& contact : contacts()) {
    if (!contact.measured && contact.room < way) ++skipped_;  // over budget: nothing is known of it
    if (!contact.measured || contact.now.gap - way > skin) continue;
    contact.trial = face(contact, X_WP);
    contact.tried = true;
    if (!may_stand(contact, way, skin)) return false;
  }
  return true;
}

void ContactTracker::accept(double way) noexcept {
  for (NearContact& contact : contacts()) {
    if (contact.tried) {
      contact.turned = (contact.trial.n_W - contact.now.n_W).norm();
      contact.now = contact.trial;
      contact.room = contact.now.gap;
    } else {
      contact.room = (contact.measured ? contact.now.gap : contact.room) - way;
      contact.measured = false;
    }
  }
}

std::span<const OverlayPoint> ContactTracker::points(const NearContact& contact, const Pose& X_WP,
                                                     double reach) noexcept {
  const PlacedShape tool(tool_shape(contact), X_WP), object(body_shape(contact), contact.X_WB);
  OverlayQuery query;
  query.tool = &tool;
  query.object = &object;
  query.p_WA = contact.now.p_WA;
  query.p_WB = contact.now.p_WB;
  query.n_W = contact.now.n_W;
  query.distance = contact.now.gap;
  query.margin = reach - contact.now.gap;
  query.hint_tool = contact.cache.hint_tool;
  query.hint_object = contact.cache.hint_object;
  const int count = overlay(query, workspace_, points_);
  const int kept = std::min(count, kMaxPointsOfPair);
  skipped_ += count - kept;
  return {points_.data(), static_cast<size_t>(kept)};
}

}  // namespace tegotae
