// SPDX-License-Identifier: Apache-2.0
// Rows of the proxy's problem from contacts and friction, and what the solved problem says of them.
#include <tegotae/math/rotation.hpp>
#include <tegotae/render/proxy_method.hpp>
#include <tegotae/render/tolerances.hpp>

#include <algorithm>

namespace tegotae {

void ProxyMethod::collect_rows(double reach) noexcept {
  const auto contacts = tracker_.contacts();
  find_pushing_normals();
  for (size_t i = 0; i < contacts.size(); ++i) {
    NearContact& contact = contacts[i];
    if (!contact.measured || contact.now.gap >= reach) continue;
    const Facing facing = facing_of_rows(contact);
    contact.n_row_W = facing.n_W;
    const auto points = tracker_.points(contact, facing, X_WP_, reach);
    // Every contact to come has room for its nearest point.
    const size_t room = rows_.capacity() - rows_.size() - (contacts.size() - i - 1);
    if (points.size() > room) {
      rows_.push_back({static_cast<int>(i), facing.p_WA, facing.gap});
      left_out_ += static_cast<int>(points.size()) - 1;
      continue;
    }
    for (const OverlayPoint& point : points) rows_.push_back({static_cast<int>(i), point.p_WA, point.gap});
  }
}

// The directions in which contacts pushed in the last solve, a few at most, so that the rows stay linear in contacts.
void ProxyMethod::find_pushing_normals() noexcept {
  pushing_count_ = 0;
  for (const NearContact& contact : tracker_.contacts()) {
    if (!contact.pushes || !contact.measured || !contact.now.separated) continue;
    if (is_pushing_direction(contact.now.n_W)) continue;
    if (pushing_count_ == kMostPushing) return;
    pushing_normals_[static_cast<size_t>(pushing_count_++)] = contact.now.n_W;
  }
}

bool ProxyMethod::is_pushing_direction(const Vector3& n_W) const noexcept {
  constexpr double kSameDirection = 0.999;  // cosine
  for (int i = 0; i < pushing_count_; ++i) {
    if (pushing_normals_[static_cast<size_t>(i)].dot(n_W) > kSameDirection) return true;
  }
  return false;
}

// Over a seam between flush pieces the nearest direction to the next one is along the surface, and the tool would stop
// at nothing. So a piece that does not push yet is faced as one that does, where that plane parts the two as well.
Facing ProxyMethod::facing_of_rows(NearContact& contact) noexcept {
  constexpr double kOtherDirection = 0.9;  // cosine
  if (contact.pushes || contact.now.by_plane || !contact.now.separated) return contact.now;
  for (int i = 0; i < pushing_count_; ++i) {
    const Vector3& n_W = pushing_normals_[static_cast<size_t>(i)];
    if (n_W.dot(contact.now.n_W) > kOtherDirection) continue;
    Facing along = tracker_.stand_in(contact, n_W, X_WP_);
    if (along.gap >= 0.25 * skin_) return along;
  }
  return contact.now;
}

// With `push_out` every point is asked to keep the skin; without, those of pairs that overlap are only asked to undo
// what the object's own motion did. So are those below a plane that stands in: the object may have no part there.
void ProxyMethod::fill_problem(const RenderInput& input, const Vector3& p_WCm, bool push_out) noexcept {
  const Matrix6 K = problem_.K();
  const Vector6 x_free = problem_.x_free();
  problem_.set_objective(K, x_free);
  // Far stretched, rows are stiffer: what their compliance gives way stays within a quarter of the skin.
  const double stretch = std::max(way_of(x_free), tolerance::kSettledStep);
  const double relative = std::min(tolerance::kRowCompliance, 0.25 * skin_ / stretch);
  const double compliance = relative / parameters_.coupling.stiffness;
  const auto contacts = tracker_.contacts();
  for (const RowSource& source : rows_) {
    const NearContact& contact = contacts[static_cast<size_t>(source.contact)];
    double target = skin_;
    if ((!push_out || contact.now.by_plane) && contact.now.gap < 0.0)
      target = std::min(skin_, source.gap + contact.deepened);
    Vector6 J;
    J << contact.n_row_W, (source.p_W - p_WCm).cross(contact.n_row_W);
    problem_.add_contact(J, target - source.gap, compliance);
  }
  add_friction(input, p_WCm);
}

void ProxyMethod::add_friction(const RenderInput& input, const Vector3& p_WCm) noexcept {
  blocks_.clear();
  const auto contacts = tracker_.contacts();
  for (size_t i = 0; i < contacts.size(); ++i) {
    NearContact& contact = contacts[i];
    if (!contact.bristle.is_loaded() || !contact.friction.rubs()) continue;
    if (contact.friction.static_coefficient > 0.0 &&
        problem_.add_friction(contact.bristle.block(contact.friction, X_WP_, contact.X_WB, p_WCm, contact.n_row_W))) {
      blocks_.push_back(static_cast<int>(i));
    }
    if (!(contact.friction.viscous > 0.0)) continue;
    const Vector3 moved_W = contact.bristle.centre(X_WP_) - contact.bristle.centre(X_WP_start_);
    if (problem_.add_friction(
            contact.bristle.drag(contact.friction, X_WP_, p_WCm, contact.n_row_W, moved_W, input.dt))) {
      blocks_.push_back(static_cast<int>(i));
    }
  }
}

bool ProxyMethod::is_inside() noexcept {
  const auto contacts = tracker_.contacts();
  return std::any_of(contacts.begin(), contacts.end(), [](const NearContact& contact) {
    return contact.measured && !contact.now.by_plane && contact.now.gap + contact.deepened < 0.0;
  });
}

// The least gap that the linear model sees for each contact after the step.
void ProxyMethod::predict(const Vector6& x) noexcept {
  const auto contacts = tracker_.contacts();
  for (NearContact& contact : contacts) contact.predicted = NearContact::kNoRows;
  for (size_t i = 0; i < std::min(rows_.size(), static_cast<size_t>(problem_.contact_count())); ++i) {
    double& predicted = contacts[static_cast<size_t>(rows_[i].contact)].predicted;
    predicted = std::min(predicted, rows_[i].gap + problem_.J(static_cast<int>(i)).dot(x));
  }
}

// Rows of a contact stand together and active rows ascend, so one pass over both serves all. Returns the greatest
// change of a friction limit, N.
double ProxyMethod::take_loads(const Pose& X_WP_solved) noexcept {
  double change = 0.0;
  size_t active = 0;
  const auto contacts = tracker_.contacts();
  for (size_t i = 0; i < contacts.size(); ++i) {
    NearContact& contact = contacts[i];
    const ContactLoad load = load_of(static_cast<int>(i), contact.n_row_W, active);
    contact.pushes = load.normal_force > 0.0;
    if (!contact.friction.rubs()) continue;
    const double before = contact.bristle.normal_force();
    change = std::max(change, contact.friction.static_coefficient * std::abs(load.normal_force - before));
    contact.bristle.load(load, X_WP_solved);
  }
  return change;
}

ContactLoad ProxyMethod::load_of(int contact, const Vector3& n_W, size_t& active) noexcept {
  ContactLoad load;
  if (rows_.empty()) return load;
  const size_t first = active;
  for (; active < solution_.active_rows.size(); ++active) {
    const auto row = static_cast<size_t>(solution_.active_rows[active]);
    if (rows_[row].contact != contact) break;
    load.normal_force += solution_.multipliers[row];
    load.centre_W += solution_.multipliers[row] * rows_[row].p_W;
  }
  if (!(load.normal_force > 0.0)) return load;
  load.centre_W /= load.normal_force;
  const Vector3 x_W = any_perpendicular(n_W), y_W = n_W.cross(x_W);
  patch_.clear();
  for (size_t k = first; k < active && patch_.size() < patch_.capacity(); ++k) {
    const Vector3 r = rows_[static_cast<size_t>(solution_.active_rows[k])].p_W - load.centre_W;
    patch_.emplace_back(x_W.dot(r), y_W.dot(r));
  }
  load.mean_distance = mean_distance(patch_, Vector2::Zero());
  return load;
}

void ProxyMethod::push_bodies(RenderOutput& output) noexcept {
  if (rows_.empty()) return;
  const auto contacts = tracker_.contacts();
  for (const int active : solution_.active_rows) {
    const RowSource& source = rows_[static_cast<size_t>(active)];
    const NearContact& contact = contacts[static_cast<size_t>(source.contact)];
    const Vector3 n_W = problem_.J(active).head<3>();
    output.bodies.add(contact.moving_index, contact.p_WC, source.p_W,
                      -solution_.multipliers[static_cast<size_t>(active)] * n_W, Vector3::Zero());
  }
  for (size_t f = 0; f < blocks_.size(); ++f) {
    const NearContact& contact = contacts[static_cast<size_t>(blocks_[f])];
    if (!contact.bristle.is_loaded()) continue;
    const FrictionBlock<6>& block = problem_.friction(static_cast<int>(f));
    const Vector3& lambda = solution_.friction_forces[f];
    const Vector3 force = block.J.leftCols<3>().transpose() * lambda;
    const Vector3 torque = lambda.z() * block.J.row(2).tail<3>().transpose();
    output.bodies.add(contact.moving_index, contact.p_WC, contact.bristle.centre(X_WP_), -force, -torque);
  }
}

}  // namespace tegotae
