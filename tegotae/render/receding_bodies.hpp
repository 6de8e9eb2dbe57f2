// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/math/twist.hpp>
#include <tegotae/render/render_types.hpp>

#include <span>

namespace tegotae {

/// m/s. A body whose contact recedes from the tool as fast as this is no longer pushed.
inline constexpr double kRecedingSpeed = 0.5;

/// Pushes less on bodies that already recede from the tool: each moving body's push, and its part of the wrench on the
/// tool, is multiplied by 1 - s / kRecedingSpeed, held between 0 and 1, with s (m/s) the speed at which tool and body
/// part along the push. The law of Hunt and Crossley (1975), damping in proportion to the force, for the way apart: the
/// push begins without a step, never pulls, and returns less work than it took. It makes up for what a push costs that
/// knows the body only as it was a period or two ago.
///
/// `V_WT` is the tool's twist at its centre of mass `p_WCm`, world axes. Does not allocate; linear in bodies.
void yield_to_receding(std::span<const NearBody> near, const Twist& V_WT, const Vector3& p_WCm,
                       RenderOutput& output) noexcept;

}  // namespace tegotae
