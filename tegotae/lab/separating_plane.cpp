// SPDX-License-Identifier: Apache-2.0
#include <tegotae/lab/separating_plane.hpp>

#include <tegotae/lab/quadratic_program.hpp>
#include <tegotae/math/rotation.hpp>

#include <algorithm>
#include <cmath>

namespace tegotae {
namespace {

constexpr int kTurns = 60;
constexpr double kFirstTurn = 0.5;     // rad that one program may turn the plane
constexpr double kLeastTurn = 1e-7;    // rad
constexpr double kCloseEnough = 1e-6;  // of the gap, relative: the step that follows turns the plane anyway
constexpr double kProximity = 1e-7;    // makes the program's solution unique

// The tangential turn t, offset d and gap g of the linear program: unknowns t1, t2, d, g, in units of `length`.
InequalityGroup rows_of(const ConvexCore& core, const Vector3& n, const Vector3& centre, double length, double side) {
  const auto count = static_cast<Eigen::Index>(core.vertices.size());
  const auto tangents = tangents_of(n);
  InequalityGroup rows{Eigen::MatrixXd(count, 4), Eigen::VectorXd(count), {0, 1, 2, 3}};
  for (Eigen::Index i = 0; i < count; ++i) {
    const Vector3 v = (core.vertices[static_cast<size_t>(i)] - centre) / length;
    rows.A.row(i) << side * (tangents.transpose() * v).transpose(), -side, side > 0.0 ? -1.0 : 0.0;
    rows.b[i] = -side * n.dot(v);
  }
  return rows;
}

Vector3 turned(const ConvexCore& above, const ConvexCore& below, const Vector3& n, double most) {
  const Vector3 centre = above.vertices.front();
  const double length = std::max((above.box.upper - above.box.lower).norm(), 1e-6);
  QuadraticProgram program;
  program.H = kProximity * Eigen::MatrixXd::Identity(4, 4);
  program.g = Eigen::Vector4d(0.0, 0.0, 0.0, -1.0);
  program.groups = {rows_of(above, n, centre, length, 1.0), rows_of(below, n, centre, length, -1.0)};
  InequalityGroup bounds{Eigen::MatrixXd(4, 2), Eigen::VectorXd::Constant(4, -1.0), {0, 1}};
  bounds.A << 1, 0, -1, 0, 0, 1, 0, -1;
  bounds.A /= most;
  program.groups.push_back(bounds);
  const QuadraticSolution solution = solve(program);
  return (n + tangents_of(n) * solution.y.head<2>()).normalized();
}

// Turns `n` as long as that widens the gap.
Vector3 widened(const ConvexCore& above, const ConvexCore& below, Vector3 n) {
  double gap = gap_along(above, below, n), most = kFirstTurn;
  for (int turn = 0; turn < kTurns && most > kLeastTurn; ++turn) {
    const Vector3 next = turned(above, below, n, most);
    const double next_gap = gap_along(above, below, next);
    const double gain = next_gap - gap;
    if (gain > 0.0) {
      n = next;
      gap = next_gap;
      if (gain < kCloseEnough * std::abs(gap)) break;
    } else {
      most *= 0.25;
    }
  }
  return n;
}

Vector3 best_face_normal(const ConvexCore& above, const ConvexCore& below, Vector3 best) {
  double widest = gap_along(above, below, best);
  const auto consider = [&](const Vector3& n) {
    const double gap = gap_along(above, below, n);
    if (gap > widest) {
      widest = gap;
      best = n;
    }
  };
  for (const Vector3& n : below.face_normals) consider(n);
  for (const Vector3& n : above.face_normals) consider(-n);
  return best;
}

}  // namespace

Eigen::Matrix<double, 3, 2> tangents_of(const Vector3& n) noexcept {
  Eigen::Matrix<double, 3, 2> tangents;
  tangents.col(0) = any_perpendicular(n);
  tangents.col(1) = n.cross(tangents.col(0));
  return tangents;
}

Vector3 widest_gap_normal(const ConvexCore& above, const ConvexCore& below) {
  if (below.is_half_space) return below.face_normals.front();
  const Vector3 between = 0.5 * (above.box.lower + above.box.upper - below.box.lower - below.box.upper);
  const Vector3 start = between.norm() > 0.0 ? Vector3(between.normalized()) : Vector3(Vector3::UnitZ());
  Vector3 n = widened(above, below, start);
  if (gap_along(above, below, n) > 0.0) return n;
  return widened(above, below, best_face_normal(above, below, n));
}

}  // namespace tegotae
