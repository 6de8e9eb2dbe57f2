// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/device/trajectory.hpp>

#include <span>
#include <string_view>

namespace tegotae {

/// A motion that a simulated hand can be told to make from wherever it is.
struct ScriptedMotion {
  std::string_view name, summary;
  Trajectory (*motion)(const Vector3& up_W);  ///< displacements, as GuidedMotion::play takes them
};

/// All of them, in the order for a list.
std::span<const ScriptedMotion> scripted_motions() noexcept;

/// Throws InputError, with the names, where there is none called `name`.
const ScriptedMotion& find_scripted_motion(std::string_view name);

}  // namespace tegotae
