// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/types.hpp>
#include <tegotae/math/wrench.hpp>

#include <optional>

namespace tegotae {

/// The spring and damper between where the hand holds the tool and where the world lets it be, in the metric that makes
/// translation and rotation commensurable. What is felt depends on the metric: at one contact point at lever arm x from
/// the centre of mass the felt stiffness is k / (1 + x^2 / l^2).
struct Coupling {
  double stiffness = 1000.0;   ///< k, N/m
  double damping = 0.0;        ///< d, N s/m
  double metric_length = 1.0;  ///< l, m: the rotational stiffness is k l^2 (N m/rad), the damping d l^2
  /// N m s/rad, in place of d l^2. A rotational stiffness of one's own is a metric length: sqrt(it / k).
  std::optional<double> rotational_damping = {};

  /// diag(k, k, k, k l^2, k l^2, k l^2): energy of a small displacement [dr; dtheta] is half its square in this matrix.
  Matrix6 stiffness_matrix() const noexcept;

  /// Equations (2) and (3) of the paper, with the rotational stiffness k l^2 in place of k: the wrench on the interface
  /// about the tool's centre of mass for the displacement [dr (m); dtheta (rad)] that frees the tool, `before` being
  /// that of the last tick, `dt` (s) ago. l = 1 m gives the paper's equations literally.
  Wrench wrench(const Vector6& displacement, const Vector6& before, double dt) const noexcept;
};

}  // namespace tegotae
