// SPDX-License-Identifier: Apache-2.0
#include <tegotae/render/bristle.hpp>

#include <tegotae/math/rotation.hpp>
#include <tegotae/render/force_ellipsoid.hpp>

#include <limits>

namespace tegotae {
namespace {

// m. Patches of less are points: their torsional limit is below what can be felt by orders of magnitude.
constexpr double kPointPatch = 1e-7;

struct TangentPlane {
  Vector3 x, y, n;
  explicit TangentPlane(const Vector3& normal) noexcept : x(any_perpendicular(normal)), y(normal.cross(x)), n(normal) {}
};

FrictionJacobian<6> rows_at(const TangentPlane& plane, const Vector3& r) noexcept {
  FrictionJacobian<6> J;
  J.row(0) << plane.x.transpose(), r.cross(plane.x).transpose();
  J.row(1) << plane.y.transpose(), r.cross(plane.y).transpose();
  J.row(2) << 0.0, 0.0, 0.0, plane.n.transpose();
  return J;
}

}  // namespace

Vector3 Bristle::radius(const FrictionLaw& law) const noexcept {
  const double limit = (slipping_ ? law.kinetic_coefficient : law.static_coefficient) * normal_force_;
  return {limit, limit, mean_distance_ > kPointPatch ? limit * mean_distance_ : 0.0};
}

// Bristles spread over the patch: against twist they act at its mean distance.
Vector3 Bristle::compliance(const FrictionLaw& law) const noexcept {
  const double arm = std::max(mean_distance_, kPointPatch);
  return {law.compliance, law.compliance, law.compliance / (arm * arm)};
}

FrictionBlock<6> Bristle::block(const FrictionLaw& law, const Pose& X_WT, const Pose& X_WB, const Vector3& p_WCm,
                                const Vector3& n_W) const noexcept {
  const TangentPlane plane(n_W);
  const Vector3 stretch_W = X_WB.q * stretch_B_;
  FrictionBlock<6> block;
  block.J = rows_at(plane, centre(X_WT) - p_WCm);
  block.b = -Vector3(plane.x.dot(stretch_W), plane.y.dot(stretch_W), twist_);
  block.compliance = compliance(law);
  block.radius = radius(law);
  return block;
}

FrictionBlock<6> Bristle::drag(const FrictionLaw& law, const Pose& X_WT, const Vector3& p_WCm, const Vector3& n_W,
                               const Vector3& moved_W, double dt) const noexcept {
  constexpr double kInfinite = std::numeric_limits<double>::infinity();
  const TangentPlane plane(n_W);
  FrictionBlock<6> block;
  block.J = rows_at(plane, centre(X_WT) - p_WCm);
  block.b = -Vector3(plane.x.dot(moved_W), plane.y.dot(moved_W), 0.0);
  block.compliance = {dt / law.viscous, dt / law.viscous, 1.0};
  block.radius = {kInfinite, kInfinite, 0.0};
  return block;
}

void Bristle::follow_tool(const FrictionLaw& law, const Pose& from, const Pose& to, const Pose& X_WB,
                          const Vector3& n_W) noexcept {
  if (!is_loaded()) return;
  const TangentPlane plane(n_W);
  const Vector6 way = displacement(from, to, centre_T_);
  const Vector3 stretch_W = X_WB.q * stretch_B_ + way.head<3>();
  const Vector3 stretch(plane.x.dot(stretch_W), plane.y.dot(stretch_W), twist_ + n_W.dot(way.tail<3>()));
  const Vector3 c = compliance(law);
  const EllipsoidForce held = ellipsoid_force(-stretch, c, radius(law));
  slipping_ = held.on_boundary;
  const Vector3 kept = -c.cwiseProduct(held.force);
  stretch_B_ = X_WB.q.conjugate() * (kept.x() * plane.x + kept.y() * plane.y);
  twist_ = kept.z();
}

void Bristle::follow_object(const Pose& from, const Pose& to, const Pose& X_WT, const Vector3& n_W) noexcept {
  if (!is_loaded()) return;
  const Vector6 way = displacement(from, to, from.inverse() * centre(X_WT));
  // The stretch so far turned with the object.
  stretch_B_ -= to.q.conjugate() * Vector3(way.head<3>() - n_W.dot(way.head<3>()) * n_W);
  twist_ -= n_W.dot(way.tail<3>());
}

void Bristle::load(const ContactLoad& load, const Pose& X_WT) noexcept {
  if (!(load.normal_force > 0.0)) {
    *this = {};
    return;
  }
  const bool fresh = !is_loaded();
  normal_force_ = fresh ? load.normal_force : 0.5 * (normal_force_ + load.normal_force);
  mean_distance_ = fresh ? load.mean_distance : 0.5 * (mean_distance_ + load.mean_distance);
  centre_T_ = X_WT.inverse() * load.centre_W;
}

}  // namespace tegotae
