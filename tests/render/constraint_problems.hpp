// SPDX-License-Identifier: Apache-2.0
#pragma once

// Problems that several tests of the constraint solver share.

#include <tegotae/render/constraint_problem.hpp>

#include <random>

namespace tegotae::test {

inline constexpr double kStiffness = 9000.0;              // N/m, the paper's
inline constexpr double kMetricLength = 0.08;             // m
inline constexpr double kCompliance = 1e-5 / kStiffness;  // m/N, the usual share of the coupling's

inline Matrix6 tool_metric(double k = kStiffness, double length = kMetricLength) {
  Vector6 diagonal;
  diagonal << k, k, k, k * length * length, k * length * length, k * length * length;
  return diagonal.asDiagonal();
}

/// Row that keeps the tool point at `r` (m, from the centre of mass) from moving against `normal`.
inline Vector6 contact_row(const Vector3& normal, const Vector3& r) {
  Vector6 J;
  J << normal, r.cross(normal);
  return J;
}

class RandomProblems {
 public:
  explicit RandomProblems(unsigned seed) : engine_(seed) {}

  double uniform(double low, double high) { return std::uniform_real_distribution<double>(low, high)(engine_); }
  double normal() { return std::normal_distribution<double>()(engine_); }
  Vector3 direction() { return Vector3(normal(), normal(), normal()).normalized(); }
  Vector3 point() { return Vector3(uniform(-0.1, 0.1), uniform(-0.1, 0.1), uniform(-0.1, 0.1)); }

  /// Rows that are all kept at some displacement of up to a few millimetres, a third of them violated at x_free = 0.
  void fill_feasible(ConstraintProblem<6>& problem, int rows, double c) {
    problem.set_objective(tool_metric(), Vector6::Zero());
    Vector6 inside;
    for (int j = 0; j < 6; ++j) inside[j] = uniform(-1.0, 1.0) * (j < 3 ? 2e-3 : 2e-2);
    for (int i = 0; i < rows; ++i) {
      const Vector6 J = contact_row(direction(), point());
      problem.add_contact(J, J.dot(inside) - uniform(0.0, 3e-3), c);
    }
  }

  /// A floor below and a wall beside the tool, pressed against with a slight tilt: rows of two near planes.
  void fill_planes(ConstraintProblem<6>& problem, int rows, double c) {
    problem.set_objective(tool_metric(), Vector6::Zero());
    const Vector3 tilt = 1e-3 * direction();
    for (int i = 0; i < rows; ++i) {
      const Vector3 n = (i % 4 == 0 ? Vector3::UnitX() : Vector3::UnitZ()) + Vector3::Zero();
      const Vector3 r = point() - 0.1 * n;
      problem.add_contact(contact_row(n, r), 5e-4 + n.dot(tilt.cross(r)), c);
    }
  }

 private:
  std::mt19937 engine_;
};

}  // namespace tegotae::test
