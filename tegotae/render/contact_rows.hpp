// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/render/constraint_solver.hpp>
#include <tegotae/render/contact_view.hpp>
#include <tegotae/render/coupling.hpp>
#include <tegotae/render/render_types.hpp>

#include <array>

// What the methods that render from planes and contact points have in common. Nothing here allocates or throws.
namespace tegotae {

/// A contact point against its plane.
struct PointOnPlane {
  int plane = 0;  ///< index in the model
  int point = 0;
  Vector3 n_W;         ///< of the plane
  Vector3 p_WC;        ///< the contact point, m
  double depth = 0.0;  ///< below the plane, m; negative while apart
};

/// Calls `visit(const PointOnPlane&)` for every contact point of the model, the tool being at `X_WT`.
template <class Visit>
void visit_contact_points(const IntermediateRepresentation& model, const Pose& X_WT, const Visit& visit) noexcept {
  const Matrix3 R_WT = X_WT.rotation();
  PointOnPlane contact;
  for (contact.plane = 0; contact.plane < model.plane_count; ++contact.plane) {
    const ContactPlane& plane = model.planes[static_cast<std::size_t>(contact.plane)];
    contact.n_W = plane.n_W;
    const Vector3 p_W = plane.p_W;
    const int end = plane.first_point + plane.point_count;
    for (contact.point = plane.first_point; contact.point < end; ++contact.point) {
      const ContactPoint& point = model.points[static_cast<std::size_t>(contact.point)];
      contact.p_WC = R_WT * point.p_T.vector() + X_WT.p - point.radius * contact.n_W;
      contact.depth = -contact.n_W.dot(contact.p_WC - p_W);
      visit(contact);
    }
  }
}

/// Clears the output: no wrench, the tool where the hand holds it. False, with the status, where there is nothing to
/// render from: no model yet, or a pose that is not finite.
bool begin_render(const RenderInput& input, RenderOutput& output) noexcept;

/// Greatest depth of a contact point, m; 0 where none is below its plane.
double deepest_penetration(const IntermediateRepresentation& model, const Pose& X_WT) noexcept;

/// J = [n; (p - centre) x n]: J d is the way along n of the contact point in the tool's small displacement d about
/// `centre_W`.
Vector6 normal_row(const PointOnPlane& contact, const Vector3& centre_W) noexcept;

/// Compliance (m/N) of a row: `kRowCompliance` of the coupling's own at this point, (1 + (r x n)^2 / l^2) / k.
double row_compliance(const Coupling& coupling, const Vector6& J) noexcept;

/// Adds the model's planes to the view, and every contact point of the tool at `X_WT` with the force (N) that
/// `force_of(const PointOnPlane&)` says.
template <class ForceOf>
void view_contact_points(const IntermediateRepresentation& model, const Pose& X_WT, const ForceOf& force_of,
                         ContactView& view) noexcept {
  for (const ContactPlane& plane : model.used_planes()) {
    view.add(ViewedPlane{plane.p_W, plane.n_W, plane.distance, plane.tool_piece, plane.body, plane.body_piece});
  }
  visit_contact_points(model, X_WT, [&](const PointOnPlane& contact) {
    view.add(ViewedPoint{contact.p_WC, -contact.depth, force_of(contact)});
  });
}

RenderStatus status_of(ConstraintStatus status) noexcept;

/// The rows of a problem that stand for contact points, and what they push.
class ContactRows {
 public:
  void clear() noexcept { count_ = 0; }
  int count() const noexcept { return count_; }

  /// Appends J x >= b with compliance c to the problem as the row of `contact`. The problem's rows must be these only.
  void add(const PointOnPlane& contact, const Vector6& J, double b, double c, ConstraintProblem<6>& problem) noexcept;

  /// Greatest violation that is left of a row at the solution, m; 0 where all are kept.
  double greatest_violation(const ConstraintProblem<6>& problem, const ConstraintSolution<6>& solution) const noexcept;

  /// Gives the bodies the opposite of what the active rows push the tool with, at the contact points of the tool at
  /// `X_WT`.
  void push_bodies(const IntermediateRepresentation& model, const Pose& X_WT, const ConstraintSolution<6>& solution,
                   BodyWrenches& bodies) const noexcept;

  /// Adds the model's planes and points to the view, the tool at `X_WT`, with what each row pushes.
  void view(const IntermediateRepresentation& model, const Pose& X_WT, const ConstraintSolution<6>& solution,
            ContactView& view) const noexcept;

 private:
  struct Source {
    int plane;
    int point;
  };

  std::array<Source, kMaxContactPoints> sources_{};
  int count_ = 0;
};

}  // namespace tegotae
