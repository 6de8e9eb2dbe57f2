// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/contact_tracker.hpp>

#include <tegotae/render/tolerances.hpp>

#include <algorithm>
#include <cmath>

namespace tegotae {
namespace {

constexpr int kMaxPointsOfPair = 1024;

int most_vertices(const SceneGeometry& geometry) {
  size_t most = 8;
  const auto include = [&most](const std::vector<Shape>& pieces) {
    for (const Shape& piece : pieces) most = std::max(most, piece.polytope ? piece.polytope->vertices.size() : 0);
  };
  include(geometry.tool.pieces);
  for (const Body& body : geometry.bodies) include(body.pieces);
  return static_cast<int>(most);
}

// What is known of the distance: the gap where it was measured, else the room.
double known_room(const NearContact& contact) noexcept {
  return contact.measured && !contact.now.by_plane ? contact.now.gap : contact.room;
}

}  // namespace

ContactTracker::ContactTracker(const SceneGeometry& geometry, const FrictionSettings& friction)
    : geometry_(geometry),
      friction_(friction),
      half_space_(make_plane()),
      pairs_(geometry),
      contacts_(kMaxNearPieces),
      workspace_(most_vertices(geometry)),
      points_(kMaxPointsOfPair) {
  queue_.reserve(kMaxNearPieces);
  for (const Shape& piece : geometry.tool.pieces) {
    tool_radius_ = std::max(tool_radius_, radius_about(piece, geometry.tool.mass.centre_of_mass));
  }
}

void ContactTracker::reset() noexcept {
  count_ = 0;
  pairs_.reset();
}

const Shape& ContactTracker::tool_shape(const NearContact& contact) const noexcept {
  return geometry_.tool.pieces[static_cast<size_t>(contact.tool_piece)];
}

const Shape& ContactTracker::body_shape(const NearContact& contact) const noexcept {
  return geometry_.bodies[static_cast<size_t>(contact.body)].pieces[static_cast<size_t>(contact.body_piece)];
}

PlacedShape ContactTracker::placed_tool(const NearContact& contact, const Pose& X_WP) const noexcept {
  return {tool_shape(contact), X_WP};
}

PlacedShape ContactTracker::placed_object(const NearContact& contact) const noexcept {
  return {body_shape(contact), contact.X_WB};
}

void ContactTracker::take(const IntermediateRepresentation& model, const Pose& X_WP) noexcept {
  skipped_ = measured_ = trials_ = 0;
  if (pairs_.take(model, X_WP)) rename_contacts();
  leave_unserved();
  follow_objects(X_WP);
}

// A contact whose pair physics no longer names is forgotten.
void ContactTracker::rename_contacts() noexcept {
  int kept = 0;
  for (NearContact& contact : contacts()) {
    contact.pair = pairs_.renamed(contact.pair);
    if (contact.pair < 0) continue;
    pairs_[contact.pair].contact = kept;
    contacts_[static_cast<size_t>(kept++)] = contact;
  }
  count_ = kept;
}

void ContactTracker::leave_unserved() noexcept {
  int kept = 0;
  for (NearContact& contact : contacts()) {
    if (!contact.served && !contact.measured && !contact.bristle.is_loaded()) {
      pairs_.put_back(contact.pair, contact.room, contact.now.n_W, contact.cache);
      continue;
    }
    contact.served = contact.skipped = false;
    // A plane stands in for one tick at most.
    if (contact.now.by_plane) contact.measured = false;
    pairs_[contact.pair].contact = kept;
    NearContact& place = contacts_[static_cast<size_t>(kept++)];
    if (&place != &contact) place = contact;
  }
  count_ = kept;
}

void ContactTracker::follow_objects(const Pose& X_WP) noexcept {
  for (NearContact& contact : contacts()) {
    contact.deepened = 0.0;
    const int near_body = pairs_[contact.pair].near_body;
    if (near_body < 0) continue;
    const TrackedBody& body = pairs_.moving(near_body);
    contact.p_WC = body.p_WC;
    const double most = body.linear + body.angular * radius_about(body_shape(contact), body.p_BC);
    if (most == 0.0) continue;
    contact.room = known_room(contact) - most;
    contact.deepened = most;
    contact.measured = false;
    contact.bristle.follow_object(contact.X_WB, body.X_WB, X_WP, contact.now.n_W);
    contact.now.n_W = body.X_WB.q * (contact.X_WB.q.conjugate() * contact.now.n_W);
    contact.X_WB = body.X_WB;
  }
}

// A far pair becomes a contact.
void ContactTracker::adopt_friction(const ContactTracker& other) noexcept {
  friction_ = other.friction_;
  for (NearContact& contact : contacts()) {
    contact.friction = friction_law(scene_friction(tool_shape(contact), body_shape(contact)), friction_);
  }
}

int ContactTracker::enter(int pair) noexcept {
  const TrackedPair& tracked = pairs_[pair];
  NearContact& contact = contacts_[static_cast<size_t>(count_)];
  contact = {};
  contact.tool_piece = tracked.tool_piece;
  contact.body = tracked.body;
  contact.body_piece = tracked.body_piece;
  contact.moving_index = geometry_.bodies[static_cast<size_t>(tracked.body)].moving_index;
  contact.pair = pair;
  contact.X_WB = pairs_.pose_of(tracked);
  if (tracked.near_body >= 0) contact.p_WC = pairs_.moving(tracked.near_body).p_WC;
  contact.now.n_W = contact.X_WB.q * tracked.n_B;
  contact.cache = tracked.cache;
  contact.friction = friction_law(scene_friction(tool_shape(contact), body_shape(contact)), friction_);
  contact.room = pairs_.take_out(pair, count_);
  return count_++;
}

// The plane along the last normal stands in for a measurement.
void ContactTracker::fall_back(NearContact& contact, const Pose& X_WP, Facing& facing) noexcept {
  if (!contact.skipped) ++skipped_;
  contact.skipped = true;
  facing = facing_along(placed_tool(contact, X_WP), placed_object(contact), contact.now.n_W, contact.cache);
}

void ContactTracker::serve(NearContact& contact, const Pose& X_WP) noexcept {
  if (measured_ < tolerance::kDistanceBudget) {
    ++measured_;
    contact.now = measured_facing(placed_tool(contact, X_WP), placed_object(contact), contact.now.n_W, contact.cache);
    contact.room = contact.now.gap;
  } else {
    fall_back(contact, X_WP, contact.now);
    contact.room = std::max(contact.room, contact.now.gap);
  }
  contact.measured = contact.served = true;
}

// Without any measured contact: the pair with least room is the first to be asked.
void ContactTracker::enter_nearest() noexcept {
  double room = NearPairs::kFar;
  for (const NearContact& contact : contacts()) room = std::min(room, contact.room);
  const int pair = pairs_.nearest_below(room);
  if (pair >= 0) enter(pair);
}

// Contacts not yet measured whose room is at most `limit`; nearest first where the budget may not suffice for all.
void ContactTracker::queue_unmeasured(double limit) noexcept {
  queue_.clear();
  for (int i = 0; i < count_; ++i) {
    const NearContact& contact = contacts_[static_cast<size_t>(i)];
    if (!contact.measured && contact.room <= limit) queue_.emplace_back(contact.room, i);
  }
  if (measured_ + static_cast<int>(queue_.size()) > tolerance::kDistanceBudget) std::sort(queue_.begin(), queue_.end());
}

double ContactTracker::measure(const Pose& X_WP, double margin) noexcept {
  double least = NearPairs::kFar;
  for (const NearContact& contact : contacts()) {
    if (contact.measured) least = std::min(least, contact.now.gap);
  }
  if (least == NearPairs::kFar) {
    enter_nearest();
    const auto nearer = [](const NearContact& a, const NearContact& b) { return a.room < b.room; };
    const auto nearest = std::min_element(contacts().begin(), contacts().end(), nearer);
    if (nearest == contacts().end()) return least;
    serve(*nearest, X_WP);
    least = nearest->now.gap;
  }
  pairs_.visit_within(std::max(least, 0.0) + margin, [this](int pair) { enter(pair); });
  queue_unmeasured(std::max(least, 0.0) + margin);
  for (const auto& [room, i] : queue_) {
    if (room > std::max(least, 0.0) + margin) continue;
    NearContact& contact = contacts_[static_cast<size_t>(i)];
    serve(contact, X_WP);
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
    if (!contact.measured || contact.now.gap - way > skin) continue;
    if (!contact.now.by_plane && trials_ < tolerance::kTrialBudget) {
      ++trials_;
      contact.trial =
          measured_facing(placed_tool(contact, X_WP), placed_object(contact), contact.now.n_W, contact.cache);
    } else {
      fall_back(contact, X_WP, contact.trial);
    }
    contact.tried = true;
    if (!may_stand(contact, way, skin)) return false;
  }
  return true;
}

void ContactTracker::accept(double way) noexcept {
  pairs_.travel(way);
  for (NearContact& contact : contacts()) {
    const double left = known_room(contact) - way;
    contact.measured = contact.tried && !contact.trial.by_plane;
    contact.room = left;
    if (!contact.tried) continue;
    contact.turned = (contact.trial.n_W - contact.now.n_W).norm();
    contact.now = contact.trial;
    contact.room = contact.now.by_plane ? std::max(left, contact.now.gap) : contact.now.gap;
  }
}

std::span<const OverlayPoint> ContactTracker::points(const NearContact& contact, const Facing& facing, const Pose& X_WP,
                                                     double reach) noexcept {
  const PlacedShape tool = placed_tool(contact, X_WP);
  PlacedShape object = placed_object(contact);
  if (contact.now.by_plane) {
    object = {half_space_, {facing.p_WB, Quaternion::FromTwoVectors(Vector3::UnitZ(), facing.n_W)}};
  }
  OverlayQuery query;
  query.tool = &tool;
  query.object = &object;
  query.p_WA = facing.p_WA;
  query.p_WB = facing.p_WB;
  query.n_W = facing.n_W;
  query.distance = facing.gap;
  query.margin = reach - facing.gap;
  query.closest_pair = contact.now.by_plane || !facing.by_plane;
  query.hint_tool = contact.cache.hint_tool;
  query.hint_object = contact.cache.hint_object;
  const int count = overlay(query, workspace_, points_);
  const int kept = std::min(count, kMaxPointsOfPair);
  skipped_ += count - kept;
  return {points_.data(), static_cast<size_t>(kept)};
}

}  // namespace tegotae
