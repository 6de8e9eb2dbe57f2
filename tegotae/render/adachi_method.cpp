// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/adachi_method.hpp>

#include <algorithm>
#include <limits>

namespace tegotae {
namespace {

double depth_of(const IntermediateRepresentation& model, int plane_index, int point_index, const Pose& X_WT) noexcept {
  const ContactPlane& plane = model.planes[static_cast<std::size_t>(plane_index)];
  const Vector3 p_WC = X_WT * model.points[static_cast<std::size_t>(point_index)].p_T.vector();
  return -plane.n_W.vector().dot(p_WC - plane.p_W.vector());
}

}  // namespace

void AdachiMethod::reset() noexcept {
  sequence_ = 0;
  plane_ = point_ = -1;
  penetration_before_ = 0.0;
}

void AdachiMethod::render(const RenderInput& input, RenderOutput& output) noexcept {
  if (!begin_render(input, output)) return;
  const IntermediateRepresentation& model = input.model;
  output.deepest = deepest_penetration(model, input.X_WT);
  if (model.sequence != sequence_) choose(model, input.X_WT);
  if (plane_ < 0) return;

  output.constraint_count = 1;
  const ContactPlane& plane = model.planes[static_cast<std::size_t>(plane_)];
  const double penetration = std::max(0.0, depth_of(model, plane_, point_, input.X_WT));
  const double rate = (penetration - penetration_before_) / input.dt;
  const double push = std::max(0.0, coupling_.stiffness * penetration + coupling_.damping * rate);
  const Wrench wrench{push * plane.n_W.vector(), Vector3::Zero()};
  if (!wrench.is_finite()) {
    output.status = RenderStatus::kInvalidInput;
    return;
  }
  penetration_before_ = penetration;
  if (!(penetration > 0.0 && push > 0.0)) return;
  output.wrench = wrench;
  output.active_count = 1;
  // The line of action of a force without torque about the centre of mass goes through it.
  output.bodies.add(plane, input.X_WT * p_TCm_, -wrench.force);
}

void AdachiMethod::view(const RenderInput& input, const RenderOutput& output, ContactView& view) const noexcept {
  const auto force_of = [&](const PointOnPlane& contact) {
    const bool is_chosen = contact.plane == plane_ && contact.point == point_;
    return is_chosen && output.active_count > 0 ? output.wrench.force.norm() : 0.0;
  };
  view_contact_points(input.model, input.X_WT, force_of, view);
}

void AdachiMethod::choose(const IntermediateRepresentation& model, const Pose& X_WT) noexcept {
  sequence_ = model.sequence;
  plane_ = point_ = -1;
  double nearest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < model.plane_count; ++i) {
    const ContactPlane& plane = model.planes[static_cast<std::size_t>(i)];
    if (plane.point_count == 0 || !(plane.distance < nearest)) continue;
    nearest = plane.distance;
    plane_ = i;
  }
  if (plane_ < 0) return;
  const ContactPlane& plane = model.planes[static_cast<std::size_t>(plane_)];
  double deepest = -std::numeric_limits<double>::infinity();
  point_ = plane.first_point;
  for (int j = plane.first_point; j < plane.first_point + plane.point_count; ++j) {
    const double depth = depth_of(model, plane_, j, X_WT);
    if (!(depth > deepest)) continue;
    deepest = depth;
    point_ = j;
  }
  // Another point has another depth: no speed for the damper.
  penetration_before_ = std::max(0.0, deepest);
}

}  // namespace tegotae
