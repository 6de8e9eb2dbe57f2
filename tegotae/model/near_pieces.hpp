// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <tegotae/model/intermediate_representation.hpp>
#include <tegotae/model/near_object_search.hpp>

#include <span>

namespace tegotae {

/// Fills `pairs` and `bodies` of `model` from the near pairs, nearest first: what a method that finds contacts itself
/// needs of physics. `states[i]` is the state of moving_index i. Linear in pairs (times near bodies); does not
/// allocate.
void name_near_pieces(const SceneGeometry& geometry, std::span<const NearPair> pairs, std::span<const BodyState> states,
                      IntermediateRepresentation& model) noexcept;

}  // namespace tegotae
