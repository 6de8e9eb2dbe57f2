// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/pose.hpp>
#include <tegotae/model/intermediate_representation.hpp>
#include <tegotae/render/body_wrenches.hpp>

#include <cstdint>

namespace tegotae {

/// What a rendering method is given each tick.
struct RenderInput {
  const IntermediateRepresentation& model;  ///< interpolated to now, unless the method holds it
  Pose X_WT;                                ///< tool, where the hand holds it
  double dt = 1e-3;                         ///< haptic period, s
};

enum class RenderStatus : std::uint8_t {
  kOk,
  kNoModel,         ///< nothing has come from physics yet: no force
  kIterationLimit,  ///< the solver stopped at its bound; the wrench is its best answer
  kInfeasible,      ///< constraints contradict each other; the compromise of least violation is displayed
  kInvalidInput,    ///< pose or model not finite: no force
};

/// "ok", "no-model", ...
const char* name_of(RenderStatus status) noexcept;

/// What a rendering method answers each tick.
struct RenderOutput {
  Wrench wrench;             ///< on the interface, about the tool's centre of mass, world axes
  Pose X_WP;                 ///< where the world lets the tool be (freed pose, proxy)
  BodyWrenches bodies;       ///< the tool's push on the bodies that makes up the elastic part of `wrench`
  int constraint_count = 0;  ///< rows given to the solver
  int active_count = 0;      ///< rows that push
  int solver_iterations = 0;
  int linearisations = 0;  ///< of methods that refresh contacts within a tick
  int skipped_pairs = 0;   ///< pairs, points and rows that capacities or the budget of a tick left out
  double deepest = 0.0;    ///< greatest penetration of a contact point at the interface's pose, m
  /// The tool is inside something and being brought out, as far as the bound on its speed lets it in a tick: the wrench
  /// grows without the hand's doing. Of methods that do so.
  bool pushing_out = false;
  RenderStatus status = RenderStatus::kOk;
};

}  // namespace tegotae
