// SPDX-License-Identifier: Apache-2.0
#include <tegotae/model/representation_interpolator.hpp>

#include <tegotae/math/rotation.hpp>

#include <algorithm>

namespace tegotae {
namespace {

bool same_pieces(const ContactPlane& a, const ContactPlane& b) noexcept {
  return a.tool_piece == b.tool_piece && a.body == b.body && a.body_piece == b.body_piece;
}

Vector3 between(const Vector3& a, const Vector3& b, double fraction) noexcept { return a + fraction * (b - a); }

// Copies what is in use: the arrays are mostly empty.
void copy_used(const IntermediateRepresentation& from, IntermediateRepresentation& to) noexcept {
  to.sequence = from.sequence;
  to.time = from.time;
  to.period = from.period;
  to.near_object_count = from.near_object_count;
  to.plane_count = from.plane_count;
  to.point_count = from.point_count;
  to.dropped_planes = from.dropped_planes;
  to.dropped_points = from.dropped_points;
  std::copy_n(from.planes.begin(), from.plane_count, to.planes.begin());
  std::copy_n(from.points.begin(), from.point_count, to.points.begin());
  to.pair_count = from.pair_count;
  to.body_count = from.body_count;
  to.dropped_pairs = from.dropped_pairs;
  std::copy_n(from.pairs.begin(), from.pair_count, to.pairs.begin());
  std::copy_n(from.bodies.begin(), from.body_count, to.bodies.begin());
}

// Where a body was `duration` (s) before, if it moved as it does now.
NearBody earlier(const NearBody& body, double duration) noexcept {
  const Twist V_WB = body.V_WB;
  const Pose X_WB = body.X_WB;
  const Vector3 p_WC = body.p_WC;
  NearBody before = body;
  const Quaternion turn = rotation_from_vector(-duration * V_WB.angular);
  const Vector3 p_WC_before = p_WC - duration * V_WB.linear;
  before.X_WB = Pose{p_WC_before + turn * (X_WB.p - p_WC), (turn * X_WB.q).normalized()};
  before.p_WC = p_WC_before;
  return before;
}

}  // namespace

void RepresentationInterpolator::accept(const IntermediateRepresentation& model) noexcept {
  copy_used(newest_, previous_);
  copy_used(model, newest_);
  copy_used(model, between_);
  match();
  match_bodies();
}

void RepresentationInterpolator::match() noexcept {
  std::fill_n(point_partner_.begin(), newest_.point_count, -1);
  for (int i = 0; i < newest_.plane_count; ++i) {
    const ContactPlane& plane = newest_.planes[static_cast<size_t>(i)];
    const auto planes = previous_.used_planes();
    const auto found = std::find_if(planes.begin(), planes.end(),
                                    [&plane](const ContactPlane& other) { return same_pieces(plane, other); });
    // A plane that turned by more than a right angle changed sides: between the two there is no plane to speak of.
    const bool partner = found != planes.end() && found->n_W.vector().dot(plane.n_W.vector()) > 0.0;
    plane_partner_[static_cast<size_t>(i)] = partner ? static_cast<int>(found - planes.begin()) : -1;
    if (partner) match_points(plane, *found);
  }
}

void RepresentationInterpolator::match_bodies() noexcept {
  for (int i = 0; i < newest_.body_count; ++i) {
    const NearBody& body = newest_.bodies[static_cast<size_t>(i)];
    NearBody& before = body_before_[static_cast<size_t>(i)];
    before = earlier(body, newest_.period);
    for (int k = 0; k < previous_.body_count; ++k) {
      const NearBody& candidate = previous_.bodies[static_cast<size_t>(k)];
      if (candidate.moving_index == body.moving_index) before = candidate;
    }
  }
}

// The centre of mass goes straight, the body turns about it.
void RepresentationInterpolator::move_bodies(double fraction) noexcept {
  for (int i = 0; i < newest_.body_count; ++i) {
    const NearBody& a = body_before_[static_cast<size_t>(i)];
    const NearBody& b = newest_.bodies[static_cast<size_t>(i)];
    NearBody& body = between_.bodies[static_cast<size_t>(i)];
    const Pose X_WB = b.X_WB;
    const Vector3 p_WC = between(a.p_WC, b.p_WC, fraction);
    const Vector3 p_CB = X_WB.q.conjugate() * (X_WB.p - b.p_WC.vector());
    const Quaternion q = a.X_WB.pose().q.slerp(fraction, X_WB.q).normalized();
    body.p_WC = p_WC;
    body.X_WB = Pose{p_WC + q * p_CB, q};
  }
}

// Both lists are in order of their features.
void RepresentationInterpolator::match_points(const ContactPlane& plane, const ContactPlane& before) noexcept {
  int old = before.first_point;
  const int old_end = before.first_point + before.point_count;
  for (int i = plane.first_point; i < plane.first_point + plane.point_count; ++i) {
    const std::uint64_t feature = newest_.points[static_cast<size_t>(i)].feature;
    while (old < old_end && previous_.points[static_cast<size_t>(old)].feature < feature) ++old;
    if (old < old_end && previous_.points[static_cast<size_t>(old)].feature == feature) {
      point_partner_[static_cast<size_t>(i)] = old++;
    }
  }
}

const IntermediateRepresentation& RepresentationInterpolator::at(double fraction) noexcept {
  const double s = std::clamp(fraction, 0.0, 1.0);
  for (int i = 0; i < newest_.plane_count; ++i) {
    const int partner = plane_partner_[static_cast<size_t>(i)];
    if (partner < 0) continue;
    const ContactPlane& a = previous_.planes[static_cast<size_t>(partner)];
    const ContactPlane& b = newest_.planes[static_cast<size_t>(i)];
    ContactPlane& plane = between_.planes[static_cast<size_t>(i)];
    plane.n_W = between(a.n_W, b.n_W, s).normalized();
    plane.p_W = between(a.p_W, b.p_W, s);
    plane.p_WC = between(a.p_WC, b.p_WC, s);
  }
  for (int i = 0; i < newest_.point_count; ++i) {
    const int partner = point_partner_[static_cast<size_t>(i)];
    if (partner < 0) continue;
    between_.points[static_cast<size_t>(i)].p_T =
        between(previous_.points[static_cast<size_t>(partner)].p_T, newest_.points[static_cast<size_t>(i)].p_T, s);
  }
  move_bodies(s);
  return between_;
}

}  // namespace tegotae
