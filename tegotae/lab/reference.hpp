// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/lab/progress.hpp>
#include <tegotae/lab/session_settings.hpp>
#include <tegotae/math/pose.hpp>
#include <tegotae/math/wrench.hpp>
#include <tegotae/model/scene_geometry.hpp>

#include <functional>
#include <span>
#include <vector>

namespace tegotae {

/// What ought to be felt at one tick.
struct ReferenceSample {
  Wrench wrench;         ///< on the interface, about the tool's centre of mass, world axes
  bool defined = true;   ///< else nothing is known of this tick, and no method is held to it
  bool snaps = false;    ///< the right answer itself leaps here: the tool tips, drops off an edge, slips
  bool touches = false;  ///< something carries the tool
};

/// A motion of the interface whose right answer is sought.
struct ReferenceTask {
  const SceneGeometry& scene;
  std::span<const Pose> X_WT;  ///< of the tool, where the hand holds it, at each tick
  double period = 1e-3;        ///< s from tick to tick
  const SessionSettings& settings;
};

/// The right answer, a sample a tick: a closed form, or the same task solved offline with exact geometry at a fine
/// step. Shares no solver with any method.
using Reference = std::function<std::vector<ReferenceSample>(const ReferenceTask&, const Progress&)>;

}  // namespace tegotae
