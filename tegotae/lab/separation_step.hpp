// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/convex_core.hpp>

#include <span>
#include <vector>

namespace tegotae {

/// A plane held between a piece of the tool, above it, and a piece of a body, below.
struct PlanePair {
  const ConvexCore* above = nullptr;  ///< in the world, at the tool's present pose
  const ConvexCore* below = nullptr;
  Vector3 n = Vector3::UnitZ();           ///< unit, from the body to the tool
  double load = 0.0;                      ///< m: pushing force over stiffness
  Vector3 load_moment = Vector3::Zero();  ///< m^2: sum of loads times arms from the centre of mass
  double slack = 0.0;                     ///< m that contradicting walls make the pair give way
};

/// One linearisation of the search for the pose nearest to the hand's.
struct SeparationStepInput {
  Vector3 centre_W = Vector3::Zero();  ///< the tool's centre of mass, m
  Vector6 to_hand = Vector6::Zero();   ///< displacement to the hand's pose: [m; rad]
  double metric_length = 1.0;          ///< m
  double tool_radius = 1.0;            ///< m, of the tool about its centre of mass
  double skin = 0.0;                   ///< m
  double trust = 0.0;                  ///< m: bounds the step
};

struct SeparationStep {
  Vector6 move = Vector6::Zero();  ///< of the tool about its centre of mass: [m; rad]
  double value = 0.0;              ///< m^2: the linearised problem's objective over the stiffness
  bool converged = false;
};

/// Weight of a squared violation against a squared displacement. Under a stretch of 50 mm a wall gives way by 5 nm.
inline constexpr double kViolationWeight = 1e7;

/// Solves for the step of the tool and the turns of all pairs' planes together: to first order in the rows, to second
/// where the loads of the pairs' last step tell the curvature. The move is at most half the trust in each component (m,
/// rad times the tool's radius), so moves no point further than sqrt(3) trust. Updates n, load, load_moment and slack
/// of each pair. Allocates.
SeparationStep separation_step(const SeparationStepInput& input, std::span<PlanePair> pairs);

}  // namespace tegotae
